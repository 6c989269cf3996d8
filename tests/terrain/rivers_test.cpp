#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/terrain/neighbours.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr double seconds_per_year = 365.25 * 86400;

/// Catchment that brings a mean discharge at the default runoff, m2.
double catchment_of(double discharge) { return discharge * seconds_per_year / HydrologyOptions{}.runoff; }

/// A valley with a flat floor that falls gently south, 101 cells wide.
Terrain floored_valley(double cell, int rows, double floor, double side_slope = 0.5) {
  const double middle = 50 * cell;
  return ground(101, rows, cell, [=](double x, double y) {
    const double beside = std::abs(x - middle);
    return 100 + 0.005 * y + 0.001 * beside + side_slope * std::max(0.0, beside - floor / 2);
  });
}

/// Rows of the map that a channel of at least this discharge crosses.
int rows_crossed(const Hydrology& water, float discharge) {
  int rows = 0;
  for (int y = 0; y < water.discharge.height(); ++y) {
    const auto row = water.discharge.row(y);
    rows += std::any_of(row.begin(), row.end(), [=](float q) { return q >= discharge; }) ? 1 : 0;
  }
  return rows;
}

}  // namespace

TEST_CASE("a square kilometre with a metre of runoff yields 32 litres a second") {
  CHECK(mean_discharge(1e6, 1) == Approx(0.0317).epsilon(0.001));
  CHECK(mean_discharge(1e6, 0) == 0);
}

TEST_CASE("rivers widen with the square root of their discharge and deepen more slowly") {
  CHECK(river_width(0) == 0);
  CHECK(river_width(1) == Approx(4.5));
  CHECK(river_width(4) == Approx(9));
  CHECK(river_depth(0) == 0);
  CHECK(river_depth(1) == Approx(0.3));
  CHECK(river_depth(32) == Approx(1.2));
}

TEST_CASE("a channel begins where its discharge suffices and only grows downstream") {
  const Terrain valley = floored_valley(10, 80, 0);
  HydrologyOptions options;
  options.channel_discharge = 0.001;
  const Hydrology water = water_of(valley, options);
  const auto offsets = neighbour_offsets(101);
  int channels = 0;
  for (std::size_t i = 0; i < water.discharge.size(); ++i) {
    const float here = water.discharge[i];
    if (here <= 0) continue;
    ++channels;
    REQUIRE(here >= 0.001F);
    if (water.receiver[i] != leaves_map) REQUIRE(water.discharge[i + std::size_t(offsets[water.receiver[i]])] > here);
  }
  // Each row of 101 cells adds 0.000096 m3/s: it takes eleven rows.
  CHECK(channels == 70);
  const float most = *std::max_element(water.discharge.cells().begin(), water.discharge.cells().end());
  CHECK(most == Approx(mean_discharge(101 * 80 * 100.0, options.runoff)).epsilon(0.05));
}

TEST_CASE("a river that enters at the border runs from there to the outlet") {
  const Terrain valley = floored_valley(10, 120, 60);
  HydrologyOptions options;
  options.inflows = {{50, 0, catchment_of(5)}};
  const Hydrology water = water_of(valley, options);
  CHECK(water.discharge(50, 0) == Approx(5).epsilon(0.01));
  CHECK(rows_crossed(water, 5) == 120);
  CHECK(water.water(50, 0) == WaterKind::river);
}

TEST_CASE("a river does not fall out of the map through the border beside its entry") {
  // The ground falls inward, but the first rows are rough: the entry lies in a hollow of the border.
  Terrain valley = floored_valley(10, 120, 60);
  SECTION("its own cell is a pit") { valley.height(50, 0) -= 1; }
  SECTION("the next cell is a pit") { valley.height(51, 0) -= 1.5F; }
  SECTION("a low ledge along the border") {
    for (int x = 49; x < 52; ++x) valley.height(x, 0) -= 0.4F;
  }
  SECTION("the first rows are level") {
    for (int y = 0; y < 6; ++y) {
      for (int x = 47; x < 54; ++x) valley.height(x, y) = valley.height(50, 6);
    }
  }
  HydrologyOptions options;
  options.inflows = {{50, 0, catchment_of(5)}};
  const Hydrology water = water_of(valley, options);
  CHECK(water.receiver(50, 0) != leaves_map);
  CHECK(rows_crossed(water, 5) == 120);
}

TEST_CASE("an entry in every row and column still lets the water out") {
  const Terrain plain = ground(3, 3, 10, [](double, double) { return 5.0; });
  HydrologyOptions options;
  options.inflows = {{0, 0, 1e6}, {2, 2, 1e6}, {2, 0, 1e6}, {0, 2, 1e6}};
  const Hydrology water = water_of(plain, options);
  for (const float level : water.filled.cells()) CHECK(level == 5);
}

