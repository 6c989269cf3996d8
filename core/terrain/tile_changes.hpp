#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/generations.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// Whether two grids hold the same in some cells.
template <class T>
[[nodiscard]] bool same_cells(const Grid<T>& a, const Grid<T>& b, const Rect& cells) {
  for (int y = cells.y0; y < cells.y1; ++y) {
    const T* row = a.row(y).data() + cells.x0;
    if (!std::equal(row, row + cells.width(), b.row(y).data() + cells.x0)) return false;
  }
  return true;
}

/// Those of the tiles for which `remake(rect)`, called for each on any thread, says that something changed.
template <class Remake>
[[nodiscard]] TileSet changed_tiles(const TileSet& tiles, const Remake& remake) {
  const auto list = tiles.list();
  std::vector<char> another(list.size(), 0);
  parallel_each(list.size(), [&](std::size_t i) { another[i] = remake(tiles.rect(list[i])) ? 1 : 0; });
  TileSet changed(tiles.width(), tiles.height(), tiles.side());
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (another[i] != 0) changed.insert(list[i]);
  }
  return changed;
}

/// Tiles in which two grids of one size differ.
template <class T>
[[nodiscard]] TileSet differing_tiles_of(const Grid<T>& a, const Grid<T>& b) {
  return changed_tiles(TileSet::all(a.width(), a.height()), [&](const Rect& rect) { return !same_cells(a, b, rect); });
}

/// Makes the next version of a grid, in which `make(rect, grid)` writes some tiles again; returns those that are others now.
template <class T, class Make>
TileSet remake_tiles(GridGenerations<T>& grids, const TileSet& tiles, const Make& make) {
  if (!tiles.any()) return tiles;
  const auto before = grids.newest();
  auto grid = grids.copy();
  const TileSet changed = changed_tiles(tiles, [&](const Rect& rect) {
    make(rect, *grid);
    return !same_cells(*grid, *before, rect);
  });
  grids.put(std::move(grid), changed);
  return changed;
}

}  // namespace biotope
