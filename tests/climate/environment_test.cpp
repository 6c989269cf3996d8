// Environment maps: calibration of the indices, moisture, soil, and that they do not depend on the number of threads.
#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "core/base/random.hpp"
#include "core/climate/environment.hpp"
#include "core/climate/moisture.hpp"
#include "core/climate/soil.hpp"
#include "core/climate/diffusion.hpp"

namespace biotope {
namespace {

using HeightFunction = std::function<double(double east, double south)>;

Terrain terrain_of(int width, int height, double cell_size, const HeightFunction& function) {
  Terrain terrain;
  terrain.cell_size = cell_size;
  terrain.height = Grid<float>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) terrain.height(x, y) = float(function((x + 0.5) * cell_size, (y + 0.5) * cell_size));
  }
  return terrain;
}

/// Ground on which every cell drains `catchment` m2, dry and without channels.
Hydrology even_hydrology(const Terrain& terrain, float catchment) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Hydrology hydrology;
  hydrology.filled = terrain.height;
  hydrology.catchment_area = Grid<float>(width, height, catchment);
  hydrology.water_depth = Grid<float>(width, height);
  hydrology.discharge = Grid<float>(width, height);
  hydrology.water = Grid<WaterKind>(width, height, WaterKind::dry);
  return hydrology;
}

/// A river down the columns around x metres from the western edge, a cell wide, that drains 20 km2.
void add_river(const Terrain& terrain, Hydrology& hydrology, double x_metres) {
  const int x = int(x_metres / terrain.cell_size);
  for (int y = 0; y < terrain.height.height(); ++y) {
    hydrology.catchment_area(x, y) = 2e7F;
    hydrology.discharge(x, y) = 0.2F;
  }
}

Grid<float> moisture_of(const Terrain& terrain, const Hydrology& hydrology) {
  const auto layer = moisture_layer(terrain, compute_derivatives(terrain), hydrology);
  REQUIRE(layer);
  return *layer;
}

Climate even_climate(double temperature, double precipitation) {
  Climate climate;
  climate.temperature_mean.fill(temperature);
  climate.precipitation.fill(precipitation);
  return climate;
}

EnvironmentMaps environment_of(const Terrain& terrain, const Hydrology& hydrology, const Climate& climate) {
  auto maps = compute_environment(terrain, compute_derivatives(terrain), hydrology, climate);
  REQUIRE(maps);
  return *maps;
}

/// A valley along the y axis: slopes of `slope` on both sides of x = middle, falling gently to the south.
Terrain v_valley(int cells, double cell_size, double slope) {
  const double middle = cells * cell_size / 2;
  return terrain_of(cells, cells, cell_size,
                    [=](double east, double south) { return 500 + slope * std::abs(east - middle) - 0.01 * south; });
}

TEST_CASE("temperature index: -15 deg C is 1, 25 deg C is 9, and it falls 6.5 deg C a kilometre") {
  const Terrain terrain = terrain_of(4, 1, 1000, [](double east, double) { return east - 500; });
  const Hydrology hydrology = even_hydrology(terrain, 1e6F);
  Climate climate = even_climate(5, 50);
  climate.temperature_mean[0] = -15;
  climate.temperature_mean[6] = 25;
  climate.temperature_mean[7] = 40;
  climate.reference_height = 1000;
  const EnvironmentMaps maps = environment_of(terrain, hydrology, climate);
  const MonthlyMap& temperature = maps.map(Resource::temperature);
  REQUIRE(terrain.height(1, 0) == 1000);
  CHECK(temperature.value(0, 1, 0) == Approx(1));
  CHECK(temperature.value(6, 1, 0) == Approx(9));
  CHECK(temperature.value(7, 1, 0) == 9);
  CHECK(temperature.value(1, 1, 0) == Approx(5));
  CHECK(temperature.value(1, 2, 0) == Approx(5 - 6.5 / 5));
  CHECK(temperature.value(1, 0, 0) == Approx(5 + 6.5 / 5));
  CHECK(temperature.value(0, 3, 0) == 1);
}

