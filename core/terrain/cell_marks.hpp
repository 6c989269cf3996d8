#pragma once

#include <bitset>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/tiled_map.hpp"

namespace biotope {

/// Marks on a few cells of a large raster.
class CellMarks {
 public:
  CellMarks(int width, int height)
      : width_(width),
        columns_((width + tile_side - 1) / tile_side),
        tiles_(std::size_t(columns_) * std::size_t((height + tile_side - 1) / tile_side)) {}

  /// Marks a cell; false when it was marked before.
  bool mark(std::size_t cell) {
    const auto x = int(cell % std::size_t(width_));
    const auto y = int(cell / std::size_t(width_));
    auto& tile = tiles_[std::size_t(y / tile_side) * std::size_t(columns_) + std::size_t(x / tile_side)];
    if (!tile) tile = std::make_unique<Tile>();
    const auto at = std::size_t(y % tile_side) * tile_side + std::size_t(x % tile_side);
    if (tile->test(at)) return false;
    tile->set(at);
    return true;
  }

 private:
  using Tile = std::bitset<std::size_t(tile_side) * tile_side>;
  int width_;
  int columns_;
  std::vector<std::unique_ptr<Tile>> tiles_;
};

}  // namespace biotope
