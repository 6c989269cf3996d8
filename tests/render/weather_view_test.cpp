#include <epoxy/gl.h>

#include <algorithm>
#include <cstdlib>

#include "render/fall_renderer.hpp"
#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "tests/render/sample_plants.hpp"
#include "tests/render/studio.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int picture_width = 160;
constexpr int picture_height = 100;

/// A view without plants and animals.
struct Scene : Studio {
  bool make(std::shared_ptr<const MapsSnapshot> snapshot) {
    if (!open(picture_width, picture_height)) return false;
    renderer->set_snapshot(std::move(snapshot));
    options.plants = false;
    options.animals = false;
    options.quality = 1;
    options.weather.cloud = 0;
    camera.position = {256, 120, 130};
    camera.pitch = -30;
    return true;
  }
};

/// Brightness (0..255) of every pixel, darkest first.
std::vector<int> brightness(const Image& image) {
  std::vector<int> values;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    values.push_back((image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2]) / 3);
  std::sort(values.begin(), values.end());
  return values;
}
double mean(const Image& image) {
  double sum = 0;
  for (const int value : brightness(image)) sum += value;
  return sum / double(image.rgba.size() / 4);
}
/// Distance between the brightest and the darkest tenth.
int contrast(const Image& image) {
  const std::vector<int> values = brightness(image);
  return values[values.size() * 9 / 10] - values[values.size() / 10];
}
/// Share of pixels that are white or nearly so.
double white_share(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const auto [low, high] = std::minmax({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    count += low > 165 && high - low < 35 ? 1 : 0;
  }
  return count / double(image.rgba.size() / 4);
}

std::shared_ptr<MapsSnapshot> bare_landscape() {
  auto snapshot = level_landscape();
  snapshot->web = nullptr;
  snapshot->cover.clear();
  snapshot->document.climate.temperature_mean.fill(15);
  return snapshot;
}

/// A slope of 26 degrees from 500 m in the south to 2500 m in the north, in a climate that freezes at 1000 m in January and at
/// 4000 m in July.
std::shared_ptr<MapsSnapshot> mountain_slope() {
  auto snapshot = bare_landscape();
  auto terrain = std::make_shared<Terrain>();
  terrain->height = Grid<float>(cells, cells);
  terrain->cell_size = 32;
  terrain->latitude = 45;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) terrain->height(x, y) = 500 + 2000 * float(cells - 1 - y) / float(cells - 1);
  }
  snapshot->document.terrain = terrain;
  Climate& climate = snapshot->document.climate;
  climate.temperature_mean = {6.5, 6.5, 10, 13, 17, 22, 26, 25, 20, 15, 10, 7};
  climate.precipitation.fill(80);
  return snapshot;
}

}  // namespace

TEST_CASE("night is dark but readable") {
  const auto snapshot = mountain_slope();
  Scene scene;
  if (!scene.make(snapshot)) return;
  scene.camera = overview(*snapshot);
  scene.options.hour = 12;
  const Image noon = scene.draw();
  for (const double hour : {0.0, 5.0, 22.0}) {
    for (const int month : {0, 8}) {
      scene.options.hour = hour;
      scene.options.month = month;
      const Image night = scene.draw();
      INFO("month " << month << ", " << hour << " h");
      // In January snow lies in moonlight.
      CHECK(mean(night) < (month == 0 ? 0.85 : 0.5) * mean(noon));
      CHECK(mean(night) > 10);
      CHECK(contrast(night) > 8);
    }
  }
}

TEST_CASE("the snow line comes down in winter, and snow can be hidden") {
  const auto snapshot = mountain_slope();
  Scene scene;
  if (!scene.make(snapshot)) return;
  // Straight down on the slope.
  scene.camera.position = {2048, 2048, 5500};
  scene.camera.pitch = -89;
  scene.options.hour = 12;
  const auto white_in = [&](int month) {
    scene.options.month = month;
    return white_share(scene.draw());
  };
  const double january = white_in(0);
  const double april = white_in(3);
  const double july = white_in(6);
  CHECK(january > april + 0.1);
  CHECK(april > july + 0.1);
  CHECK(july < 0.02);
  scene.options.weather.snow_cover = false;
  CHECK(white_in(0) < 0.02);
}

