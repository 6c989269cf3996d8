#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/rect.hpp"

namespace biotope {

/// Side of a tile of every TiledMap, in cells.
inline constexpr int tile_side = 64;

/// A raster of shared, immutable tiles: copying a map copies pointers, writing a tile replaces its pointer.
/// Two maps that hold the same pointer hold the same cells, which is what undo, snapshots and backdating
/// rely on. A null tile holds `background` everywhere. Cells of a border tile outside the map hold background.
template <class T>
class TiledMap {
 public:
  using Tile = std::array<T, std::size_t(tile_side) * tile_side>;
  using TilePointer = std::shared_ptr<const Tile>;

  TiledMap() = default;
  TiledMap(int width, int height, T background = T{})
      : width_(width),
        height_(height),
        columns_((width + tile_side - 1) / tile_side),
        rows_((height + tile_side - 1) / tile_side),
        background_(background),
        tiles_(std::size_t(columns_) * std::size_t(rows_)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return tiles_.empty(); }
  [[nodiscard]] Rect rect() const { return {0, 0, width_, height_}; }
  [[nodiscard]] int tile_columns() const { return columns_; }
  [[nodiscard]] int tile_rows() const { return rows_; }
  [[nodiscard]] std::size_t tile_count() const { return tiles_.size(); }
  [[nodiscard]] T background() const { return background_; }

  /// Number of the tile that holds cell (x, y).
  [[nodiscard]] std::size_t tile_index(int x, int y) const {
    assert(rect().contains(x, y));
    return std::size_t(y / tile_side) * std::size_t(columns_) + std::size_t(x / tile_side);
  }
  /// The cells that tile `index` covers, cut at the map's border.
  [[nodiscard]] Rect tile_rect(std::size_t index) const {
    const int x0 = int(index % std::size_t(columns_)) * tile_side;
    const int y0 = int(index / std::size_t(columns_)) * tile_side;
    return {x0, y0, std::min(x0 + tile_side, width_), std::min(y0 + tile_side, height_)};
  }
  [[nodiscard]] const TilePointer& tile(std::size_t index) const { return tiles_[index]; }
  void set_tile(std::size_t index, TilePointer tile) { tiles_[index] = std::move(tile); }

  [[nodiscard]] T operator()(int x, int y) const {
    const TilePointer& tile = tiles_[tile_index(x, y)];
    return tile ? (*tile)[offset(x, y)] : background_;
  }

  /// Writes one cell, making the tile its own first if it is shared.
  void set(int x, int y, T value) { edit_tile(tile_index(x, y))[offset(x, y)] = value; }

  /// The tile's cells for writing; copies them first unless this map is the only owner.
  [[nodiscard]] Tile& edit_tile(std::size_t index) {
    TilePointer& pointer = tiles_[index];
    if (!pointer || pointer.use_count() != 1) {
      auto own = std::make_shared<Tile>();
      if (pointer) {
        *own = *pointer;
      } else {
        own->fill(background_);
      }
      pointer = std::move(own);
    }
    return const_cast<Tile&>(*pointer);
  }

  /// Copies columns [x0, x0 + out.size()) of row y into `out`.
  void read_row(int y, int x0, std::span<T> out) const {
    assert(x0 >= 0 && x0 + int(out.size()) <= width_);
    for (std::size_t done = 0; done < out.size();) {
      const int x = x0 + int(done);
      const std::size_t count = std::min(out.size() - done, std::size_t(tile_side - x % tile_side));
      const TilePointer& tile = tiles_[tile_index(x, y)];
      if (tile) {
        std::copy_n(tile->data() + offset(x, y), count, out.data() + done);
      } else {
        std::fill_n(out.data() + done, count, background_);
      }
      done += count;
    }
  }

  /// The whole map as a dense grid.
  [[nodiscard]] Grid<T> to_grid() const {
    Grid<T> grid(width_, height_);
    for (int y = 0; y < height_; ++y) read_row(y, 0, grid.row(y));
    return grid;
  }

  /// Offset of cell (x, y) inside its tile.
  [[nodiscard]] static std::size_t offset(int x, int y) {
    return std::size_t(y % tile_side) * tile_side + std::size_t(x % tile_side);
  }

  /// Bytes held by tiles, shared or not.
  [[nodiscard]] std::size_t bytes() const {
    const auto held = std::count_if(tiles_.begin(), tiles_.end(), [](const auto& t) { return t != nullptr; });
    return std::size_t(held) * sizeof(Tile);
  }

  /// Same size and the same cells; shared tiles are compared by pointer.
  bool operator==(const TiledMap& other) const {
    if (width_ != other.width_ || height_ != other.height_) return false;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      if (!same_tile(tiles_[i], other.tiles_[i], other.background_)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool same_tile(const TilePointer& a, const TilePointer& b, T other_background) const {
    if (a == b) return a || background_ == other_background;
    if (a && b) return *a == *b;
    const T background = a ? other_background : background_;
    const Tile& held = a ? *a : *b;
    return std::all_of(held.begin(), held.end(), [&](const T& cell) { return cell == background; });
  }

  int width_ = 0;
  int height_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  T background_{};
  std::vector<TilePointer> tiles_;
};

/// A tiled copy of a dense grid.
template <class T>
[[nodiscard]] TiledMap<T> tiled(const Grid<T>& grid, T background = T{}) {
  TiledMap<T> map(grid.width(), grid.height(), background);
  for (std::size_t i = 0; i < map.tile_count(); ++i) {
    const Rect rect = map.tile_rect(i);
    auto& tile = map.edit_tile(i);
    for (int y = rect.y0; y < rect.y1; ++y) {
      std::copy_n(grid.row(y).data() + rect.x0, rect.width(), tile.data() + map.offset(rect.x0, y));
    }
  }
  return map;
}

}  // namespace biotope
