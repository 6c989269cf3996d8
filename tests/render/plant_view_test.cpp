// What one sees of plants: wind, seasons, levels of detail and the wood painted on the ground.

#include <epoxy/gl.h>

#include <cstdlib>

#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int picture_width = 192;
constexpr int picture_height = 128;

struct PlantStudio : Studio {
  bool make() {
    if (!open(picture_width, picture_height)) return false;
    camera.position = {256, 60, 106};
    options.quality = 0.5F;
    options.weather.cloud = 0;
    return true;
  }
};

std::shared_ptr<MapsSnapshot> wood(float oaks, float grass) {
  auto snapshot = level_landscape();
  cover(*snapshot, 0, oaks);
  cover(*snapshot, 3, grass);
  return snapshot;
}

/// Mean of each colour over the middle of a picture.
std::array<double, 3> middle(const Image& image) {
  std::array<double, 3> sum{};
  double count = 0;
  for (int y = picture_height / 4; y < picture_height * 3 / 4; ++y) {
    for (int x = picture_width / 4; x < picture_width * 3 / 4; ++x, ++count) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += image.rgba[std::size_t(4 * (y * picture_width + x)) + c];
    }
  }
  for (double& value : sum) value /= count;
  return sum;
}

}  // namespace

TEST_CASE("in a calm plants are still; wind moves them, and a second always shows the same") {
  PlantStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wood(0.2F, 0.7F));
  studio.options.weather.wind = 0;
  const Image calm = studio.draw();
  studio.options.seconds = 7.3;
  CHECK(different(calm, studio.draw()) == 0);
  studio.options.weather.wind = 9;
  const Image blown = studio.draw();
  CHECK(different(calm, blown) > 200);
  studio.options.seconds = 8.1;
  CHECK(different(blown, studio.draw()) > 200);
  studio.options.seconds = 7.3;
  CHECK(different(blown, studio.draw()) == 0);
}

TEST_CASE("a wood painted on the ground has the colour of its trees drawn one by one") {
  PlantStudio studio;
  if (!studio.make()) return;
  // So high that at a low quality all trees are painted and at the highest all are drawn.
  studio.camera.position = {256, 256, 2100};
  studio.camera.pitch = -90;
  studio.camera.vertical_field = 8;
  for (const float oaks : {0.3F, 0.7F}) {
    for (const int month : {5, 9}) {
      INFO("cover " << oaks << " month " << month);
      studio.renderer->set_snapshot(wood(oaks, 0.4F));
      studio.options.month = month;
      studio.options.quality = 0.5F;
      const auto painted = middle(studio.draw());
      CHECK(studio.renderer->statistics().plants == 0);
      studio.options.quality = 4;
      const auto drawn = middle(studio.draw());
      CHECK(studio.renderer->statistics().plants > 500);
      const double light = (drawn[0] + drawn[1] + drawn[2]) / (painted[0] + painted[1] + painted[2]);
      CHECK(light == Approx(1).margin(0.1));
      CHECK(drawn[1] / drawn[0] == Approx(painted[1] / painted[0]).epsilon(0.08));
    }
  }
}

TEST_CASE("leaves fall: a wood in January shows more of the sky than in June") {
  PlantStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wood(0.5F, 0));
  studio.camera.position = {256, 60, 102};
  studio.camera.pitch = 35;
  const auto blue = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i + 2] > image.rgba[i + 1] ? 1 : 0;
    return count;
  };
  studio.options.month = 5;
  const int summer = blue(studio.draw());
  studio.options.month = 0;
  CHECK(blue(studio.draw()) > summer + 500);
}

TEST_CASE("a higher quality draws more plants, and memory of instances is told and bounded") {
  PlantStudio studio;
  if (!studio.make()) return;
  studio.renderer->set_snapshot(wood(0.5F, 0.8F));
  std::size_t before = 0;
  for (const float quality : {0.25F, 0.5F, 1.0F, 2.0F}) {
    studio.options.quality = quality;
    (void)studio.draw();
    const LandscapeStatistics& statistics = studio.renderer->statistics();
    CHECK(statistics.plants > before);
    before = statistics.plants;
    CHECK(statistics.instance_bytes > 0);
    CHECK(statistics.instance_bytes < std::size_t(64) << 20U);
  }
}