TEST_CASE("an entry outside the terrain is refused with its place") {
  const Terrain plain = ground(8, 6, 10, [](double x, double) { return x; });
  HydrologyOptions options;
  options.inflows = {{8, 2, 1e6}};
  const auto water = compute_hydrology(plain, options);
  REQUIRE_FALSE(water);
  CHECK_THAT(water.error().message, Catch::Contains("(8, 2)"));
}

TEST_CASE("a wide river covers the cells beside its channel, deepest in the middle") {
  const Terrain valley = floored_valley(5, 100, 120);
  HydrologyOptions options;
  options.inflows = {{50, 0, catchment_of(79)}};  // 40 m wide, 1.7 m deep
  const Hydrology water = water_of(valley, options);
  for (int y = 5; y < 95; ++y) {
    int wet = 0;
    for (int x = 0; x < 101; ++x) wet += water.water(x, y) == WaterKind::river ? 1 : 0;
    REQUIRE(wet * 5 == Approx(40).margin(10));
    REQUIRE(water.water_depth(50, y) >= water.water_depth(52, y));
    REQUIRE(water.water_depth(52, y) > 0);
  }
  CHECK(water.water_depth(50, 50) == Approx(river_depth(79)).epsilon(0.2));
}

TEST_CASE("a wide river does not climb the cliffs of its gorge") {
  const Terrain gorge = floored_valley(5, 100, 15, 4);
  HydrologyOptions options;
  options.inflows = {{50, 0, catchment_of(79)}};
  const Hydrology water = water_of(gorge, options);
  for (int y = 5; y < 95; ++y) {
    CHECK(water.water(50, y) == WaterKind::river);
    CHECK(water.water(54, y) == WaterKind::dry);
    CHECK(water.water(46, y) == WaterKind::dry);
  }
}

TEST_CASE("a brook much narrower than a cell leaves its cell dry but is known by its discharge") {
  const Terrain valley = floored_valley(30, 60, 150);
  HydrologyOptions options;
  options.inflows = {{50, 0, catchment_of(1)}};  // 4.5 m wide
  const Hydrology water = water_of(valley, options);
  CHECK(rows_crossed(water, 1) == 60);
  for (const WaterKind kind : water.water.cells()) CHECK(kind == WaterKind::dry);
}

TEST_CASE("reaches run downstream cell by cell, meet only at junctions and cover every channel") {
  const Terrain hills = rough_ground(200, 180, 20, 3);
  HydrologyOptions options;
  options.channel_discharge = 0.0005;
  const Hydrology water = water_of(hills, options);
  REQUIRE(water.reaches.size() > 10);
  const auto offsets = neighbour_offsets(200);
  std::multiset<std::uint32_t> inner;
  std::set<std::uint32_t> all;
  for (const RiverReach& reach : water.reaches) {
    REQUIRE_FALSE(reach.cells.empty());
    for (std::size_t i = 0; i + 1 < reach.cells.size(); ++i) {
      REQUIRE(reach.cells[i] + std::size_t(offsets[water.receiver[reach.cells[i]]]) == reach.cells[i + 1]);
      inner.insert(reach.cells[i]);
    }
    all.insert(reach.cells.begin(), reach.cells.end());
    CHECK(reach.discharge >= 0.0005F);
    CHECK(reach.width == river_width(reach.discharge));
    CHECK(reach.depth == river_depth(reach.discharge));
  }
  CHECK(std::set<std::uint32_t>(inner.begin(), inner.end()).size() == inner.size());
  std::size_t channels = 0;
  for (const float q : water.discharge.cells()) channels += q > 0 ? 1U : 0U;
  CHECK(all.size() == channels);
}

TEST_CASE("two streams that join make three reaches, and the third carries both") {
  // A Y: two valleys lead into one.
  const Terrain fork = ground(81, 81, 10, [](double x, double y) {
    const double apart = std::max(0.0, (y - 400) * 0.5);
    return 50 + 0.05 * y + 0.4 * std::min(std::abs(x - 400 - apart), std::abs(x - 400 + apart));
  });
  HydrologyOptions options;
  options.channel_discharge = 0.05;
  options.inflows = {{60, 0, catchment_of(1)}, {20, 0, catchment_of(2)}};
  const Hydrology water = water_of(fork, options);
  REQUIRE(water.reaches.size() == 3);
  std::vector<float> discharges;
  for (const RiverReach& reach : water.reaches) discharges.push_back(reach.discharge);
  std::sort(discharges.begin(), discharges.end());
  CHECK(discharges[0] == Approx(1).epsilon(0.02));
  CHECK(discharges[1] == Approx(2).epsilon(0.02));
  CHECK(discharges[2] == Approx(3).epsilon(0.02));
}
