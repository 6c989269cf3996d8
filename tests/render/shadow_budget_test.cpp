// Squares of the shadow maps that must be drawn anew: a window draws some a frame, a picture for a file all.
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

struct ShadowedWood : Studio {
  std::shared_ptr<MapsSnapshot> snapshot = level_landscape();
  bool make() {
    if (!open(160, 120)) return false;
    cover(*snapshot, 0, 0.3F);
    cover(*snapshot, 2, 0.1F);
    options.quality = 2;
    options.weather = {0, 0, 0, 0};
    options.hour = 8;
    camera.position = {200, 150, 101.7};
    camera.pitch = -6;
    renderer->set_snapshot(snapshot);
    return true;
  }
  /// A frame of a window.
  Image frame() {
    (void)renderer->bring_in(options);
    target->bind();
    renderer->draw(camera, options, width, height);
    return target->read();
  }
  /// What a renderer draws that has drawn nothing before.
  Image fresh() {
    auto made = LandscapeRenderer::create();
    REQUIRE(made);
    std::swap(renderer, *made);
    renderer->set_snapshot(snapshot);
    Image picture = draw();
    std::swap(renderer, *made);
    return picture;
  }
};

}  // namespace

TEST_CASE("Where the light moves on a window's frames draw two of the three squares each, and come to the picture of all") {
  ShadowedWood wood;
  if (!wood.make()) return;
  (void)wood.draw();
  CHECK(wood.renderer->complete());
  wood.options.hour = 9.5;
  (void)wood.frame();
  CHECK_FALSE(wood.renderer->complete());
  // It says that there is more to see.
  CHECK(wood.renderer->bring_in(wood.options));
  const Image second = wood.frame();
  CHECK(wood.renderer->complete());
  CHECK(different(second, wood.fresh(), 0) == 0);
}

TEST_CASE("While the light moves in every frame no square is forgotten") {
  ShadowedWood wood;
  if (!wood.make()) return;
  (void)wood.draw();
  for (int step = 0; step < 12; ++step) {
    wood.options.hour += 0.05;
    wood.camera.position.y += 3;
    (void)wood.frame();
  }
  // Those that were put off are at most two frames old: as soon as the light stands still one frame brings the last of them.
  Image last = wood.frame();
  for (int frames = 0; !wood.renderer->complete() && frames < 200; ++frames) last = wood.frame();
  CHECK(wood.renderer->complete());
  CHECK(different(last, wood.fresh(), 0) == 0);
}

TEST_CASE("A picture for a file waits for all squares, whatever a window left undone") {
  ShadowedWood wood;
  if (!wood.make()) return;
  (void)wood.draw();
  wood.options.hour = 15;
  wood.camera.heading = 200;
  (void)wood.frame();
  REQUIRE_FALSE(wood.renderer->complete());
  const Image written = wood.draw();
  CHECK(wood.renderer->complete());
  CHECK(different(written, wood.fresh(), 0) == 0);
}
