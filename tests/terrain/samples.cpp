#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>

#include "core/terrain/derivatives.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/synthetic.hpp"

using namespace biotope;

TEST_CASE("A sample is the same for every number of threads") {
  const auto make = [](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return sample_landscape("valley");
  };
  const auto one = make(1);
  const auto two = make(2);
  REQUIRE(one);
  REQUIRE(two);
  CHECK(one->terrain.height == two->terrain.height);
  CHECK(one->inflows.front().x == two->inflows.front().x);
}

TEST_CASE("The valley's river runs from its northern entry to the southern border, with fords") {
  const auto valley = sample_landscape("valley");
  REQUIRE(valley);
  CHECK(valley->terrain.height.width() == 1024);
  CHECK(valley->terrain.cell_size == 4);
  HydrologyOptions options;
  options.inflows = valley->inflows;
  const auto water = compute_hydrology(valley->terrain, options);
  REQUIRE(water);
  int rows_with_river = 0;
  for (int y = 0; y < 1024; ++y) {
    const auto row = water->discharge.row(y);
    rows_with_river += std::any_of(row.begin(), row.end(), [](float q) { return q > 2; });
  }
  CHECK(rows_with_river == 1024);
  CHECK(water->fords.size() >= 3);
}

TEST_CASE("The alpine sample holds a lake") {
  const auto alpine = sample_landscape("alpine");
  REQUIRE(alpine);
  const auto water = compute_hydrology(alpine->terrain, {});
  REQUIRE(water);
  const auto lake = std::count(water->water.cells().begin(), water->water.cells().end(), WaterKind::lake);
  CHECK(double(lake) * alpine->terrain.cell_area() > 200000);
  CHECK(*std::max_element(water->water_depth.cells().begin(), water->water_depth.cells().end()) > 20);
}

TEST_CASE("Cliffs, meadows and a plateau are all there") {
  const auto canyon = sample_landscape("canyon");
  REQUIRE(canyon);
  const Derivatives slopes = compute_derivatives(canyon->terrain);
  const auto share = [&](float low, float high) {
    const auto cells = slopes.slope.cells();
    return double(std::count_if(cells.begin(), cells.end(), [&](float s) { return s >= low && s < high; })) / double(cells.size());
  };
  CHECK(share(0, 0.1F) > 0.03);
  CHECK(share(1.5F, 100) > 0.03);
}

TEST_CASE("An unknown sample is a message that lists the known ones") {
  const auto none = sample_landscape("atlantis");
  REQUIRE_FALSE(none);
  for (const SampleDescription& known : sample_descriptions()) {
    CHECK_THAT(none.error().message, Catch::Contains(known.name));
  }
}
