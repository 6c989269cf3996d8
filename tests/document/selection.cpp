#include "core/document/selection.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/base/random.hpp"

using namespace biotope;

namespace {

using Pointer = std::shared_ptr<const SelectionMask>;

Pointer shared(SelectionMask mask) { return std::make_shared<const SelectionMask>(std::move(mask)); }

int sum_of(const SelectionMask& mask) {
  const Grid<std::uint8_t> cells = mask.to_grid();
  int sum = 0;
  for (const std::uint8_t cell : cells.cells()) sum += cell;
  return sum;
}

/// A selection of many lassos and rectangles.
SelectionMask random_mask(int width, int height, std::uint64_t number) {
  std::vector<PathPoint> line;
  const int points = random_int(3, 9, {number, 1});
  for (std::uint64_t i = 0; i < std::uint64_t(points); ++i) {
    line.push_back({float(random_unit({number, 2, i})) * float(width), float(random_unit({number, 3, i})) * float(height)});
  }
  return lasso_selection(width, height, line);
}

}  // namespace

TEST_CASE("A rectangle holds the cells under its corners and those between, cut at the border") {
  const SelectionMask mask = rectangle_selection(20, 10, {6.2F, 7.4F}, {3.8F, 2.6F});
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) REQUIRE(mask(x, y) == (x >= 4 && x <= 6 && y >= 3 && y <= 7 ? 255 : 0));
  }
  CHECK(sum_of(rectangle_selection(20, 10, {-50, -50}, {500, 500})) == 255 * 200);
  CHECK(sum_of(rectangle_selection(20, 10, {30, 3}, {40, 5})) == 0);
  CHECK(sum_of(rectangle_selection(20, 10, {-9, -9}, {-1, 50})) == 0);
  CHECK(sum_of(rectangle_selection(20, 10, {std::nanf(""), 3}, {40, 5})) == 0);
}

TEST_CASE("A lasso around whole cells is exact, and half a cell is half selected") {
  // From the middle of column 2 to the end of column 5, rows 3 to 4.
  const std::vector<PathPoint> line{{2, 2.5F}, {5.5F, 2.5F}, {5.5F, 4.5F}, {2, 4.5F}};
  const SelectionMask mask = lasso_selection(12, 9, line);
  CHECK(mask(2, 3) == 128);
  CHECK(mask(3, 3) == 255);
  CHECK(mask(5, 4) == 255);
  CHECK(mask(6, 4) == 0);
  CHECK(mask(1, 4) == 0);
  CHECK(mask(4, 2) == 0);
  CHECK(mask(4, 5) == 0);
  std::vector<PathPoint> backwards(line.rbegin(), line.rend());
  CHECK(lasso_selection(12, 9, backwards) == mask);
}

TEST_CASE("A lasso covers the area inside its line, and where it goes around twice it is a hole") {
  std::vector<PathPoint> circle;
  for (int i = 0; i < 200; ++i) {
    const double angle = i * std::numbers::pi / 100;
    circle.push_back({float(75.3 + 40 * std::cos(angle)), float(60.7 + 40 * std::sin(angle))});
  }
  CHECK(sum_of(lasso_selection(150, 120, circle)) / 255.0 == Approx(std::numbers::pi * 1600).epsilon(2e-3));
  std::vector<PathPoint> twice = circle;
  twice.insert(twice.end(), circle.begin(), circle.end());
  CHECK(sum_of(lasso_selection(150, 120, twice)) == 0);
  CHECK(sum_of(lasso_selection(150, 120, {})) == 0);
  std::vector<PathPoint> broken = circle;
  broken.insert(broken.begin() + 7, {std::numeric_limits<float>::infinity(), 3});
  CHECK(lasso_selection(150, 120, broken) == lasso_selection(150, 120, circle));
  // Most of it is beyond the border.
  for (PathPoint& point : circle) point.x -= 75.3F;
  CHECK(sum_of(lasso_selection(150, 120, circle)) / 255.0 == Approx(std::numbers::pi * 800 + 40).epsilon(3e-3));
}

TEST_CASE("A range of values is selected with soft edges") {
  Grid<float> values(5, 1);
  for (int x = 0; x < 5; ++x) values(x, 0) = float(x);
  values(4, 0) = std::nanf("");
  const SelectionMask mask = range_selection(values, 2, 9, 2);
  CHECK(mask(0, 0) == 0);
  CHECK(mask(1, 0) == 128);
  CHECK(mask(2, 0) == 255);
  CHECK(mask(4, 0) == 0);
  CHECK(range_selection(values, 9, 2, 0)(1, 0) == 0);
}

TEST_CASE("Full and blank tiles cost nothing of their own") {
  const SelectionMask all = rectangle_selection(300, 300, {0, 0}, {299, 299});
  std::set<const SelectionMask::Tile*> tiles;
  for (std::size_t i = 0; i < all.tile_count(); ++i) {
    const Rect rect = all.tile_rect(i);
    if (rect.width() == tile_side && rect.height() == tile_side) tiles.insert(all.tile(i).get());
  }
  CHECK(tiles.size() == 1);
  CHECK(*tiles.begin() != nullptr);
  CHECK(inverted(all).bytes() == 0);
}

TEST_CASE("A selection and its inverse part the map, and inverting twice is nothing") {
  for (std::uint64_t number = 0; number < 20; ++number) {
    const SelectionMask mask = random_mask(150, 90, number);
    const SelectionMask rest = inverted(mask);
    for (int y = 0; y < 90; ++y) {
      for (int x = 0; x < 150; ++x) REQUIRE(int(mask(x, y)) + int(rest(x, y)) == 255);
    }
    REQUIRE(inverted(rest) == mask);
    CHECK(combined(shared(mask), rest, SelectionMode::add) == nullptr);
    CHECK(sum_of(*combined(shared(mask), mask, SelectionMode::subtract)) == 0);
    CHECK(*combined(shared(mask), mask, SelectionMode::intersect) == mask);
  }
}

TEST_CASE("What two selections share and what only one has make up that one") {
  for (std::uint64_t number = 0; number < 20; ++number) {
    const SelectionMask a = random_mask(150, 90, number);
    const SelectionMask b = random_mask(150, 90, number + 100);
    const Pointer both = combined(shared(a), b, SelectionMode::intersect);
    const Pointer only = combined(shared(a), b, SelectionMode::subtract);
    REQUIRE(*combined(both, *only, SelectionMode::add) == a);
    REQUIRE(*combined(shared(a), b, SelectionMode::replace) == b);
    REQUIRE(*combined(shared(a), b, SelectionMode::add) == *combined(shared(b), a, SelectionMode::add));
  }
}

TEST_CASE("No selection is everything") {
  const SelectionMask some = rectangle_selection(100, 100, {10, 10}, {20, 20});
  CHECK(combined(nullptr, some, SelectionMode::add) == nullptr);
  CHECK(*combined(nullptr, some, SelectionMode::intersect) == some);
  CHECK(*combined(nullptr, some, SelectionMode::subtract) == inverted(some));
  CHECK(combined(nullptr, inverted(SelectionMask(100, 100)), SelectionMode::replace) == nullptr);
  const Pointer none = combined(nullptr, SelectionMask(100, 100), SelectionMode::replace);
  REQUIRE(none);
  CHECK(sum_of(*none) == 0);
  CHECK(selected(nullptr, 3, 3) == 1.0F);
  CHECK(selected(none.get(), 3, 3) == 0.0F);
}
