// The ring of the brush on the ground of the 3D view.
#include <epoxy/gl.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/frame.hpp"
#include "tests/render/studio.hpp"
#include "tests/views/fixed_views.hpp"
#include "tests/views/sample_maps.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int width = 640;
constexpr int height = 360;

/// Pixels (x right, y down) of points around the circle on the ground.
std::vector<glm::vec2> projected_ring(const Terrain& terrain, const FixedView& view) {
  FrameUniforms frame;
  set_view(frame, view.camera, width, height, 1, 10000);
  const glm::vec3 brush = *view.options.brush;
  const auto cell = float(terrain.cell_size);
  const glm::vec2 middle((brush.x + 0.5F) * cell, (float(terrain.height.height()) - 0.5F - brush.y) * cell);
  std::vector<glm::vec2> ring;
  for (int i = 0; i < 720; ++i) {
    const float angle = float(i) * 0.0087266F;
    const glm::vec2 place = middle + brush.z * cell * glm::vec2(std::cos(angle), std::sin(angle));
    const glm::dvec3 point(place, double(ground_height(terrain, place.x, place.y)));
    const glm::vec4 clip = frame.view_projection * glm::vec4(glm::vec3(point - view.camera.position), 1);
    ring.emplace_back((0.5F + 0.5F * clip.x / clip.w) * width, (0.5F - 0.5F * clip.y / clip.w) * height);
  }
  return ring;
}

/// Whether a pixel lies within a closed line.
bool within(const std::vector<glm::vec2>& line, glm::vec2 p) {
  bool inside = false;
  for (std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
    const bool crosses = (line[i].y > p.y) != (line[j].y > p.y);
    if (crosses && p.x < (line[j].x - line[i].x) * (p.y - line[i].y) / (line[j].y - line[i].y) + line[i].x) inside = !inside;
  }
  return inside;
}

}  // namespace

TEST_CASE("the brush's ring lies on the ground, around its place and nowhere else") {
  const auto valley = sample("valley");
  Studio studio;
  if (!studio.open(width, height)) return;
  studio.renderer->set_snapshot(valley);
  FixedView view = brush_view(*valley);
  studio.camera = view.camera;
  studio.options = view.options;
  for (const bool plants : {true, false}) {
    studio.options.plants = plants;
    studio.options.brush = view.options.brush;
    const Image with = studio.draw();
    studio.options.brush.reset();
    const Image without = studio.draw();
    const std::vector<glm::vec2> ring = projected_ring(valley->terrain(), view);
    int near = 0;
    int elsewhere = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t at = 4 * (std::size_t(y) * width + std::size_t(x));
        int apart = 0;
        for (std::size_t c = 0; c < 3; ++c) apart += std::abs(int(with.rgba[at + c]) - int(without.rgba[at + c]));
        if (apart < 12) continue;
        const glm::vec2 pixel(float(x) + 0.5F, float(y) + 0.5F);
        const bool on = std::any_of(ring.begin(), ring.end(), [&](glm::vec2 p) { return glm::length(p - pixel) < 6; });
        // Within the ring the ground is a little tinted.
        near += on && apart > 40 ? 1 : 0;
        elsewhere += on || within(ring, pixel) ? 0 : 1;
      }
    }
    INFO("plants " << plants << " near " << near << " elsewhere " << elsewhere);
    // Bare ground shows all of it; trees hide some.
    CHECK(near >= (plants ? 150 : 500));
    CHECK(elsewhere <= near / 20);
  }
}
