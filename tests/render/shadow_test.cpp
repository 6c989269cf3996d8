#include <cmath>
#include <numbers>
#include <optional>

#include "render/daylight.hpp"
#include "render/plant_placement.hpp"
#include "render/shadow_map.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

std::vector<PlantInstance> trees_of(const std::shared_ptr<MapsSnapshot>& snapshot) {
  const PlantPlacement placement(snapshot);
  std::vector<PlantInstance> all;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      for (const PlantInstance& tree : placement.block(Stratum::tree, column, row)) all.push_back(tree);
    }
  }
  return all;
}

/// Level ground with a single pine, far from the border.
struct LonePine {
  std::shared_ptr<MapsSnapshot> snapshot;
  PlantInstance tree;
};
LonePine lone_pine() {
  for (std::uint64_t seed = 1; seed < 200; ++seed) {
    auto snapshot = level_landscape();
    snapshot->document.seed = seed;
    cover(*snapshot, 1, {62, 62, 66, 66}, 0.15F);
    const auto trees = trees_of(snapshot);
    if (trees.size() == 1) return {snapshot, trees.front()};
  }
  FAIL("no seed gives one tree");
  return {};
}

int luminance(const Image& image, int x, int y) {
  const std::size_t at = 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  return image.rgba[at] + image.rgba[at + 1] + image.rgba[at + 2];
}

/// How far shadows reach from a tree's foot along a direction on the ground, in a picture from straight above; m.
struct Reach {
  double along = 0;
  double against = 0;
  int darker = 0;  ///< pixels
};

struct ShadowStudio : Studio {
  static constexpr double up = 90;
  bool make(float quality) {
    if (!open(240, 240)) return false;
    options.quality = quality;
    options.weather = {0, 0, 0, 0};
    options.hour = 8;
    return true;
  }
  void look_down_at(const PlantInstance& tree) {
    camera.position = {double(tree.x), double(tree.y), 100 + up};
    camera.heading = 0;
    camera.pitch = -90;
  }
  [[nodiscard]] double metres_a_pixel() const {
    return 2 * up * std::tan(0.5 * double(camera.vertical_field) * std::numbers::pi / 180) / height;
  }
  /// Where the ground is darker than it is without plants.
  Reach reach(const PlantInstance&, const glm::vec3& light) {
    const Image with = draw();
    LandscapeOptions before = options;
    options.plants = false;
    const Image without = draw();
    options = before;
    const glm::dvec2 away = -glm::normalize(glm::dvec2(light));
    Reach out;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (luminance(with, x, y) > 0.80 * luminance(without, x, y)) continue;
        const glm::dvec2 at = metres_a_pixel() * glm::dvec2(x + 0.5 - 0.5 * width, 0.5 * height - y - 0.5);
        // What lies beside its line is no shadow of this tree; what lies under it is the tree.
        if (std::abs(at.x * away.y - at.y * away.x) > 5) continue;
        const double along = glm::dot(at, away);
        out.along = std::max(out.along, along);
        out.against = std::max(out.against, -along);
        if (along > 6) ++out.darker;
      }
    }
    return out;
  }
};

}  // namespace

TEST_CASE("The squares that light sees move in whole texels and do not turn with the camera") {
  Camera camera;
  camera.position = {1234.5, 987.25, 110};
  const glm::vec3 light = glm::normalize(glm::vec3(0.4F, -0.6F, 0.5F));
  const ShadowView before = shadow_view(camera, 2, light, 1);
  camera.position += glm::dvec3(0.777, -0.333, 0);
  camera.heading += 0.3F;
  const ShadowView after = shadow_view(camera, 2, light, 1);
  const ShadowLight& of = after.cascades[0].light;
  CHECK(before.cascades[0].light == of);
  CHECK(glm::dot(of.right, of.up) == Approx(0).margin(1e-6));
  CHECK(glm::dot(of.up, of.toward) == Approx(0).margin(1e-6));
  const glm::dvec3 moved(0.777, -0.333, 0);
  for (std::size_t i = 0; i < shadow_cascades; ++i) {
    const double texel = 2.0 * double(after.cascades[i].half_side) / shadow_texels;
    // In the frame of the land, not of the eye.
    const double shift = double(after.cascades[i].centre.x - before.cascades[i].centre.x) + glm::dot(glm::dvec3(of.right), moved);
    CHECK(shift / texel == Approx(std::round(shift / texel)).margin(0.02));
    CHECK(after.cascades[i].half_side == before.cascades[i].half_side);
    if (i > 0) CHECK(after.cascades[i].half_side > after.cascades[i - 1].half_side);
  }
}

