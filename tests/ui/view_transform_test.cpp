#include <catch2/catch.hpp>

#include "ui/view_transform.hpp"

using namespace biotope;

namespace {
const PixelPoint canvas{800, 600};
}

TEST_CASE("the view's centre is in the middle of the canvas") {
  const MapView view{100, 50, 2};
  const PathPoint cell = cell_at(view, canvas, {400, 300});
  CHECK(cell.x == Approx(100));
  CHECK(cell.y == Approx(50));
  CHECK(cell_at(view, canvas, {402, 300}).x == Approx(101));
  CHECK(cell_at(view, canvas, {400, 302}).y == Approx(51));
}

TEST_CASE("a pixel and its cell answer each other") {
  const MapView view{12.5, 99, 0.37};
  const PathPoint cell = cell_at(view, canvas, {123, 456});
  const PixelPoint pixel = pixel_of(view, canvas, cell.x, cell.y);
  CHECK(pixel.x == Approx(123).margin(1e-3));
  CHECK(pixel.y == Approx(456).margin(1e-3));
}

TEST_CASE("zooming holds the place under the pointer still") {
  const MapView view{100, 50, 2};
  const PixelPoint pointer{700, 20};
  const PathPoint before = cell_at(view, canvas, pointer);
  for (const double factor : {1.2, 0.5, 8.0}) {
    const MapView next = zoomed(view, canvas, pointer, factor, 0.01, 100);
    const PathPoint after = cell_at(next, canvas, pointer);
    CHECK(after.x == Approx(before.x).margin(1e-3));
    CHECK(after.y == Approx(before.y).margin(1e-3));
    CHECK(next.pixels_per_cell == Approx(2 * factor));
  }
}

TEST_CASE("zoom stops at its limits") {
  const MapView view{0, 0, 2};
  CHECK(zoomed(view, canvas, {0, 0}, 1e6, 0.1, 64).pixels_per_cell == 64);
  CHECK(zoomed(view, canvas, {0, 0}, 1e-6, 0.1, 64).pixels_per_cell == 0.1);
}

TEST_CASE("panning moves the map with the hand") {
  const MapView view{100, 50, 2};
  const MapView next = panned(view, {10, -4});
  CHECK(next.centre_x == 95);
  CHECK(next.centre_y == 52);
}

TEST_CASE("a fitted view shows the whole map within its margin") {
  const Rect map{0, 0, 1024, 512};
  const MapView view = fitted(map, canvas, 20);
  const PixelPoint corner = pixel_of(view, canvas, -0.5, -0.5);
  const PixelPoint opposite = pixel_of(view, canvas, 1023.5, 511.5);
  CHECK(corner.x == Approx(20));
  CHECK(opposite.x == Approx(780));
  CHECK(corner.y > 20);
  CHECK(opposite.y < 580);
}

TEST_CASE("the sheet is never lost") {
  const MapView lost{-5000, 9000, 1};
  const MapView kept = kept_on_map(lost, 100, 200);
  CHECK(kept.centre_x == -0.5);
  CHECK(kept.centre_y == 199.5);
}

TEST_CASE("ticks are round, within the range and not too many") {
  CHECK(round_ticks(0, 1, 5) == std::vector<double>{0, 0.25, 0.5, 0.75, 1});
  const std::vector<double> heights = round_ticks(83, 512, 5);
  CHECK(heights == std::vector<double>{100, 200, 300, 400, 500});
  CHECK(round_ticks(5, 5, 5).empty());
  CHECK(round_ticks(1, 0, 5).empty());
  for (const double high : {0.0371, 3.3, 77.0, 4.2e6}) {
    const std::vector<double> ticks = round_ticks(0, high, 5);
    CHECK(ticks.size() >= 2);
    CHECK(ticks.size() <= 5);
    CHECK(ticks.front() == 0);
    CHECK(ticks.back() <= high * 1.0001);
  }
}

TEST_CASE("a scale bar has a round length that fits") {
  const ScaleBar bar = scale_bar(4, 120);
  CHECK(bar.metres == 200);
  CHECK(bar.pixels == Approx(50));
  for (const double metres_per_pixel : {0.013, 0.9, 7.7, 312.0}) {
    const ScaleBar other = scale_bar(metres_per_pixel, 120);
    CHECK(other.pixels <= 120);
    CHECK(other.pixels >= 120 / 2.6);
  }
  CHECK(scale_bar(0, 120).metres == 0);
}
