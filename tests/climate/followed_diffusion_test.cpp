#include "core/climate/followed_diffusion.hpp"

#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/climate/diffusion.hpp"

using namespace biotope;

namespace {

Grid<float> noise(int width, int height, std::uint64_t seed, double from, double to) {
  Grid<float> grid(width, height);
  for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = float(from + (to - from) * random_unit({seed, std::uint64_t(i)}));
  return grid;
}

Grid<float> diffused(Grid<float> values, const Grid<float>& conductance, int steps) {
  for (int step = 0; step < steps; ++step) diffuse(values, conductance);
  return values;
}

bool always(int) { return true; }

/// Another value, and perhaps another conductance, in a few cells around a place; returns their tiles.
TileSet change(Grid<float>& values, Grid<float>& conductance, std::uint64_t number) {
  const int x = random_int(0, values.width() - 1, {number, 1});
  const int y = random_int(0, values.height() - 1, {number, 2});
  const Rect cells = intersection({x - 6, y - 4, x + 7, y + 5}, values.rect());
  const bool leads_too = random_int(0, 1, {number, 3}) == 1;
  for (int cy = cells.y0; cy < cells.y1; ++cy) {
    for (int cx = cells.x0; cx < cells.x1; ++cx) {
      values(cx, cy) = float(10 * random_unit({number, 4, std::uint64_t(cx), std::uint64_t(cy)}));
      if (leads_too) conductance(cx, cy) = random_int(0, 3, {number, 5, std::uint64_t(cx)}) == 0 ? -1.0F : 2.0F;
    }
  }
  TileSet tiles(values.width(), values.height());
  tiles.insert(cells);
  return tiles;
}

}  // namespace

TEST_CASE("A diffusion that is followed is that of the whole map, to the bit") {
  for (const auto& [width, height] :
       {std::pair(333, 150), std::pair(64, 64), std::pair(130, 7), std::pair(1, 200), std::pair(65, 1)}) {
    Grid<float> values = noise(width, height, 1, 0, 10);
    Grid<float> conductance = noise(width, height, 2, 0.1, 9);
    FollowedDiffusion followed(3);
    REQUIRE(followed.restart(values, {&conductance}, always));
    REQUIRE(followed.result() == diffused(values, conductance, 3));
    for (std::uint64_t number = 0; number < 8; ++number) {
      INFO(width << " x " << height << ", change " << number);
      const Grid<float> before = followed.result();
      const TileSet told = followed.follow(values, {&conductance}, change(values, conductance, number));
      REQUIRE(followed.result() == diffused(values, conductance, 3));
      for (std::size_t tile = 0; tile < told.tile_count(); ++tile) {
        if (told.contains(tile)) continue;
        const Rect rect = told.rect(tile);
        for (int y = rect.y0; y < rect.y1; ++y) {
          for (int x = rect.x0; x < rect.x1; ++x) REQUIRE(before(x, y) == followed.result()(x, y));
        }
      }
    }
  }
}

TEST_CASE("One conductance for all cells is a map of it") {
  Grid<float> values = noise(200, 140, 5, 100, 300);
  Grid<float> even(200, 140, 7.0F);
  FollowedDiffusion followed(1);
  REQUIRE(followed.restart(values, {nullptr, 7.0F}, always));
  CHECK(followed.result() == diffused(values, even, 1));
  Grid<float> unused = even;
  const TileSet changed = change(values, unused, 3);
  followed.follow(values, {nullptr, 7.0F}, changed);
  CHECK(followed.result() == diffused(values, even, 1));
}

TEST_CASE("A change is followed no farther than it is felt") {
  Grid<float> values = noise(1000, 900, 7, 1, 2);
  Grid<float> conductance(1000, 900, 0.5F);
  FollowedDiffusion followed(2);
  REQUIRE(followed.restart(values, {&conductance}, always));
  values(500, 450) += 1;
  TileSet changed(1000, 900);
  changed.insert(Rect{500, 450, 501, 451});
  const TileSet told = followed.follow(values, {&conductance}, changed);
  CHECK(told.count() > 0);
  CHECK(told.count() <= 25);
  CHECK(followed.result() == diffused(values, conductance, 2));
}

TEST_CASE("A diffusion that is stopped begins anew") {
  const Grid<float> values = noise(70, 70, 8, 1, 2);
  FollowedDiffusion followed(4);
  CHECK_FALSE(followed.restart(values, {nullptr, 1}, [](int step) { return step < 2; }));
  CHECK_FALSE(followed.started());
  CHECK(followed.restart(values, {nullptr, 1}, always));
  CHECK(followed.result() == diffused(values, Grid<float>(70, 70, 1.0F), 4));
}