TEST_CASE("illumination index: a ratio of 0.01 is 1 and of 0.25 is 9, and clouds dim it") {
  const Terrain terrain = terrain_of(8, 8, 10, [](double, double) { return 100; });
  const Hydrology hydrology = even_hydrology(terrain, 100);
  Climate climate = even_climate(10, 50);
  const EnvironmentMaps clear = environment_of(terrain, hydrology, climate);
  climate.cloud[5] = 0.5;
  const EnvironmentMaps cloudy = environment_of(terrain, hydrology, climate);
  const MonthlyMap& light = clear.map(Resource::illumination);
  REQUIRE(light.layers.size() == 12);
  CHECK(light.value(5, 4, 4) == 9);
  CHECK(light.value(11, 4, 4) < light.value(2, 4, 4));
  const double clear_ratio = illumination_scale.physical(light.layer(5)(4, 4));
  const double cloudy_ratio = illumination_scale.physical(cloudy.map(Resource::illumination).layer(5)(4, 4));
  CHECK(cloudy_ratio == Approx(clear_ratio / 2));
  CHECK(cloudy.map(Resource::illumination).layer(6) == light.layer(6));
}

TEST_CASE("moisture of even ground is the authors' formula on an absolute scale") {
  const Terrain terrain = terrain_of(16, 16, 5, [](double east, double) { return 0.25 * east; });
  const Hydrology hydrology = even_hydrology(terrain, 500);
  const EnvironmentMaps maps = environment_of(terrain, hydrology, even_climate(10, std::exp(4.0)));
  // a = 500 / 5 = 100 m, water = (100 / (0.1 + 0.5))^(2/3), index 1 + 8 (ln water + 4 - 5) / 10.
  const double expected = 1 + 0.8 * (2.0 / 3 * std::log(100 / 0.6) - 1);
  CHECK(maps.map(Resource::moisture).value(3, 8, 8) == Approx(expected).epsilon(1e-4));
}

TEST_CASE("rain moves the moisture index by 0.8 per factor e, and a dry month counts half a millimetre") {
  CHECK(moisture_offset(1) == 0);
  CHECK(moisture_offset(std::exp(1.0)) == Approx(0.8));
  CHECK(moisture_offset(0) == Approx(0.8 * std::log(0.5)));
}

TEST_CASE("water spreads without being lost and without going below zero") {
  Grid<float> water(41, 33, 1);
  Grid<float> conductance(41, 33, 3);
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 41; ++x) {
      water(x, y) = float(std::exp(12 * random_unit({7, std::uint64_t(x), std::uint64_t(y)})));
      conductance(x, y) = float(40 * random_unit({8, std::uint64_t(x), std::uint64_t(y)}));
    }
  }
  const auto total = [](const Grid<float>& grid) {
    double sum = 0;
    for (const float cell : grid.cells()) sum += cell;
    return sum;
  };
  const double before = total(water);
  const float highest = *std::ranges::max_element(water.cells());
  for (int step = 0; step < 4; ++step) diffuse(water, conductance);
  CHECK(total(water) == Approx(before).epsilon(1e-4));
  CHECK(*std::ranges::min_element(water.cells()) > 0);
  CHECK(*std::ranges::max_element(water.cells()) < highest);
}

TEST_CASE("a spot spreads by the square root of twice the conductance, alike along rows and columns") {
  Grid<float> water(101, 101, 0);
  water(50, 50) = 1000;
  const Grid<float> conductance(101, 101, 4.5F);
  for (int step = 0; step < 4; ++step) diffuse(water, conductance);
  double sum = 0;
  double east = 0;
  double south = 0;
  for (int y = 0; y < 101; ++y) {
    for (int x = 0; x < 101; ++x) {
      sum += water(x, y);
      east += double(water(x, y)) * (x - 50) * (x - 50);
      south += double(water(x, y)) * (y - 50) * (y - 50);
    }
  }
  // Each implicit step adds 2 x 4.5 to the variance along each axis.
  CHECK(east / sum == Approx(36).epsilon(0.01));
  CHECK(south / sum == Approx(36).epsilon(0.01));
  CHECK(water(57, 57) == Approx(water(60, 50)).epsilon(0.4));
}

