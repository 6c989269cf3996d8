#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/document/selection.hpp"

namespace biotope {

/// The tile that stands for fully selected cells.
[[nodiscard]] inline SelectionMask::TilePointer full_selection_tile() {
  auto tile = std::make_shared<SelectionMask::Tile>();
  tile->fill(255);
  return tile;
}

/// A tile at its least cost: null when nothing of it is selected, `full` when everything is.
[[nodiscard]] inline SelectionMask::TilePointer settled_selection(std::shared_ptr<SelectionMask::Tile> tile,
                                                                  const SelectionMask::TilePointer& full) {
  const auto is = [&](std::uint8_t value) {
    return std::all_of(tile->begin(), tile->end(), [&](std::uint8_t cell) { return cell == value; });
  };
  if (is(0)) return nullptr;
  if (is(255)) return full;
  return tile;
}

/// A mask of rows that `fill_row(y, cells)` writes: cells are 0 before, rows are filled in any order and on any thread.
template <class FillRow>
[[nodiscard]] SelectionMask selection_of_rows(int width, int height, const FillRow& fill_row) {
  SelectionMask mask(width, height);
  const SelectionMask::TilePointer full = full_selection_tile();
  parallel_each(std::size_t(mask.tile_rows()), [&](std::size_t tile_row) {
    const auto columns = std::size_t(mask.tile_columns());
    std::vector<std::shared_ptr<SelectionMask::Tile>> tiles(columns);
    for (auto& tile : tiles) tile = std::make_shared<SelectionMask::Tile>();
    std::vector<std::uint8_t> row(static_cast<std::size_t>(width));
    const int y0 = int(tile_row) * tile_side;
    for (int y = y0; y < std::min(height, y0 + tile_side); ++y) {
      std::fill(row.begin(), row.end(), std::uint8_t(0));
      fill_row(y, std::span<std::uint8_t>(row));
      for (std::size_t column = 0; column < columns; ++column) {
        const int x0 = int(column) * tile_side;
        const int count = std::min(tile_side, width - x0);
        std::copy_n(row.data() + x0, count, tiles[column]->data() + SelectionMask::offset(x0, y));
      }
    }
    for (std::size_t column = 0; column < columns; ++column) {
      mask.set_tile(tile_row * columns + column, settled_selection(std::move(tiles[column]), full));
    }
  });
  return mask;
}

[[nodiscard]] inline std::uint8_t selection_step(float share) {
  return share > 0 ? std::uint8_t(std::min(share, 1.0F) * 255 + 0.5F) : std::uint8_t(0);
}

}  // namespace biotope
