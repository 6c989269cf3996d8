#include <catch2/catch.hpp>

#include <cmath>

#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// A river of this discharge (m3/s) down a valley 3 km long, whose bed is by turns gentle and steep every 150 m.
Hydrology valley_river(double discharge, double bank_slope) {
  const Terrain valley = ground(81, 600, 5, [=](double x, double y) {
    const double beside = std::abs(x - 200);
    return 100 + 0.01 * y + 0.25 * std::sin(y / 150 * 6.283185) + bank_slope * std::max(0.0, beside - 4) + 0.002 * beside;
  });
  HydrologyOptions options;
  options.inflows = {{40, 0, discharge * 365.25 * 86400 / options.runoff}};
  return water_of(valley, options);
}

}  // namespace

TEST_CASE("a middling river has fords: shallow, in the channel, at least 200 m apart") {
  const Hydrology water = valley_river(3, 0.1);
  REQUIRE(water.fords.size() >= 5);
  CHECK(water.fords.size() <= 15);
  for (std::size_t i = 0; i < water.fords.size(); ++i) {
    const Ford& ford = water.fords[i];
    CHECK(water.water(ford.x, ford.y) == WaterKind::river);
    CHECK(water.discharge(ford.x, ford.y) > 0);
    CHECK(ford.depth == water.water_depth(ford.x, ford.y));
    CHECK(ford.depth <= 0.45F);
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(std::hypot(ford.x - water.fords[j].x, ford.y - water.fords[j].y) * 5 >= 200);
    }
  }
}

TEST_CASE("a ford is the shallowest place of its stretch") {
  const Hydrology water = valley_river(3, 0.1);
  for (const Ford& ford : water.fords) {
    for (int y = std::max(0, ford.y - 10); y < std::min(600, ford.y + 10); ++y) {
      if (water.discharge(ford.x, y) > 1) CHECK(water.water_depth(ford.x, y) >= ford.depth);
    }
  }
}

TEST_CASE("there is no ford between cliffs") { CHECK(valley_river(3, 2).fords.empty()); }

TEST_CASE("there is no ford through a deep river") { CHECK(valley_river(80, 0.1).fords.empty()); }

TEST_CASE("a brook that one steps over needs no ford") { CHECK(valley_river(0.3, 0.1).fords.empty()); }