TEST_CASE("a cell that keeps its water gives without losing") {
  Grid<float> water(9, 1, 1);
  Grid<float> conductance(9, 1, 2);
  water(4, 0) = 100;
  conductance(4, 0) = -2;
  diffuse(water, conductance);
  CHECK(water(4, 0) == 100);
  CHECK(water(3, 0) > 10);
  CHECK(water(3, 0) == Approx(water(5, 0)).epsilon(1e-5));
  CHECK(water(2, 0) < water(3, 0));
}

TEST_CASE("the bottom of a V-shaped valley is wetter than its sides, and its sides wetter than its crests") {
  const Terrain terrain = v_valley(96, 10, 0.3);
  const auto hydrology = compute_hydrology(terrain, {});
  REQUIRE(hydrology);
  const Grid<float> moisture = moisture_of(terrain, *hydrology);
  CHECK(moisture(47, 80) > moisture(30, 80) + 2);
  CHECK(moisture(30, 80) > moisture(2, 80) + 1);
  CHECK(moisture(47, 90) > moisture(47, 20));
}

TEST_CASE("a river wets a strip along its banks that is as wide on fine cells as on coarse ones") {
  std::vector<double> widths;
  std::vector<double> bank;
  for (const double cell_size : {2.0, 4.0, 8.0}) {
    const int width = int(640 / cell_size);
    const Terrain terrain = terrain_of(width, 24, cell_size, [](double, double) { return 10; });
    // Hillslope water is that of 100 m of slope above, whatever the cell.
    Hydrology hydrology = even_hydrology(terrain, float(100 * cell_size));
    add_river(terrain, hydrology, 320);
    const Grid<float> moisture = moisture_of(terrain, hydrology);
    const float dry = moisture(1, 12);
    int wet = 0;
    for (int x = 0; x < width; ++x) wet += moisture(x, 12) > dry + 1 ? 1 : 0;
    widths.push_back(wet * cell_size);
    bank.push_back(moisture(int(344 / cell_size), 12));
  }
  CHECK(widths[1] > 60);
  CHECK(widths[1] < 300);
  CHECK(widths[0] == Approx(widths[1]).margin(16));
  CHECK(widths[2] == Approx(widths[1]).margin(16));
  CHECK(bank[0] == Approx(bank[1]).margin(0.35));
  CHECK(bank[2] == Approx(bank[1]).margin(0.35));
}

TEST_CASE("steep banks keep the water in: the strip is narrower than on a plain") {
  const Terrain plain = terrain_of(160, 8, 4, [](double, double) { return 10; });
  const Terrain gorge = terrain_of(160, 8, 4, [](double east, double) { return 0.7 * std::abs(east - 322); });
  const auto strip = [](const Terrain& terrain) {
    Hydrology hydrology = even_hydrology(terrain, 100);
    const Grid<float> without = moisture_of(terrain, hydrology);
    add_river(terrain, hydrology, 322);
    const Grid<float> with = moisture_of(terrain, hydrology);
    int cells = 0;
    for (int x = 0; x < 160; ++x) cells += with(x, 4) > without(x, 4) + 1 ? 1 : 0;
    return cells;
  };
  CHECK(strip(gorge) < strip(plain) / 2);
}

TEST_CASE("moisture is absolute: a flood in one corner changes nothing in the others") {
  const Terrain terrain = terrain_of(256, 256, 8, [](double east, double south) { return 0.05 * (east + south); });
  Hydrology hydrology = even_hydrology(terrain, 800);
  const Grid<float> before = moisture_of(terrain, hydrology);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      hydrology.catchment_area(x, y) = 3e8F;
      hydrology.discharge(x, y) = 3;
    }
  }
  const Grid<float> after = moisture_of(terrain, hydrology);
  CHECK(after(8, 8) > before(8, 8) + 5);
  for (const auto& [x, y] : {std::pair{250, 250}, {250, 5}, {5, 250}, {128, 128}}) CHECK(after(x, y) == before(x, y));
}