TEST_CASE("rain darkens the ground and stands in the air") {
  Scene scene;
  if (!scene.make(bare_landscape())) return;
  scene.camera.pitch = -60;
  scene.options.month = 6;
  scene.options.weather.cloud = 1;
  scene.options.weather.fog = 0.1F;
  const Image dry = scene.draw();
  scene.options.weather.precipitation = 0.6F;
  const Image wet = scene.draw();
  CHECK(mean(wet) < 0.93 * mean(dry));
  // The same moment is the same picture; a moment later every drop is elsewhere.
  CHECK(different(wet, scene.draw()) == 0);
  scene.options.seconds = 0.37;
  CHECK(different(wet, scene.draw()) > 20);
  CHECK(falling_count({1, 0}, 1) == 0);
  CHECK(falling_count({1, 1}, 1) > falling_count({1, 0.3F}, 1));
  CHECK(falling_count({1, 1}, 0.5F) < falling_count({1, 1}, 2));
}

TEST_CASE("water moves with time, and stands still when time does") {
  auto snapshot = bare_landscape();
  snapshot->hydrology = river(56, 72);
  Scene scene;
  if (!scene.make(snapshot)) return;
  scene.camera.position = {256, 200, 102};
  scene.camera.pitch = -20;
  for (const float quality : {0.5F, 1.0F}) {
    scene.options.quality = quality;
    scene.options.seconds = 0;
    const Image first = scene.draw();
    CHECK(different(first, scene.draw()) == 0);
    scene.options.seconds = 1;
    CHECK(different(first, scene.draw()) > 100);
    // Nothing else moves.
    scene.options.water = false;
    const Image dry = scene.draw();
    scene.options.seconds = 2;
    CHECK(different(dry, scene.draw()) == 0);
    scene.options.water = true;
  }
}

TEST_CASE("low over a deep lake its water is seen down to the picture's lower edge") {
  auto snapshot = bare_landscape();
  auto lake = std::make_shared<Hydrology>(*river(0, 0));
  lake->reaches.clear();
  lake->water_depth = Grid<float>(cells, cells, 80);
  lake->water = Grid<WaterKind>(cells, cells, WaterKind::lake);
  snapshot->hydrology = lake;
  CHECK(height_above_surface(*snapshot, {256, 256, 182}) == Approx(2));
  Scene scene;
  if (!scene.make(snapshot)) return;
  scene.camera.position = {256, 256, 182};
  scene.camera.pitch = -10;
  const auto lowest_rows = [&](double seconds) {
    scene.options.seconds = seconds;
    Image image = scene.draw();
    image.rgba.erase(image.rgba.begin(), image.rgba.begin() + std::ptrdiff_t(picture_width) * (picture_height - 12) * 4);
    image.height = 12;
    return image;
  };
  // Only what is there moves.
  CHECK(different(lowest_rows(0), lowest_rows(1)) > 100);
}

TEST_CASE("clouds drift, and their shadows with them") {
  const auto snapshot = mountain_slope();
  Scene scene;
  if (!scene.make(snapshot)) return;
  scene.options.month = 6;
  scene.options.weather.cloud = 0.45F;
  scene.options.weather.wind = 10;
  scene.camera.position = {2048, 2048, 5500};
  scene.camera.pitch = -89;
  const Image before = scene.draw();
  scene.options.seconds = 60;
  CHECK(different(before, scene.draw()) > 500);
  scene.options.weather.cloud = 0;
  const Image clear = scene.draw();
  scene.options.seconds = 120;
  CHECK(different(clear, scene.draw()) == 0);
}

TEST_CASE("fog hides what is far") {
  const auto snapshot = mountain_slope();
  Scene scene;
  if (!scene.make(snapshot)) return;
  scene.camera.position = {2048, 200, 620};
  scene.camera.pitch = 10;
  const Image clear = scene.draw();
  scene.options.weather.fog = 1;
  CHECK(contrast(scene.draw()) < 0.35 * contrast(clear));
}

TEST_CASE("every weather at every time of day draws without an OpenGL error, at every quality") {
  const auto snapshot = mountain_slope();
  Scene scene;
  if (!scene.make(snapshot)) return;
  for (const std::string_view name : {"clear", "fair", "overcast", "rain", "fog", "storm"}) {
    const auto weather = weather_named(name);
    REQUIRE(weather);
    scene.options.weather = *weather;
    for (const double hour : {1.0, 6.0, 12.0, 19.5}) {
      scene.options.hour = hour;
      scene.options.quality = hour < 10 ? 0.5F : 2.0F;
      scene.options.month = hour < 10 ? 0 : 6;
      const Image picture = scene.draw();
      INFO(name << " at " << hour);
      CHECK(mean(picture) > 8);
    }
  }
}
