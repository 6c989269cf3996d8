#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// A slope that falls south with a round bowl of this depth and radius (m) sunk into a level terrace.
Terrain bowl(double depth, double radius, double cell = 10) {
  return ground(61, 61, cell, [=](double x, double y) {
    const double middle = 30 * cell;
    const double away = std::hypot(x - middle, y - middle);
    const double terrace = y > middle - 15 * cell ? 50 + 0.05 * std::max(0.0, y - middle - 15 * cell) : 50 - 0.1 * (middle - 15 * cell - y);
    return away < radius ? terrace - depth * (1 - away * away / (radius * radius)) : terrace;
  });
}

std::ptrdiff_t count(const Hydrology& water, WaterKind kind) { return std::count(water.water.cells().begin(), water.water.cells().end(), kind); }

}  // namespace

TEST_CASE("a bowl is a lake up to its spill level") {
  const Terrain terrain = bowl(8, 100);
  const Hydrology water = water_of(terrain);
  CHECK(water.water(30, 30) == WaterKind::lake);
  CHECK(water.water_depth(30, 30) == Approx(8).epsilon(1e-3));
  CHECK(water.filled(30, 30) == Approx(50));
  CHECK(water.water_depth(30, 35) == Approx(6).epsilon(1e-3));
  CHECK(double(count(water, WaterKind::lake)) * 100 == Approx(3.14159 * 100 * 100).epsilon(0.05));
  CHECK(water.water(30, 45) == WaterKind::dry);
}

TEST_CASE("hollows that are shallow or small are noise, not lakes") {
  CHECK(count(water_of(bowl(0.45, 100)), WaterKind::lake) == 0);
  CHECK(count(water_of(bowl(0.6, 100)), WaterKind::lake) > 0);
  CHECK(count(water_of(bowl(8, 25)), WaterKind::lake) == 0);
  CHECK(count(water_of(bowl(8, 60)), WaterKind::lake) > 0);
}

TEST_CASE("noise in the heights makes no lakes") {
  Terrain plane = ground(200, 200, 10, [](double x, double y) { return 100 + 0.02 * x + 0.01 * y; });
  for (std::size_t i = 0; i < plane.height.size(); ++i) plane.height[i] += float(0.4 * random_unit({4, i}));
  CHECK(count(water_of(plane), WaterKind::lake) == 0);
}

TEST_CASE("a lake passes all it receives on to the stream that leaves it") {
  Terrain terrain = bowl(8, 100);
  for (int y = 38; y < 61; ++y) terrain.height(30, y) -= 0.3F;
  HydrologyOptions options;
  options.channel_discharge = 0.0005;
  options.inflows = {{30, 10, 1e6}};
  const Hydrology water = water_of(terrain, options);
  CHECK(water.filled(30, 30) == Approx(49.7));
  const auto offsets = neighbour_offsets(61);
  int outlets = 0;
  float received = 0;
  for (std::size_t i = 0; i < water.water.size(); ++i) {
    if (water.receiver[i] == leaves_map) continue;
    const std::size_t next = i + std::size_t(offsets[water.receiver[i]]);
    const bool here = water.water[i] == WaterKind::lake;
    const bool there = water.water[next] == WaterKind::lake;
    if (here) CHECK(water.discharge[i] == 0);
    if (!here && there) received += water.discharge[i];
    if (!here || there) continue;
    ++outlets;
    CHECK(next == terrain.height.index(30, 40));
  }
  CHECK(outlets >= 1);
  CHECK(received >= mean_discharge(1e6, options.runoff));
  CHECK(water.discharge(30, 41) > received);
}

TEST_CASE("the sea is what lies below its level and reaches the border") {
  // A shore along x = 300 m; a hollow below sea level inland, and a bay behind a sill.
  Terrain coast = ground(60, 40, 10, [](double x, double) { return (x - 305) * 0.1; });
  for (int y = 10; y < 14; ++y) {
    for (int x = 45; x < 50; ++x) coast.height(x, y) = -5;
  }
  const Hydrology water = water_of(coast);
  for (int y = 0; y < 40; ++y) {
    CHECK(water.water(5, y) == WaterKind::sea);
    CHECK(water.water_depth(5, y) == Approx(25.5));
    CHECK(water.filled(5, y) == 0);
    CHECK(water.water(30, y) == WaterKind::sea);
    CHECK(water.water(31, y) != WaterKind::sea);
  }
  CHECK(water.water(47, 12) == WaterKind::dry);
  CHECK(water.filled(47, 12) > 0);
}

TEST_CASE("the sea enters a bay through a strait one corner wide, but not over dry land") {
  Grid<float> heights(7, 5, 3.0F);
  heights(0, 2) = -1;
  heights(1, 1) = -1;
  heights(2, 2) = -1;
  heights(4, 2) = -1;
  const Grid<std::uint8_t> sea = find_sea(heights, 0);
  CHECK(sea(2, 2) == 1);
  CHECK(sea(4, 2) == 0);
  CHECK(find_sea(heights, -2).empty());
  CHECK(find_sea(heights, 10)(4, 2) == 1);
}

TEST_CASE("rivers run into the sea, and no river is drawn on it") {
  const Terrain coast = rough_ground(150, 150, 20, 12, 0);
  const Hydrology water = water_of(coast);
  REQUIRE(count(water, WaterKind::sea) > 1000);
  for (std::size_t i = 0; i < water.water.size(); ++i) {
    if (water.water[i] != WaterKind::sea) continue;
    REQUIRE(water.discharge[i] == 0);
    REQUIRE(water.receiver[i] == leaves_map);
    REQUIRE(water.water_depth[i] == -coast.height[i]);
  }
}
