#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr std::uint8_t east = 0, south_east = 1, south = 2, west = 4;

/// What leaves the map: the sum of a grid over the cells from which water leaves.
template <class T>
double leaving(const Grid<T>& passing, const Grid<std::uint8_t>& receiver) {
  double sum = 0;
  for (std::size_t i = 0; i < passing.size(); ++i) sum += receiver[i] == leaves_map ? double(passing[i]) : 0.0;
  return sum;
}

}  // namespace

TEST_CASE("on a plane that falls east all water runs east and gathers cell by cell") {
  const Terrain plane = ground(6, 4, 10, [](double x, double) { return 100 - x; });
  const Grid<std::uint8_t> receiver = flow_directions(plane.height, {});
  const Grid<std::uint32_t> upstream = upstream_cells(receiver);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 6; ++x) {
      CHECK(receiver(x, y) == (x < 5 ? east : leaves_map));
      CHECK(upstream(x, y) == std::uint32_t(x + 1));
    }
  }
}

TEST_CASE("on a plane that falls south-east water takes the diagonal") {
  const Terrain plane = ground(6, 6, 10, [](double x, double y) { return 100 - x + y; });
  const Grid<std::uint8_t> receiver = flow_directions(plane.height, {});
  const Grid<std::uint32_t> upstream = upstream_cells(receiver);
  for (int i = 0; i < 5; ++i) {
    CHECK(receiver(i, i) == south_east);
    CHECK(upstream(i, i) == std::uint32_t(i + 1));
  }
  CHECK(receiver(5, 5) == leaves_map);
}

TEST_CASE("water leaves over the border it runs toward, not over one that rises") {
  const Terrain plane = ground(5, 5, 10, [](double, double y) { return y; });
  const Grid<std::uint8_t> receiver = flow_directions(plane.height, {});
  for (int x = 0; x < 5; ++x) {
    CHECK(receiver(x, 0) == south);
    CHECK(receiver(x, 4) == leaves_map);
  }
}

TEST_CASE("a V-shaped valley brings all its water to the foot of its bottom line") {
  const Terrain valley = ground(21, 11, 5, [](double x, double y) { return 0.4 * std::abs(x - 50) + 0.1 * y; });
  const Grid<std::uint8_t> receiver = flow_directions(valley.height, {});
  const Grid<std::uint32_t> upstream = upstream_cells(receiver);
  CHECK(receiver(3, 5) == east);
  CHECK(receiver(17, 5) == west);
  for (int y = 0; y < 11; ++y) CHECK(upstream(10, y) == std::uint32_t(21 * (y + 1)));
}

TEST_CASE("a level plain drains by the shortest way to where it empties") {
  Terrain plain = ground(9, 9, 10, [](double, double) { return 50.0; });
  for (int i = 0; i < 9; ++i) plain.height(i, 0) = plain.height(i, 8) = plain.height(0, i) = plain.height(8, i) = 60;
  plain.height(4, 8) = 40;
  const Grid<float> filled = fill_depressions(plain.height, {}, 0);
  const Grid<std::uint8_t> receiver = flow_directions(filled, {});
  const auto offsets = neighbour_offsets(9);
  for (int y = 1; y < 8; ++y) {
    for (int x = 1; x < 8; ++x) {
      int steps = 0;
      for (std::size_t cell = filled.index(x, y); receiver[cell] != leaves_map; cell += std::size_t(offsets[receiver[cell]])) ++steps;
      CHECK(steps == std::max(std::abs(x - 4), 8 - y));
    }
  }
  CHECK(upstream_cells(receiver)(4, 8) >= 49);
}

TEST_CASE("multiple flow shares water by slope to the power 1.1") {
  // The middle has two lower neighbours: two below to the east, one below to the west.
  Grid<float> heights(5, 3, 100.0F);
  const std::vector<float> line{1, 9, 10, 8, 1};
  for (int x = 0; x < 5; ++x) heights(x, 1) = line[std::size_t(x)];
  // Walls so high that what they give is known: they give to all, so compare with the middle's water taken away.
  const Grid<std::uint8_t> receiver = flow_directions(heights, {});
  std::vector<Inflow> none;
  const std::vector<Inflow> spring{{2, 1, 1e6}};
  const Grid<float> without = multiple_flow_area(heights, receiver, 1, none);
  const Grid<float> with = multiple_flow_area(heights, receiver, 1, spring);
  const double to_east = double(with(3, 1) - without(3, 1));
  const double to_west = double(with(1, 1) - without(1, 1));
  CHECK(to_east + to_west == Approx(1e6).epsilon(1e-5));
  CHECK(to_east / to_west == Approx(std::pow(2, 1.1)).epsilon(1e-3));
}

