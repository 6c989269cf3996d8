// The same view by different ways is the same picture.
#include "tests/render/studio.hpp"
#include "tests/views/sample_maps.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int width = 480;
constexpr int height = 270;

Camera high_view(const MapsSnapshot& maps, double x) {
  Camera camera;
  camera.position = {x, 1500, 420};
  camera.position.z = std::max(camera.position.z, double(ground_height(maps.terrain(), x, 1500)) + 120);
  camera.heading = 270;
  camera.pitch = -30;
  return camera;
}

/// Frames as a window draws them, until nothing is missing any more.
Image settle(Studio& studio) {
  for (int frame = 0; frame < 400; ++frame) {
    studio.target->bind();
    studio.renderer->draw(studio.camera, studio.options, width, height);
    if (studio.renderer->complete()) break;
  }
  CHECK(studio.renderer->complete());
  studio.target->bind();
  studio.renderer->draw(studio.camera, studio.options, width, height);
  return studio.target->read();
}

}  // namespace

TEST_CASE("a high view is the same from a fresh camera, along a path, and after looking elsewhere") {
  const auto valley = sample("valley");
  LandscapeOptions options;
  options.hour = 8;
  options.quality = 1;
  Image expected;
  {
    Studio fresh;
    if (!fresh.open(width, height)) return;
    fresh.options = options;
    fresh.renderer->set_snapshot(valley);
    fresh.camera = high_view(*valley, 2000);
    expected = fresh.draw();
  }

  Studio moved;
  REQUIRE(moved.open(width, height));
  moved.options = options;
  moved.renderer->set_snapshot(valley);
  for (double x = 1300; x <= 2000; x += 50) {
    moved.camera = high_view(*valley, x);
    (void)moved.draw();
  }
  CHECK(different(settle(moved), expected, 0) == 0);

  // From the ground, another hour and season, and from far above.
  moved.camera.position = {2600, 1900, double(ground_height(valley->terrain(), 2600, 1900)) + 2};
  moved.camera.heading = 40;
  moved.options.month = 9;
  (void)moved.draw();
  moved.camera.position = {900, 900, 2600};
  (void)moved.draw();
  moved.options.month = options.month;
  moved.camera = high_view(*valley, 2000);
  CHECK(different(moved.draw(), expected, 0) == 0);
}
