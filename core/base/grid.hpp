#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/rect.hpp"

namespace biotope {

/// A dense raster: a value type of width x height cells in row-major order, row 0 at the north.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int width, int height, T value = T{})
      : width_(width), height_(height), cells_(std::size_t(width) * std::size_t(height), value) {
    assert(width >= 0 && height >= 0);
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] bool empty() const { return cells_.empty(); }
  [[nodiscard]] Rect rect() const { return {0, 0, width_, height_}; }
  [[nodiscard]] bool contains(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }

  [[nodiscard]] std::size_t index(int x, int y) const {
    assert(contains(x, y));
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  [[nodiscard]] T& operator()(int x, int y) { return cells_[index(x, y)]; }
  [[nodiscard]] const T& operator()(int x, int y) const { return cells_[index(x, y)]; }
  [[nodiscard]] T& operator[](std::size_t i) { return cells_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return cells_[i]; }

  /// The cell at (x, y) with coordinates moved to the nearest cell inside the grid.
  [[nodiscard]] const T& clamped(int x, int y) const {
    return (*this)(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1));
  }

  [[nodiscard]] std::span<T> row(int y) {
    return {cells_.data() + std::size_t(y) * std::size_t(width_), std::size_t(width_)};
  }
  [[nodiscard]] std::span<const T> row(int y) const {
    return {cells_.data() + std::size_t(y) * std::size_t(width_), std::size_t(width_)};
  }
  [[nodiscard]] std::span<T> cells() { return cells_; }
  [[nodiscard]] std::span<const T> cells() const { return cells_; }

  bool operator==(const Grid&) const = default;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<T> cells_;
};

/// Bilinear sample at cell coordinates (0, 0 is the centre of the north-west cell), clamped at the border.
[[nodiscard]] inline float sample_bilinear(const Grid<float>& grid, double x, double y) {
  const double cx = std::clamp(x, 0.0, double(grid.width() - 1));
  const double cy = std::clamp(y, 0.0, double(grid.height() - 1));
  const int ix = std::min(int(cx), std::max(0, grid.width() - 2));
  const int iy = std::min(int(cy), std::max(0, grid.height() - 2));
  const float fx = float(cx - ix);
  const float fy = float(cy - iy);
  const float north = grid(ix, iy) * (1 - fx) + grid.clamped(ix + 1, iy) * fx;
  const float south = grid.clamped(ix, iy + 1) * (1 - fx) + grid.clamped(ix + 1, iy + 1) * fx;
  return north * (1 - fy) + south * fy;
}

}  // namespace biotope