TEST_CASE("multiple flow on a plane passes each column's water to the next") {
  const Terrain plane = ground(20, 15, 10, [](double x, double) { return 100 - 0.3 * x; });
  const Grid<std::uint8_t> receiver = flow_directions(plane.height, {});
  const Grid<float> area = multiple_flow_area(plane.height, receiver, 100, {});
  for (int x = 0; x < 20; ++x) {
    double column = 0;
    for (int y = 0; y < 15; ++y) column += double(area(x, y));
    CHECK(column == Approx(15 * 100 * (x + 1)).epsilon(1e-5));
  }
}

TEST_CASE("down a cone multiple flow spreads evenly where single flow runs in eight lines") {
  const Terrain cone = ground(121, 121, 1, [](double x, double y) { return 100 - 0.5 * std::hypot(x - 60, y - 60); });
  const Grid<std::uint8_t> receiver = flow_directions(cone.height, {});
  const Grid<float> spread = multiple_flow_area(cone.height, receiver, 1, {});
  const Grid<std::uint32_t> single = upstream_cells(receiver);
  double sum = 0;
  int cells = 0;
  float least = 1e9F, most = 0;
  std::uint32_t single_least = 1000000, single_most = 0;
  for (int y = 0; y < 121; ++y) {
    for (int x = 0; x < 121; ++x) {
      if (std::abs(std::hypot(x - 60, y - 60) - 40) > 0.7) continue;
      sum += double(spread(x, y));
      ++cells;
      least = std::min(least, spread(x, y));
      most = std::max(most, spread(x, y));
      single_least = std::min(single_least, single(x, y));
      single_most = std::max(single_most, single(x, y));
    }
  }
  // Area over contour length is r / 2 on a cone; water crosses 1 (straight) to 4 / pi cells (in steps) for each cell of the way out.
  CHECK(sum / cells > 40.0 / 2);
  CHECK(sum / cells < 40.0 / 2 * 4 / 3.14159);
  CHECK(most / least < 1.7F);
  CHECK(single_most > 8 * single_least);
}

TEST_CASE("water is conserved: what leaves the map fell on it or ran in") {
  const auto seed = GENERATE(range(1, 7));
  const int width = random_int(30, 300, {std::uint64_t(seed), 1});
  const int height = random_int(30, 300, {std::uint64_t(seed), 2});
  const double cell = 5.0 * seed;
  const Terrain hills = rough_ground(width, height, cell, std::uint64_t(seed), seed % 2 == 0 ? 0 : 100);
  HydrologyOptions options;
  options.inflows = {{width / 2, 0, 5e7}, {0, height / 3, 1e6}, {width / 2, height / 2, 2e6}};
  const Hydrology water = water_of(hills, options);
  const double fallen = double(width) * height * hills.cell_area();
  CHECK(leaving(upstream_cells(water.receiver), water.receiver) == double(width) * height);
  CHECK(leaving(water.catchment_area, water.receiver) == Approx(fallen + 5.3e7).epsilon(1e-5));
}

TEST_CASE("discharge is conserved: rain and inflow in, rivers over the border and into the sea out") {
  const auto seed = GENERATE(range(1, 5));
  const Terrain coast = rough_ground(160, 140, 20, std::uint64_t(seed) + 50, seed % 2 == 0 ? 0 : 100);
  HydrologyOptions options;
  options.channel_discharge = 0;
  options.lake_depth = 1e9F;
  options.inflows = {{80, 139, 3e8}};
  const Hydrology water = water_of(coast, options);
  const auto offsets = neighbour_offsets(160);
  double out = 0;
  for (std::size_t i = 0; i < water.water.size(); ++i) {
    const bool sea = water.water[i] == WaterKind::sea;
    if (sea) {
      out += double(mean_discharge(coast.cell_area(), options.runoff));
    } else if (water.receiver[i] == leaves_map || water.water[i + std::size_t(offsets[water.receiver[i]])] == WaterKind::sea) {
      out += double(water.discharge[i]);
    }
  }
  const bool into_sea = water.water(80, 139) == WaterKind::sea;
  const double in = double(mean_discharge(160 * 140 * coast.cell_area() + (into_sea ? 0 : 3e8), options.runoff));
  CHECK(out == Approx(in).epsilon(1e-4));
}
