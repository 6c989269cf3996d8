#include <epoxy/gl.h>
#include <catch2/catch.hpp>

#include "render/offscreen_context.hpp"
#include "render/overlay_lines.hpp"
#include "tests/ui/small_landscape.hpp"
#include "ui/landscape_overlay.hpp"

using namespace biotope;

namespace {

constexpr int side = 64;
const glm::vec2 size(side, side);

/// Looks north from the origin.
Camera level_camera() {
  Camera camera;
  camera.position = {0, 0, 0};
  camera.heading = 0;
  camera.pitch = 0;
  camera.vertical_field = 90;
  return camera;
}

/// A line across the picture, 10 m in front.
OverlayLine across() {
  OverlayLine line;
  line.points = {{-9, 10, 0}, {9, 10, 0}};
  line.width = 4;
  line.casing_width = 0;
  return line;
}

std::vector<OverlayVertex> ribbon_of(const OverlayLine& line, float nearest = 0.2F) {
  std::vector<OverlayVertex> vertices;
  add_ribbon(line, level_camera(), size, nearest, vertices);
  return vertices;
}

/// The picture's whole depth at one distance, but for its left half, which is at another.
void fill_depth(const RenderTarget& target, float left, float right, const DepthPicture& depth) {
  target.bind();
  glEnable(GL_SCISSOR_TEST);
  for (const bool is_left : {true, false}) {
    const float distance = is_left ? left : right;
    glScissor(is_left ? 0 : side / 2, 0, side / 2, side);
    glClearDepth(double(depth.far_plane * (distance - depth.near_plane) / (distance * (depth.far_plane - depth.near_plane))));
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
  }
  glDisable(GL_SCISSOR_TEST);
  glClearDepth(1);
}

}  // namespace

TEST_CASE("a ribbon lies around its line and is as wide as it should be") {
  const auto vertices = ribbon_of(across());
  REQUIRE(vertices.size() == 6);
  for (const OverlayVertex& vertex : vertices) {
    // 90 degrees over 64 pixels: 3.2 pixels a metre at 10 m.
    CHECK(vertex.nearness == Approx(0.1));
    CHECK((vertex.pixel.x == Approx(32 - 9 * 3.2) || vertex.pixel.x == Approx(32 + 9 * 3.2)));
    CHECK(std::abs(vertex.pixel.y - 32) == Approx(std::abs(vertex.across)));
    CHECK(vertex.half_width == 2);
  }
}

TEST_CASE("what lies behind the eye is cut off, and what comes out of it goes on from there") {
  OverlayLine line = across();
  line.points = {{0, -5, 0}, {3, -1, 0}};
  CHECK(ribbon_of(line).empty());
  line.points = {{1, -10, 0}, {1, 10, 0}};
  const auto cut = ribbon_of(line, 1);
  REQUIRE(cut.size() == 6);
  for (const OverlayVertex& vertex : cut) {
    CHECK(vertex.nearness <= 1.0001F);
    CHECK(vertex.nearness >= 0.0999F);
  }
  // In front, behind, in front: two pieces.
  line.points = {{-2, 10, 0}, {0, -10, 0}, {2, 10, 0}};
  CHECK(ribbon_of(line, 1).size() == 12);
}

TEST_CASE("a sharp corner is cut, not drawn out to a needle") {
  OverlayLine line = across();
  line.points = {{-5, 10, 0}, {5, 10, 0}, {-5, 10, 0.05}};
  for (const OverlayVertex& vertex : ribbon_of(line)) {
    CHECK(vertex.pixel.x < 32 + 5 * 3.2 + 8);
    CHECK(std::abs(vertex.pixel.y - 32) < 10);
  }
}

TEST_CASE("a line is plain before the ground and faint and dotted behind it") {
  const auto context = OffscreenContext::create();
  REQUIRE(context);
  auto lines = OverlayLines::create();
  if (!lines) FAIL(lines.error().message);
  const RenderTarget scene(side, side);
  const DepthPicture depth{scene.depth_texture(), 0.5F, 1000};
  fill_depth(scene, 5, 100, depth);
  const RenderTarget picture(side, side);
  picture.bind();
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  lines->draw(ribbon_of(across()), depth, size);
  const Image image = picture.read();
  const auto brightness = [&](int x) { return int(image.rgba[(std::size_t(side / 2) * side + std::size_t(x)) * 4]); };
  int faint = 0;
  int gaps = 0;
  for (int x = 6; x < side / 2 - 1; ++x) {
    CHECK(brightness(x) < 140);
    faint += brightness(x) > 60 ? 1 : 0;
    gaps += brightness(x) < 10 ? 1 : 0;
  }
  CHECK(faint > 5);
  CHECK(gaps > 5);
  for (int x = side / 2 + 1; x < side - 6; ++x) CHECK(brightness(x) > 240);
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("a place behind a ridge is hidden, one before it and one on it are not") {
  Terrain terrain;
  terrain.height = Grid<float>(100, 10, 0);
  terrain.cell_size = 10;
  for (int y = 0; y < 10; ++y) terrain.height(50, y) = 100;
  const glm::dvec3 eye(100, 50, 30);
  CHECK_FALSE(hidden_by_ground(terrain, eye, {400, 50, 0.5}));
  CHECK_FALSE(hidden_by_ground(terrain, eye, {505, 50, 100}));
  CHECK(hidden_by_ground(terrain, eye, {800, 50, 0.5}));
}

TEST_CASE("a brush's ring is told to be out of sight when the eye stands amid it and looks ahead") {
  Terrain terrain;
  terrain.height = Grid<float>(400, 400, 0);
  terrain.cell_size = 1;
  Camera camera = level_camera();
  camera.vertical_field = 50;
  camera.position = {200, 200, 60};
  camera.pitch = -80;
  const PathPoint below{200, 200};
  CHECK(ring_in_picture(terrain, camera, size, below, 10));
  CHECK_FALSE(ring_in_picture(terrain, camera, size, below, 150));
}