TEST_CASE("A tree throws its shadow into a square from however far toward the light it stands") {
  Camera camera;
  camera.position = {500, 500, 102};
  const glm::vec3 light = glm::normalize(glm::vec3(1, 0, 0.2F));
  const ShadowView view = shadow_view(camera, 2, light, 1);
  const glm::vec3 on_ground(10, 0, -2);
  CHECK(casts_into(view, 0, on_ground, 1));
  CHECK(casts_into(view, 0, on_ground + 300.0F * light, 1));
  CHECK_FALSE(casts_into(view, 0, on_ground + glm::vec3(0, 400, 0), 5));
}

TEST_CASE("A tree's shadow falls away from the sun, as long as its height over the tangent of the sun's height") {
  const float quality = GENERATE(0.5F, 2.0F);
  CAPTURE(quality);
  ShadowStudio studio;
  if (!studio.make(quality)) return;
  const LonePine pine = lone_pine();
  studio.renderer->set_snapshot(pine.snapshot);
  studio.look_down_at(pine.tree);
  for (const double hour : {7.5, 16.0}) {
    studio.options.hour = hour;
    const Daylight light = biotope::daylight(pine.snapshot->terrain().latitude, studio.options.month, hour);
    const double tangent =
        double(light.light_direction.z) / std::hypot(double(light.light_direction.x), double(light.light_direction.y));
    // A pine of this landscape is 17 m high at scale 1, and each stands a little higher or lower.
    const double length = 17 * double(pine.tree.scale) / tangent;
    const Reach reach = studio.reach(pine.tree, light.light_direction);
    CAPTURE(hour, length, pine.tree.scale);
    CHECK(reach.along > 0.72 * length);
    CHECK(reach.along < 1.25 * length + 2);
    CHECK(reach.against < 7);
  }
}

TEST_CASE("Under closed clouds and without a light trees throw no shadow") {
  const float quality = GENERATE(0.5F, 2.0F);
  CAPTURE(quality);
  ShadowStudio studio;
  if (!studio.make(quality)) return;
  const LonePine pine = lone_pine();
  studio.renderer->set_snapshot(pine.snapshot);
  studio.look_down_at(pine.tree);
  const double latitude = pine.snapshot->terrain().latitude;
  const glm::vec3 light = biotope::daylight(latitude, studio.options.month, studio.options.hour).light_direction;
  CHECK(studio.reach(pine.tree, light).darker > 20);
  studio.options.weather = {1, 0, 0, 0};
  CHECK(studio.reach(pine.tree, light).darker < 5);
}

TEST_CASE("The light has a side by day and under the moon, none at dusk and without a moon") {
  CHECK(biotope::daylight(45, 5, 12).shadows == Approx(1));
  CHECK(under(biotope::daylight(45, 5, 12), {1, 0, 0, 0}).shadows < 0.05F);
  float most = 0;
  float least = 1;
  for (int month = 0; month < 12; ++month) {
    for (double hour = 0; hour < 24; hour += 0.5) {
      const Daylight light = biotope::daylight(45, month, hour);
      CHECK(light.shadows >= 0);
      CHECK(light.shadows <= 1);
      if (light.night < 1) continue;
      most = std::max(most, light.shadows);
      least = std::min(least, light.shadows);
    }
  }
  CHECK(most > 0.5F);
  CHECK(least < 0.05F);
}

TEST_CASE("The floor of a wood lies in the shade of its crowns, at every quality") {
  const float quality = GENERATE(0.5F, 1.0F, 2.0F);
  CAPTURE(quality);
  ShadowStudio studio;
  if (!studio.make(quality)) return;
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, {0, 0, cells, 64}, 0.9F);
  studio.renderer->set_snapshot(snapshot);
  studio.options.hour = 12;
  // At the height of the eyes, down at the floor: in the wood (the north), and on the meadow.
  const auto floor_light = [&](double y) {
    studio.camera.position = {256, y, 101.7};
    studio.camera.pitch = -55;
    const Image picture = studio.draw();
    double sum = 0;
    for (int row = picture.height / 2; row < picture.height; ++row) {
      for (int x = 0; x < picture.width; ++x) sum += luminance(picture, x, row);
    }
    return sum;
  };
  CHECK(floor_light(400) < 0.72 * floor_light(60));
}

