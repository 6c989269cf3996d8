#include "core/base/tiled_map.hpp"

#include <catch2/catch.hpp>

#include "core/base/random.hpp"

using namespace biotope;

TEST_CASE("A tiled map holds what was written and its background elsewhere") {
  TiledMap<int> map(100, 70, 7);
  CHECK(map.tile_columns() == 2);
  CHECK(map.tile_rows() == 2);
  map.set(99, 69, 3);
  CHECK(map(99, 69) == 3);
  CHECK(map(0, 0) == 7);
  CHECK(map.bytes() == sizeof(TiledMap<int>::Tile));
}

TEST_CASE("A copy shares tiles until one of the two is written") {
  TiledMap<int> first(128, 128);
  first.set(1, 1, 5);
  TiledMap<int> second = first;
  CHECK(second.tile(0) == first.tile(0));
  second.set(1, 1, 6);
  CHECK(first(1, 1) == 5);
  CHECK(second(1, 1) == 6);
  CHECK(second.tile(0) != first.tile(0));
}

TEST_CASE("Reading rows, converting to a grid and back keep every cell") {
  Grid<int> grid(130, 65);
  for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = int(random_bits({1, i}) % 1000);
  const TiledMap<int> map = tiled(grid);
  CHECK(map.to_grid() == grid);
  std::vector<int> part(70);
  map.read_row(64, 40, part);
  for (int i = 0; i < 70; ++i) CHECK(part[std::size_t(i)] == grid(40 + i, 64));
}

TEST_CASE("A blank tile equals a tile full of background") {
  TiledMap<int> blank(64, 64, 2);
  TiledMap<int> filled(64, 64, 2);
  filled.set(3, 3, 2);
  CHECK(blank == filled);
  filled.set(3, 3, 1);
  CHECK_FALSE(blank == filled);
}
