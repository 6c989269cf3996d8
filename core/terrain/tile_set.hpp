#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/rect.hpp"
#include "core/base/tiled_map.hpp"

namespace biotope {

/// Side of the small tiles in which shadows and plants are told apart, cells: a shadow is narrow.
inline constexpr int small_side = 16;
static_assert(tile_side % small_side == 0);

/// Some of the tiles of a raster: where something changed, or has to be made again. Tiles of tile_side cells are numbered as in
/// TiledMap.
class TileSet {
 public:
  TileSet() = default;
  /// No tile of a raster of this size.
  TileSet(int width, int height, int side = tile_side)
      : width_(width),
        height_(height),
        side_(side),
        columns_((width + side - 1) / side),
        rows_((height + side - 1) / side),
        held_(std::size_t(columns_) * std::size_t(rows_), 0) {}
  /// Every tile.
  [[nodiscard]] static TileSet all(int width, int height, int side = tile_side) {
    TileSet tiles(width, height, side);
    std::fill(tiles.held_.begin(), tiles.held_.end(), std::uint8_t(1));
    return tiles;
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Side of a tile, cells.
  [[nodiscard]] int side() const { return side_; }
  [[nodiscard]] bool fits(int width, int height) const { return width == width_ && height == height_; }
  [[nodiscard]] std::size_t tile_count() const { return held_.size(); }
  [[nodiscard]] bool contains(std::size_t tile) const { return held_[tile] != 0; }
  [[nodiscard]] std::size_t count() const { return std::size_t(std::count(held_.begin(), held_.end(), 1)); }
  [[nodiscard]] bool any() const { return std::find(held_.begin(), held_.end(), 1) != held_.end(); }
  [[nodiscard]] bool every() const { return std::find(held_.begin(), held_.end(), 0) == held_.end(); }

  void insert(std::size_t tile) { held_[tile] = 1; }
  /// Every tile with a cell of the rectangle, which is cut at the border.
  void insert(const Rect& cells) {
    each_touched(cells, [this](std::size_t tile) { held_[tile] = 1; });
  }
  /// Calls body(number) for every tile with a cell of the rectangle, which is cut at the border, held or not.
  template <class Body>
  void each_touched(const Rect& cells, const Body& body) const {
    const Rect inside = intersection(cells, {0, 0, width_, height_});
    if (inside.empty()) return;
    for (int row = inside.y0 / side_; row <= (inside.y1 - 1) / side_; ++row) {
      for (int column = inside.x0 / side_; column <= (inside.x1 - 1) / side_; ++column) {
        body(std::size_t(row) * std::size_t(columns_) + std::size_t(column));
      }
    }
  }
  /// The tile of a cell by its index in a grid of the raster's size.
  void insert_cell(std::size_t cell) {
    const int x = int(cell % std::size_t(width_));
    const int y = int(cell / std::size_t(width_));
    held_[std::size_t(y / side_) * std::size_t(columns_) + std::size_t(x / side_)] = 1;
  }
  TileSet& operator|=(const TileSet& other) {
    assert(other.held_.size() == held_.size() && other.side_ == side_);
    for (std::size_t i = 0; i < held_.size(); ++i) held_[i] |= other.held_[i];
    return *this;
  }
  TileSet& operator&=(const TileSet& other) {
    assert(other.held_.size() == held_.size() && other.side_ == side_);
    for (std::size_t i = 0; i < held_.size(); ++i) held_[i] &= other.held_[i];
    return *this;
  }
  TileSet& operator-=(const TileSet& other) {
    assert(other.held_.size() == held_.size() && other.side_ == side_);
    for (std::size_t i = 0; i < held_.size(); ++i) held_[i] &= std::uint8_t(other.held_[i] ^ 1);
    return *this;
  }
  bool operator==(const TileSet&) const = default;

  /// The cells of a tile, cut at the border.
  [[nodiscard]] Rect rect(std::size_t tile) const {
    const int x0 = int(tile % std::size_t(columns_)) * side_;
    const int y0 = int(tile / std::size_t(columns_)) * side_;
    return {x0, y0, std::min(x0 + side_, width_), std::min(y0 + side_, height_)};
  }
  /// Numbers of the tiles, ascending.
  [[nodiscard]] std::vector<std::size_t> list() const {
    std::vector<std::size_t> tiles;
    for (std::size_t i = 0; i < held_.size(); ++i) {
      if (held_[i] != 0) tiles.push_back(i);
    }
    return tiles;
  }
  /// These tiles and all with a cell within so many cells of one of them.
  [[nodiscard]] TileSet grown(int cells) const {
    TileSet more(width_, height_, side_);
    for (const std::size_t tile : list()) more.insert(biotope::grown(rect(tile), cells));
    return more;
  }
  /// The same cells in tiles of a side that divides this one.
  [[nodiscard]] TileSet in_tiles_of(int side) const {
    if (side == side_) return *this;
    assert(side_ % side == 0);
    TileSet smaller(width_, height_, side);
    for (const std::size_t tile : list()) smaller.insert(rect(tile));
    return smaller;
  }

 private:
  int width_ = 0;
  int height_ = 0;
  int side_ = tile_side;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> held_;
};

[[nodiscard]] inline TileSet operator|(TileSet a, const TileSet& b) { return a |= b; }
[[nodiscard]] inline TileSet operator&(TileSet a, const TileSet& b) { return a &= b; }
[[nodiscard]] inline TileSet operator-(TileSet a, const TileSet& b) { return a -= b; }

}  // namespace biotope
