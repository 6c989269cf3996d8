#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <cmath>
#include <stop_token>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/sun.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Runs the whole floor and checks what holds for any ground.
void check_sane(const Terrain& terrain) {
  const Derivatives derivatives = compute_derivatives(terrain);
  const Hydrology water = water_of(terrain);
  std::uint64_t left = 0;
  const Grid<std::uint32_t> upstream = upstream_cells(water.receiver);
  for (std::size_t i = 0; i < water.filled.size(); ++i) {
    REQUIRE(std::isfinite(derivatives.slope[i]));
    REQUIRE(std::isfinite(water.filled[i]));
    REQUIRE(std::isfinite(water.catchment_area[i]));
    REQUIRE(std::isfinite(water.water_depth[i]));
    REQUIRE(water.water_depth[i] >= 0);
    REQUIRE((water.water_depth[i] > 0) == (water.water[i] != WaterKind::dry));
    REQUIRE(water.receiver[i] <= leaves_map);
    left += water.receiver[i] == leaves_map ? upstream[i] : 0;
  }
  CHECK(left == water.filled.size());
  const auto light = compute_monthly_illumination(terrain, derivatives);
  REQUIRE(light);
  for (const float ratio : (*light)[5].cells()) REQUIRE(std::isfinite(ratio));
}

struct Floor {
  Derivatives derivatives;
  Hydrology water;
  std::array<Grid<float>, 12> light;
};

Floor floor_with(std::size_t threads, const Terrain& terrain, const HydrologyOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const Derivatives derivatives = compute_derivatives(terrain);
  return {derivatives, water_of(terrain, options), compute_monthly_illumination(terrain, derivatives).value()};
}

}  // namespace

TEST_CASE("the smallest grids have water and light") {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 2}, {2, 2}, {3, 3}, {5, 1}, {1, 5}, {2, 7}}) {
    check_sane(ground(width, height, 10, [](double x, double y) { return 3 + 0.1 * x - 0.2 * y; }));
    check_sane(ground(width, height, 10, [](double x, double y) { return std::fmod(x * 7 + y * 3, 11) - 5; }));
  }
}

TEST_CASE("level ground everywhere drains and lies in the light") {
  check_sane(ground(40, 30, 5, [](double, double) { return 12.0; }));
  check_sane(ground(40, 30, 5, [](double, double) { return 0.0; }));
  check_sane(ground(40, 30, 5, [](double, double) { return -3.0; }));
}

TEST_CASE("coarse grids of 30 to 180 m are as good as fine ones") {
  for (const double cell : {30.0, 90.0, 180.0}) check_sane(rough_ground(80, 60, cell, std::uint64_t(cell), cell / 2));
}

TEST_CASE("a terrain without cells is refused") { CHECK_FALSE(compute_hydrology({}, {})); }

TEST_CASE("hydrology stops when told to") {
  std::stop_source stop;
  stop.request_stop();
  const TaskContext context{{}, stop.get_token()};
  CHECK_FALSE(compute_hydrology(rough_ground(20, 20, 10, 1), {}, context));
}

TEST_CASE("one thread and two make the same ground, water and light to the bit") {
  const Terrain terrain = rough_ground(530, 290, 10, 21, 5);
  HydrologyOptions options;
  options.channel_discharge = 0.001;
  options.inflows = {{100, 0, 3e9}, {529, 200, 1e8}};
  const Floor one = floor_with(1, terrain, options);
  const Floor two = floor_with(2, terrain, options);
  CHECK(one.derivatives.slope == two.derivatives.slope);
  CHECK(one.derivatives.curvature == two.derivatives.curvature);
  CHECK(one.water.filled == two.water.filled);
  CHECK(one.water.receiver == two.water.receiver);
  CHECK(one.water.catchment_area == two.water.catchment_area);
  CHECK(one.water.discharge == two.water.discharge);
  CHECK(one.water.water_depth == two.water.water_depth);
  CHECK(one.water.water == two.water.water);
  REQUIRE(one.water.reaches.size() == two.water.reaches.size());
  for (std::size_t i = 0; i < one.water.reaches.size(); ++i) CHECK(one.water.reaches[i].cells == two.water.reaches[i].cells);
  REQUIRE(one.water.fords.size() == two.water.fords.size());
  for (std::size_t i = 0; i < one.water.fords.size(); ++i) {
    CHECK(one.water.fords[i].x == two.water.fords[i].x);
    CHECK(one.water.fords[i].y == two.water.fords[i].y);
  }
  CHECK(one.light == two.light);
}