TEST_CASE("A square stays the same while the eye is within a cell of the land, and the light hardly moves") {
  Camera camera;
  camera.position = {1234.5, 987.25, 110};
  const glm::vec3 light = glm::normalize(glm::vec3(0.4F, -0.6F, 0.5F));
  int moves = 0;
  ShadowView before = shadow_view(camera, 2, light, 1);
  for (int step = 0; step < 100; ++step) {
    camera.position += glm::dvec3(0.1, 0.05, 0.01);
    const ShadowView after = shadow_view(camera, 2, light + glm::vec3(1e-6F * float(step)), 1);
    const ShadowLight& of = after.cascades[0].light;
    REQUIRE(of == before.cascades[0].light);
    for (std::size_t i = 0; i < shadow_cascades; ++i) {
      const bool same = after.cascades[i].origin == before.cascades[i].origin;
      moves += same ? 0 : 1;
      if (same) CHECK(after.cascades[i].from_origin == before.cascades[i].from_origin);
      // It is where it was on the land, and holds what lies ahead.
      const glm::vec2 from_eye = glm::vec2(after.cascades[i].from_origin) +
                                 glm::vec2(glm::dot(of.right, after.cascades[i].origin - glm::vec3(camera.position)),
                                           glm::dot(of.up, after.cascades[i].origin - glm::vec3(camera.position)));
      CHECK(glm::distance(from_eye, after.cascades[i].centre) < 1e-3F);
      CHECK(casts_into(after, int(i), glm::vec3(0, 0, -2), 0));
    }
    before = after;
  }
  // 11 m, through cells of 8.5, 35 and 140 m, along three axes.
  CHECK(moves > 0);
  CHECK(moves < 9);
}

namespace {

/// Whether a renderer that has drawn other pictures before draws the same one as a new renderer.
bool as_if_new(ShadowStudio& studio, const std::shared_ptr<MapsSnapshot>& snapshot) {
  const Image kept = studio.draw();
  auto made = LandscapeRenderer::create();
  REQUIRE(made);
  std::swap(studio.renderer, *made);
  studio.renderer->set_snapshot(snapshot);
  const Image anew = studio.draw();
  std::swap(studio.renderer, *made);
  return different(kept, anew, 0) == 0;
}

}  // namespace

TEST_CASE("Shadows that are kept are those that would be drawn afresh") {
  ShadowStudio studio;
  if (!studio.make(2)) return;
  auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  cover(*snapshot, 2, 0.1F);
  studio.renderer->set_snapshot(snapshot);
  studio.camera.position = {200, 150, 101.7};
  studio.camera.pitch = -6;
  for (int step = 0; step < 24; ++step) {
    studio.camera.position += glm::dvec3(0.4, 0.9, 0);
    studio.camera.heading += 1.5F;
    (void)studio.draw();
  }
  CHECK(as_if_new(studio, snapshot));
  studio.options.seconds = 1.3;
  CHECK(as_if_new(studio, snapshot));
  studio.options.weather.wind = 12;
  CHECK(as_if_new(studio, snapshot));
  studio.options.hour = 9.2;
  CHECK(as_if_new(studio, snapshot));
  studio.options.month = 0;
  CHECK(as_if_new(studio, snapshot));
  studio.options.visible_species = {false};
  CHECK(as_if_new(studio, snapshot));
  auto edited = std::make_shared<MapsSnapshot>(*snapshot);
  cover(*edited, 2, {0, 0, cells, 70}, 0);
  studio.renderer->set_snapshot(edited);
  CHECK(as_if_new(studio, edited));
}

TEST_CASE("While one walks shadows are drawn again only now and then, and at rest not at all") {
  ShadowStudio studio;
  if (!studio.make(2)) return;
  auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  studio.renderer->set_snapshot(snapshot);
  studio.camera.position = {200, 150, 101.7};
  studio.options.weather.wind = 0;
  const auto calls = [&](bool shadows) {
    studio.options.shadows = shadows;
    (void)studio.draw();
    return studio.renderer->statistics().draw_calls;
  };
  CHECK(calls(true) > calls(false));
  CHECK(calls(true) == calls(false));
  int again = 0;
  for (int step = 0; step < 30; ++step) {
    studio.camera.position.y += 0.15;
    again += calls(true) > calls(false) ? 1 : 0;
  }
  CHECK(again < 6);
}
