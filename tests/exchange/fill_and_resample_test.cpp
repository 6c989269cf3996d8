#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/random.hpp"
#include "core/exchange/dem_import.hpp"
#include "core/exchange/resample.hpp"
#include "core/exchange/void_fill.hpp"

using namespace biotope;

namespace {

Grid<float> plane(int width, int height) {
  Grid<float> grid(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid(x, y) = 50 + 2 * float(x) - 3 * float(y);
  }
  return grid;
}

}  // namespace

TEST_CASE("a hole in a plane is closed by the plane") {
  const Grid<float> whole = plane(40, 40);
  Grid<float> holed = whole;
  for (int y = 10; y < 22; ++y) {
    for (int x = 14; x < 26; ++x) holed(x, y) = std::nanf("");
  }
  const auto missing = missing_cells(holed);
  fill_missing(holed, missing);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (missing(x, y)) {
        CHECK(std::abs(holed(x, y) - whole(x, y)) < 4);
      } else {
        REQUIRE(holed(x, y) == whole(x, y));
      }
    }
  }
}

TEST_CASE("filled heights lie between those around and make no cliff") {
  Grid<float> grid(65, 33);
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const bool known = random_unit({1, std::uint64_t(x), std::uint64_t(y)}) < 0.02;
      grid(x, y) = known ? float(100 * random_unit({2, std::uint64_t(x), std::uint64_t(y)})) : std::nanf("");
    }
  }
  grid(0, 0) = 50;
  fill_missing(grid, missing_cells(grid));
  for (const float height : grid.cells()) {
    REQUIRE(height >= 0);
    REQUIRE(height <= 100);
  }
}

TEST_CASE("one known cell fills the whole grid") {
  Grid<float> grid(7, 5, std::nanf(""));
  grid(6, 4) = 12;
  fill_missing(grid, missing_cells(grid));
  for (const float height : grid.cells()) CHECK(height == Approx(12));
}

TEST_CASE("shrinking keeps the mean, growing keeps a plane") {
  Grid<float> source(12, 8);
  double mean = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    source[i] = float(random_unit({7, i}));
    mean += double(source[i]) / double(source.size());
  }
  const Grid<float> small = resampled_grid(source, 4, 3, 2);
  double small_mean = 0;
  for (const float value : small.cells()) small_mean += double(value) / 6;
  CHECK(small_mean == Approx(mean));
  double corner = 0;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) corner += double(source(x, y)) / 16;
  }
  CHECK(small(0, 0) == Approx(corner));

  const Grid<float> uneven = resampled_grid(source, 1.5, 8, 5);
  CHECK(uneven(0, 0) == Approx((source(0, 0) + 0.5 * source(1, 0) + 0.5 * source(0, 1) + 0.25 * source(1, 1)) / 2.25));

  const Grid<float> large = resampled_grid(plane(10, 10), 0.5, 20, 20);
  CHECK(large(10, 10) - large(9, 10) == Approx(1));
  CHECK(large(10, 11) - large(10, 10) == Approx(-1.5));
}

TEST_CASE("a resampled terrain covers the same ground") {
  Terrain terrain;
  terrain.height = plane(30, 20);
  terrain.voids = Grid<std::uint8_t>(30, 20);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) terrain.voids(x, y) = 1;
  }
  terrain.cell_size = 4;
  terrain.georeference.transform = {1000, 4, 0, 2000, 0, -4};
  const Terrain half = resampled(terrain, 15);
  CHECK(half.height.width() == 15);
  CHECK(half.height.height() == 10);
  CHECK(half.cell_size == 8);
  CHECK(half.georeference.transform == std::array<double, 6>{1000, 8, 0, 2000, 0, -8});
  CHECK(half.voids(4, 4) == 1);
  CHECK(half.voids(5, 4) == 0);
  CHECK(resampled(terrain, 30).height == terrain.height);
}
