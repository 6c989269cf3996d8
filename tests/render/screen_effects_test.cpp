#include <vector>

#include "render/landscape_renderer.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// A wood on one side of a river, seen over the water.
struct RiverStudio : Studio {
  bool make() {
    if (!open(240, 160)) return false;
    const auto snapshot = level_landscape();
    cover(*snapshot, 0, {20, 0, 60, cells}, 0.6F);
    cover(*snapshot, 3, 0.6F);
    snapshot->hydrology = river(62, 66);
    renderer->set_snapshot(snapshot);
    camera.position = {272, 256, 102};
    camera.heading = 270;
    camera.pitch = -6;
    options.quality = 4;
    return true;
  }
};

}  // namespace

TEST_CASE("Smooth edges, shade in corners, mirroring water and shadows can each be left out, and leave the picture as it was") {
  RiverStudio studio;
  if (!studio.make()) return;
  const Image all = studio.draw();
  for (bool LandscapeOptions::*effect : {&LandscapeOptions::smooth_edges, &LandscapeOptions::occlusion,
                                         &LandscapeOptions::reflections, &LandscapeOptions::shadows}) {
    studio.options.*effect = false;
    CHECK(different(all, studio.draw()) > 100);
    studio.options.*effect = true;
    CHECK(different(all, studio.draw(), 0) == 0);
  }
}

TEST_CASE("What is left out at a low quality costs and changes nothing there") {
  RiverStudio studio;
  if (!studio.make()) return;
  studio.options.quality = 0.5F;
  const Image all = studio.draw();
  const int calls = studio.renderer->statistics().draw_calls;
  studio.options.smooth_edges = studio.options.occlusion = studio.options.reflections = studio.options.shadows = false;
  CHECK(different(all, studio.draw(), 0) == 0);
  CHECK(studio.renderer->statistics().draw_calls == calls);
}

TEST_CASE("A picture with effects keeps its depth") {
  RiverStudio studio;
  if (!studio.make()) return;
  const auto depths = [&] {
    (void)studio.draw();
    std::vector<float> out(std::size_t(studio.width) * std::size_t(studio.height));
    glGetTextureImage(studio.target->depth_texture(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, GLsizei(out.size() * sizeof(float)),
                      out.data());
    return out;
  };
  const std::vector<float> with = depths();
  studio.options.smooth_edges = studio.options.occlusion = studio.options.reflections = false;
  CHECK(with == depths());
}

TEST_CASE("Water mirrors the wood behind it") {
  RiverStudio studio;
  if (!studio.make()) return;
  studio.options.quality = 2;
  studio.options.weather.wind = 0;
  const auto green_over_blue = [&] {
    const Image image = studio.draw();
    double green = 0;
    double blue = 0;
    // The lower middle: water.
    for (int y = image.height * 6 / 10; y < image.height * 8 / 10; ++y) {
      for (int x = image.width / 3; x < image.width * 2 / 3; ++x) {
        const std::size_t at = 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
        green += image.rgba[at + 1];
        blue += image.rgba[at + 2];
      }
    }
    return green / blue;
  };
  const double mirrored = green_over_blue();
  studio.options.reflections = false;
  CHECK(mirrored > 1.03 * green_over_blue());
}
