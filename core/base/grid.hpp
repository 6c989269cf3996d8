#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/rect.hpp"
#include "core/base/shared_pages.hpp"

namespace biotope {

/// The memory of a grid: its own, or pages that versions of one raster share as long as they are the same.
template <class T>
class GridMemory {
 public:
  GridMemory() = default;
  GridMemory(std::size_t size, const T& value) : own_(size, value), data_(own_.data()), size_(size) {}
  GridMemory(SharedPages pages, std::size_t size)
      : pages_(std::move(pages)), data_(static_cast<T*>(pages_.data())), size_(size) {}
  GridMemory(const GridMemory& other) : own_(other.begin(), other.end()), data_(own_.data()), size_(other.size_) {}
  GridMemory(GridMemory&& other) noexcept
      : own_(std::move(other.own_)),
        pages_(std::move(other.pages_)),
        data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)) {}
  GridMemory& operator=(GridMemory other) noexcept {
    std::swap(own_, other.own_);
    std::swap(pages_, other.pages_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~GridMemory() = default;

  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }
  [[nodiscard]] const SharedPages& pages() const { return pages_; }

 private:
  std::vector<T> own_;
  SharedPages pages_;
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

/// A dense raster: a value type of width x height cells in row-major order, row 0 at the north.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int width, int height, T value = T{})
      : width_(width), height_(height), cells_(std::size_t(width) * std::size_t(height), value) {
    assert(width >= 0 && height >= 0);
  }
  /// A raster of zeros of which versions are to be made by fork(); an ordinary one where the system cannot share pages.
  [[nodiscard]] static Grid shareable(int width, int height) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t size = std::size_t(width) * std::size_t(height);
    SharedPages pages = SharedPages::zeroed(size * sizeof(T));
    if (!pages) return Grid(width, height);
    return Grid(width, height, GridMemory<T>(std::move(pages), size));
  }
  /// A version that is equal to the shareable raster this one was forked from, or is itself: cells that this one got since have
  /// to be copied to it. Nothing may be written to that first raster afterwards. An empty grid where it cannot be made.
  [[nodiscard]] Grid fork() const {
    SharedPages pages = cells_.pages().fork();
    if (!pages) return {};
    return Grid(width_, height_, GridMemory<T>(std::move(pages), cells_.size()));
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] bool empty() const { return cells_.size() == 0; }
  [[nodiscard]] Rect rect() const { return {0, 0, width_, height_}; }
  [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  [[nodiscard]] std::size_t index(int x, int y) const {
    assert(contains(x, y));
    return std::size_t(y) * std::size_t(width_) + std::size_t(x);
  }
  [[nodiscard]] T& operator()(int x, int y) { return cells_.data()[index(x, y)]; }
  [[nodiscard]] const T& operator()(int x, int y) const { return cells_.data()[index(x, y)]; }
  [[nodiscard]] T& operator[](std::size_t i) { return cells_.data()[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return cells_.data()[i]; }

  /// The cell at (x, y) with coordinates moved to the nearest cell inside the grid.
  [[nodiscard]] const T& clamped(int x, int y) const {
    return (*this)(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1));
  }

  [[nodiscard]] std::span<T> row(int y) { return {cells_.data() + std::size_t(y) * std::size_t(width_), std::size_t(width_)}; }
  [[nodiscard]] std::span<const T> row(int y) const {
    return {cells_.data() + std::size_t(y) * std::size_t(width_), std::size_t(width_)};
  }
  [[nodiscard]] std::span<T> cells() { return {cells_.data(), cells_.size()}; }
  [[nodiscard]] std::span<const T> cells() const { return {cells_.data(), cells_.size()}; }

  bool operator==(const Grid& other) const {
    return width_ == other.width_ && height_ == other.height_ && std::equal(cells_.begin(), cells_.end(), other.cells_.begin());
  }

 private:
  Grid(int width, int height, GridMemory<T> cells) : width_(width), height_(height), cells_(std::move(cells)) {}

  int width_ = 0;
  int height_ = 0;
  GridMemory<T> cells_;
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