TEST_CASE("open water is as wet as the index goes in every month, and lakes wet their shore") {
  const Terrain terrain = terrain_of(96, 96, 5, [](double, double) { return 10; });
  Hydrology hydrology = even_hydrology(terrain, 25);
  for (int y = 30; y < 60; ++y) {
    for (int x = 30; x < 60; ++x) hydrology.water(x, y) = WaterKind::lake;
  }
  Climate climate = even_climate(10, 80);
  climate.precipitation[7] = 0;
  const EnvironmentMaps maps = environment_of(terrain, hydrology, climate);
  const MonthlyMap& moisture = maps.map(Resource::moisture);
  CHECK(moisture.value(7, 45, 45) == 9);
  CHECK(moisture.value(0, 62, 45) > 6);
  CHECK(moisture.value(0, 5, 5) < 4);
  CHECK((*maps.geology)(45, 45) == Geology::water);
  CHECK((*maps.geology)(62, 45) == Geology::alluvium);
}

TEST_CASE("ordinary ground is loam, cliffs are stony, wet flats are fine") {
  const auto texture = [](double slope, float catchment) {
    const Terrain terrain = terrain_of(12, 12, 5, [=](double east, double) { return slope * east; });
    const Hydrology hydrology = even_hydrology(terrain, catchment);
    const SoilMaps soil = estimate_soil(terrain, compute_derivatives(terrain), hydrology, moisture_of(terrain, hydrology));
    return soil.texture(6, 6);
  };
  CHECK(texture(0.3, 500) == Approx(3.5));
  CHECK(texture(0.6, 500) < 4);
  CHECK(texture(1.5, 500) == Approx(8));
  CHECK(texture(0.01, 1e7F) == Approx(2.2).margin(0.05));
}

TEST_CASE("geology follows slope, hollows and water") {
  const auto geology = [](double slope, double hollow, float catchment) {
    const Terrain terrain =
        terrain_of(12, 12, 5, [=](double east, double) { return slope * east + hollow / 2 * (east - 32) * (east - 32); });
    const Hydrology hydrology = even_hydrology(terrain, catchment);
    const SoilMaps soil = estimate_soil(terrain, compute_derivatives(terrain), hydrology, moisture_of(terrain, hydrology));
    return soil.geology(6, 6);
  };
  CHECK(geology(0.01, 0, 1e6F) == Geology::alluvium);
  CHECK(geology(0.1, 0, 2000) == Geology::marl);
  CHECK(geology(0.1, 0, 50) == Geology::limestone);
  CHECK(geology(0.8, 0.01, 500) == Geology::scree);
  CHECK(geology(0.8, -0.01, 500) == Geology::limestone);
  CHECK(geology(2, 0.01, 500) == Geology::limestone);
}

TEST_CASE("one thread and many make the same environment to the bit") {
  const Terrain terrain = terrain_of(150, 130, 6, [](double east, double south) {
    return 300 + 60 * std::sin(east / 70) * std::cos(south / 90) + 0.05 * south;
  });
  const auto hydrology = compute_hydrology(terrain, {});
  REQUIRE(hydrology);
  const auto compute = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return environment_of(terrain, *hydrology, even_climate(12, 60));
  };
  const EnvironmentMaps one = compute(1);
  const EnvironmentMaps many = compute(4);
  for (std::size_t resource = 0; resource < one.monthly.size(); ++resource) {
    REQUIRE(one.monthly[resource].layers.size() == many.monthly[resource].layers.size());
    for (std::size_t layer = 0; layer < one.monthly[resource].layers.size(); ++layer) {
      CHECK(*one.monthly[resource].layers[layer] == *many.monthly[resource].layers[layer]);
    }
  }
  CHECK(*one.texture == *many.texture);
  CHECK(*one.geology == *many.geology);
}

TEST_CASE("a stopped computation returns nothing") {
  const Terrain terrain = v_valley(32, 10, 0.3);
  const Hydrology hydrology = even_hydrology(terrain, 100);
  std::stop_source source;
  source.request_stop();
  TaskContext context;
  context.stop = source.get_token();
  CHECK_FALSE(compute_environment(terrain, compute_derivatives(terrain), hydrology, even_climate(10, 50), context));
}

TEST_CASE("a terrain of one cell has an environment") {
  const Terrain terrain = terrain_of(1, 1, 10, [](double, double) { return 5; });
  const EnvironmentMaps maps = environment_of(terrain, even_hydrology(terrain, 100), even_climate(10, 50));
  CHECK(maps.map(Resource::moisture).value(0, 0, 0) >= 1);
  CHECK((*maps.texture)(0, 0) == Approx(3.5));
}

}  // namespace
}  // namespace biotope
