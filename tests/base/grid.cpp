#include "core/base/grid.hpp"

#include <catch2/catch.hpp>

#include "core/base/parallel.hpp"
#include "core/base/rect.hpp"

using namespace biotope;

TEST_CASE("Rectangles intersect, bound and grow") {
  const Rect a{0, 0, 4, 4};
  const Rect b{2, 1, 6, 3};
  CHECK(intersection(a, b) == Rect{2, 1, 4, 3});
  CHECK(bounding(a, b) == Rect{0, 0, 6, 4});
  CHECK(intersection(a, Rect{5, 5, 6, 6}).empty());
  CHECK(bounding(Rect{}, b) == b);
  CHECK(grown(b, 2) == Rect{0, -1, 8, 5});
}

TEST_CASE("Bilinear samples meet the cells and stay within the border") {
  Grid<float> grid(2, 2);
  grid(0, 0) = 0;
  grid(1, 0) = 1;
  grid(0, 1) = 2;
  grid(1, 1) = 3;
  CHECK(sample_bilinear(grid, 0.5, 0.5) == Approx(1.5));
  CHECK(sample_bilinear(grid, -5, 0) == Approx(0));
  CHECK(sample_bilinear(grid, 9, 9) == Approx(3));
  CHECK(sample_bilinear(Grid<float>(1, 1, 4.0F), 0.7, 3) == Approx(4));
}

TEST_CASE("Tiles of a parallel loop cover every cell once") {
  Grid<int> visits(131, 67);
  parallel_tiles(131, 67, 64, [&](const Rect& rect) {
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) ++visits(x, y);
    }
  });
  for (const int count : visits.cells()) REQUIRE(count == 1);
}
