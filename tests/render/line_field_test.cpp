#include "render/line_field.hpp"

#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// A brook of 2 m that flows south in two reaches, the second from row `next` on.
Hydrology two_reaches(int last, int next) {
  Hydrology water = *river(64, 65);
  const float discharge = 4 / (4.5F * 4.5F);
  RiverReach upper = water.reaches.front();
  RiverReach lower = upper;
  upper.cells.clear();
  lower.cells.clear();
  for (int y = 0; y < cells; ++y) {
    const auto cell = std::uint32_t(y * cells + 64);
    water.discharge[cell] = discharge;
    if (y <= last) upper.cells.push_back(cell);
    if (y >= next) lower.cells.push_back(cell);
  }
  water.reaches = {upper, lower};
  return water;
}

}  // namespace

TEST_CASE("a river is drawn on to the junction that it flows into") {
  const auto landscape = level_landscape();
  const Terrain& terrain = landscape->terrain();
  Hydrology water = two_reaches(59, 60);
  // A first reach whose water leaves the map ends in the middle of its last cell, 4 m from where the second begins.
  CHECK(shore_distance(shore_field(terrain, water, 4)(64 * 4 + 2, 60 * 4)) < 0);
  water.receiver(64, 59) = 2;  // south
  const Grid<std::uint8_t> joined = shore_field(terrain, water, 4);
  for (int y = 58 * 4; y < 61 * 4; ++y) CHECK(shore_distance(joined(64 * 4 + 2, y)) > 0);
}

TEST_CASE("shores lie half a river's width from its middle") {
  const auto landscape = level_landscape();
  const Terrain& terrain = landscape->terrain();
  const Grid<std::uint8_t> shore = shore_field(terrain, *river(60, 68), 2);
  // 32 m wide about the middle of column 64.
  CHECK(shore_distance(shore(64 * 2, 128)) > 7);
  CHECK(shore_distance(shore(64 * 2 - 6, 128)) == Approx(4).margin(1.5));
  CHECK(shore_distance(shore(64 * 2 - 10, 128)) == Approx(-4).margin(1.5));
  CHECK(shore_distance(shore(20, 128)) <= -7.9F);
}

TEST_CASE("a river is wider at a ford") {
  const auto landscape = level_landscape();
  const Terrain& terrain = landscape->terrain();
  const Hydrology water = two_reaches(59, 60);
  const auto half_width = [&](const Grid<std::uint8_t>& shore, int row) {
    return shore_distance(shore(64 * 4 + 2, row * 4 + 2));
  };
  const Grid<std::uint8_t> shore = shore_field(terrain, water, 4, FordLook({{64, 30, 4}}));
  CHECK(half_width(shore, 30) > 1.25F * half_width(shore, 50));
  CHECK(half_width(shore, 50) == half_width(shore_field(terrain, water, 4), 50));
}
