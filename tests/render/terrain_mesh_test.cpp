// The ground's patches: no cracks where levels of detail meet, and nothing missing below the horizon.
#include "render/terrain_mesh.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "render/camera.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

Grid<float> hills(int side) {
  Grid<float> surface(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x)
      surface(x, y) = 300 + 120 * std::sin(float(x) / 31) * std::cos(float(y) / 23) + 9 * std::sin(float(x) / 3);
  }
  return surface;
}

float height_at(const Grid<float>& surface, double cell, glm::vec2 place) {
  // As the texture is read: mirrored beyond the border.
  return sample_bilinear(surface, double(place.x) / cell - 0.5, surface.height() - double(place.y) / cell - 0.5);
}

/// Where a vertex of a patch is drawn: the sums of terrain.vert.
glm::vec2 drawn_place(const GroundPatch& patch, int cells_a_side, int column, int row, const glm::dvec3& eye,
                      const Grid<float>& surface, double cell) {
  const auto slide = [&](glm::vec2 at, float end) {
    const float to_eye = glm::length(glm::vec3(glm::dvec3(at, double(height_at(surface, cell, at))) - eye));
    return std::clamp((to_eye / end - 0.7F) / 0.28F, 0.0F, 1.0F);
  };
  const glm::vec2 corner = glm::vec2(float(column), float(row)) / float(cells_a_side);
  const glm::vec2 west_south(patch.west, patch.south);
  const glm::vec2 odd = glm::vec2(float(column % 2), float(row % 2)) / float(cells_a_side);
  const glm::vec2 coarse_odd = glm::vec2(float(column / 2 % 2), float(row / 2 % 2)) * 2.0F / float(cells_a_side);
  glm::vec2 slid = corner - odd * slide(west_south + corner * patch.side, patch.morph_end);
  slid -= coarse_odd * slide(west_south + slid * patch.side, 2 * patch.morph_end);
  return west_south + slid * patch.side;
}

using Point = std::pair<long, long>;  // millimetres
Point key(glm::vec2 place) { return {std::lround(double(place.x) * 1000), std::lround(double(place.y) * 1000)}; }

/// The different places of the vertices along a patch's side: 0 west, 1 east, 2 south, 3 north.
std::vector<Point> side_of(const GroundPatch& patch, int cells_a_side, int side, const glm::dvec3& eye,
                           const Grid<float>& surface, double cell) {
  std::vector<Point> out;
  for (int i = 0; i <= cells_a_side; ++i) {
    const int column = side == 0 ? 0 : side == 1 ? cells_a_side : i;
    const int row = side == 2 ? 0 : side == 3 ? cells_a_side : i;
    out.push_back(key(drawn_place(patch, cells_a_side, column, row, eye, surface, cell)));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

bool close(double a, double b) { return std::abs(a - b) < 0.01; }

}  // namespace

TEST_CASE("where patches of the ground meet, the vertices of both sides are the same") {
  constexpr int side = 512;
  constexpr double cell = 4;
  const Grid<float> surface = hills(side);
  PatchSettings settings;
  settings.width = settings.height = side * cell;
  const HeightBounds bounds(surface, cell, settings.patch_cells);
  settings.finest_side = settings.patch_cells * cell;
  std::mt19937 random(3);
  int meetings = 0;
  int across_levels = 0;
  int apart = 0;
  for (int round = 0; round < 12; ++round) {
    settings.range_factor = 3.0F + float(round % 4) * 2;
    Camera camera;
    const double x = double(random() % 2048);
    const double y = double(random() % 2048);
    const double above = round % 3 == 0 ? 2 : round % 3 == 1 ? 60 : 500;
    camera.position = {x, y, double(height_at(surface, cell, {x, y})) + above};
    camera.heading = float(random() % 360);
    camera.pitch = round % 2 == 0 ? -5.0F : -40.0F;
    camera.vertical_field = 110;
    FrameUniforms frame;
    set_view(frame, camera, 160, 90, 0.5F, 20000);
    const auto patches = select_patches(settings, bounds, camera.position, Frustum(frame.view_projection));
    REQUIRE(patches.size() > 4);
    for (const GroundPatch& a : patches) {
      for (const GroundPatch& b : patches) {
        const bool beside = close(a.west + a.side, b.west);
        const bool over = close(a.south + a.side, b.south);
        const bool shares_rows = a.south < b.south + b.side - 0.01F && b.south < a.south + a.side - 0.01F;
        const bool shares_columns = a.west < b.west + b.side - 0.01F && b.west < a.west + a.side - 0.01F;
        if (!(beside && shares_rows) && !(over && shares_columns)) continue;
        // Only on the ground itself: beyond the border it is mirrored.
        if (std::min(a.west, b.west) < 0 || std::min(a.south, b.south) < 0) continue;
        if (std::max(a.west + a.side, b.west + b.side) > settings.width ||
            std::max(a.south + a.side, b.south + b.side) > settings.height)
          continue;
        auto mine = side_of(a, settings.patch_cells, beside && shares_rows ? 1 : 3, camera.position, surface, cell);
        auto its = side_of(b, settings.patch_cells, beside && shares_rows ? 0 : 2, camera.position, surface, cell);
        // The part of the side that both have.
        const Point low = std::max(mine.front(), its.front());
        const Point high = std::min(mine.back(), its.back());
        const auto outside = [&](const Point& p) { return p < low || high < p; };
        std::erase_if(mine, outside);
        std::erase_if(its, outside);
        apart += mine == its ? 0 : 1;
        ++meetings;
        across_levels += a.side != b.side ? 1 : 0;
      }
    }
  }
  CHECK(apart == 0);
  CHECK(meetings > 500);
  CHECK(across_levels > 60);
}

TEST_CASE("below the horizon there is ground everywhere") {
  constexpr int width = 160;
  constexpr int height = 90;
  Studio studio;
  if (!studio.open(width, height)) return;
  const auto snapshot = level_landscape();
  auto terrain = std::make_shared<Terrain>(snapshot->terrain());
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) terrain->height(x, y) = 100 + 40 * std::sin(float(x) / 5) * std::cos(float(y) / 7);
  }
  snapshot->document.terrain = terrain;
  studio.renderer->set_snapshot(snapshot);
  studio.options.plants = false;
  std::vector<float> depth(std::size_t(width) * height);
  for (const double above : {2.0, 20.0, 150.0}) {
    for (const float heading : {0.0F, 75.0F, 200.0F, 310.0F}) {
      studio.camera.position = {256, 256, double(ground_height(*terrain, 256, 256)) + above};
      studio.camera.heading = heading;
      studio.camera.pitch = -46;
      (void)studio.draw();
      glGetTextureImage(studio.target->depth_texture(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, GLsizei(depth.size() * sizeof(float)),
                        depth.data());
      INFO("above " << above << " heading " << heading);
      CHECK(std::count_if(depth.begin(), depth.end(), [](float d) { return d >= 1; }) == 0);
    }
  }
}
