#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// The textbook's single priority-flood from the border inwards (Barnes, Lehman and Mulla 2014), to compare with.
Grid<float> flooded(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level) {
  using Entry = std::tuple<float, int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  Grid<float> filled(height.width(), height.height());
  Grid<std::uint8_t> seen(height.width(), height.height());
  for (int y = 0; y < height.height(); ++y) {
    for (int x = 0; x < height.width(); ++x) {
      const bool wet = !sea.empty() && sea(x, y) != 0;
      const bool border = x == 0 || y == 0 || x == height.width() - 1 || y == height.height() - 1;
      if (!wet && !border) continue;
      filled(x, y) = wet ? sea_level : height(x, y);
      seen(x, y) = 1;
      open.emplace(filled(x, y), x, y);
    }
  }
  while (!open.empty()) {
    const auto [level, x, y] = open.top();
    open.pop();
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!height.contains(nx, ny) || seen(nx, ny) != 0) continue;
      seen(nx, ny) = 1;
      filled(nx, ny) = std::max(level, height(nx, ny));
      open.emplace(filled(nx, ny), nx, ny);
    }
  }
  return filled;
}

}  // namespace

TEST_CASE("a pit is filled to the lowest point of its rim and no further") {
  Terrain basin = ground(7, 7, 1, [](double, double) { return 20.0; });
  for (int y = 2; y < 5; ++y) {
    for (int x = 2; x < 5; ++x) basin.height(x, y) = 5;
  }
  CHECK(fill_depressions(basin.height, {}, 0)(3, 3) == 20);
  basin.height(5, 3) = 12;
  CHECK(fill_depressions(basin.height, {}, 0)(3, 3) == 20);
  basin.height(6, 3) = 11;
  const Grid<float> filled = fill_depressions(basin.height, {}, 0);
  for (int y = 2; y < 5; ++y) {
    for (int x = 2; x < 5; ++x) CHECK(filled(x, y) == 12);
  }
  CHECK(filled(5, 3) == 12);
  CHECK(filled(6, 3) == 11);
  CHECK(filled(1, 1) == 20);
}

TEST_CASE("water passes a gap between two cells that touch at a corner") {
  Terrain basin = ground(5, 5, 1, [](double, double) { return 9.0; });
  basin.height(2, 2) = 1;
  basin.height(3, 3) = 4;
  basin.height(4, 4) = 2;
  const Grid<float> filled = fill_depressions(basin.height, {}, 0);
  CHECK(filled(2, 2) == 4);
  CHECK(filled(3, 3) == 4);
}

TEST_CASE("of two nested pits each stands at its own level until they join") {
  // Across: rim 10, pit 1, sill 4, pit 2, sill 7, outlet 3.
  const Grid<float> profile = [] {
    Grid<float> heights(9, 3, 10.0F);
    const std::vector<float> line{10, 1, 4, 2, 7, 6, 5, 4, 3};
    for (int x = 0; x < 9; ++x) heights(x, 1) = line[std::size_t(x)];
    return heights;
  }();
  const Grid<float> filled = fill_depressions(profile, {}, 0);
  const std::vector<float> expected{10, 7, 7, 7, 7, 6, 5, 4, 3};
  for (int x = 0; x < 9; ++x) CHECK(filled(x, 1) == expected[std::size_t(x)]);
}

TEST_CASE("tiles joined by their watersheds hold the same water as one flood over all") {
  const auto [width, height] = GENERATE(std::pair{90, 70}, std::pair{300, 270}, std::pair{513, 40}, std::pair{257, 257});
  const Terrain hills = rough_ground(width, height, 10, std::uint64_t(width));
  CHECK(fill_depressions(hills.height, {}, 0) == flooded(hills.height, {}, 0));
}

TEST_CASE("the sea drains what lies around it, also far from the border") {
  Terrain coast = rough_ground(300, 280, 10, 5, 0);
  const Grid<std::uint8_t> sea = find_sea(coast.height, 0);
  REQUIRE_FALSE(sea.empty());
  CHECK(fill_depressions(coast.height, sea, 0) == flooded(coast.height, sea, 0));
}

TEST_CASE("whole steps of height, where nearly all is level, fill alike") {
  Terrain steps = rough_ground(280, 270, 10, 9);
  for (float& z : steps.height.cells()) z = std::floor(z / 3) * 3;
  CHECK(fill_depressions(steps.height, {}, 0) == flooded(steps.height, {}, 0));
}

TEST_CASE("filled ground leads every drop out of the map without climbing") {
  const Terrain hills = rough_ground(150, 130, 10, 77);
  const Grid<float> filled = fill_depressions(hills.height, {}, 0);
  const Grid<std::uint8_t> receiver = flow_directions(filled, {});
  const auto offsets = neighbour_offsets(filled.width());
  for (std::size_t start = 0; start < filled.size(); ++start) {
    REQUIRE(filled[start] >= hills.height[start]);
    std::size_t cell = start;
    std::size_t steps = 0;
    while (receiver[cell] != leaves_map && steps <= filled.size()) {
      REQUIRE(receiver[cell] < 8);
      const std::size_t next = cell + std::size_t(offsets[receiver[cell]]);
      REQUIRE(filled[next] <= filled[cell]);
      cell = next;
      ++steps;
    }
    REQUIRE(steps <= filled.size());
  }
}
