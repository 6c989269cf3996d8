#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/parallel.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// In which tiles a raster changed from one version to the next, so that whoever read an older version knows what to read again.
class ChangeLog {
 public:
  /// Of tiles of this side.
  explicit ChangeLog(int side = tile_side) : side_(side) {}

  /// Versions count from 1; who saw none says 0.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// A new version that differs from the one before in some tiles.
  void note(TileSet changed) {
    assert(changed.side() == side_);
    ++version_;
    size_ = {changed.width(), changed.height()};
    steps_.push_back(std::move(changed));
    if (steps_.size() > longest) steps_.pop_front();
  }
  /// A new version, perhaps of another size, of which nothing is known.
  void note_all(int width, int height) {
    ++version_;
    size_ = {width, height};
    steps_.clear();
  }
  /// Tiles in which the version of now may differ from version `seen`: all of them when that is long ago.
  [[nodiscard]] TileSet since(std::uint64_t seen) const {
    if (seen == 0 || version_ - seen > steps_.size()) return TileSet::all(size_.first, size_.second, side_);
    TileSet tiles(size_.first, size_.second, side_);
    for (std::size_t i = steps_.size() - std::size_t(version_ - seen); i < steps_.size(); ++i) tiles |= steps_[i];
    return tiles;
  }

 private:
  static constexpr std::size_t longest = 64;
  int side_;
  std::uint64_t version_ = 0;
  std::pair<int, int> size_{0, 0};
  std::deque<TileSet> steps_;
};

/// Copies some tiles of one grid into another of the same size.
template <class T>
void copy_tiles(const Grid<T>& from, Grid<T>& to, const TileSet& tiles) {
  const auto list = tiles.list();
  parallel_each(list.size(), [&](std::size_t i) {
    const Rect rect = tiles.rect(list[i]);
    for (int y = rect.y0; y < rect.y1; ++y) std::copy_n(from.row(y).data() + rect.x0, rect.width(), to.row(y).data() + rect.x0);
  });
}

/// A dense copy, by many threads.
template <class T>
[[nodiscard]] Grid<T> copy_of(const Grid<T>& from) {
  Grid<T> to(from.width(), from.height());
  parallel_rows(0, from.height(), [&](int y) { std::copy_n(from.row(y).data(), from.row(y).size(), to.row(y).data()); });
  return to;
}

/// The last versions of something made of dense rasters, of which others hold pointers. The next version is made from the newest:
/// in the memory of one that nobody else holds any more, where only the tiles that changed since have to be copied, or else in a
/// whole copy. `Copy` has value(const T&) for a whole copy and tiles(const T&, T&, const TileSet&) for some.
template <class T, class Copy>
class Generations {
 public:
  [[nodiscard]] std::shared_ptr<const T> newest() const { return newest_; }
  [[nodiscard]] explicit operator bool() const { return newest_ != nullptr; }

  /// Forgets everything before `value`.
  void restart(std::shared_ptr<T> value) {
    older_.clear();
    newest_ = std::move(value);
  }
  /// A copy of the newest that only the caller holds. Lost unless it comes back by `put`.
  [[nodiscard]] std::shared_ptr<T> copy() {
    for (auto it = older_.begin(); it != older_.end(); ++it) {
      if (it->value.use_count() != 1) continue;
      // What the last other owner read happened before it let go.
      std::atomic_thread_fence(std::memory_order_acquire);
      const Older found = std::move(*it);
      older_.erase(it);
      Copy::tiles(*newest_, *found.value, found.behind);
      return found.value;
    }
    return std::make_shared<T>(Copy::value(*newest_));
  }
  /// Makes a changed copy the newest; one in which no tile changed is kept for the next time.
  void put(std::shared_ptr<T> value, const TileSet& changed) {
    if (!changed.any()) {
      older_.push_back({std::move(value), changed});
    } else {
      for (Older& one : older_) one.behind |= changed;
      older_.push_back({std::move(newest_), changed});
      newest_ = std::move(value);
    }
    if (older_.size() > most_older) older_.erase(older_.begin());
  }
  /// Gives back the memory that only waits for another version.
  void release_unused() {
    std::erase_if(older_, [](const Older& one) { return one.value.use_count() == 1; });
  }

 private:
  static constexpr std::size_t most_older = 3;
  struct Older {
    std::shared_ptr<T> value;
    TileSet behind;  ///< tiles in which the newest is another
  };
  std::shared_ptr<T> newest_;
  std::vector<Older> older_;
};

template <class T>
struct GridCopy {
  static Grid<T> value(const Grid<T>& from) { return copy_of(from); }
  static void tiles(const Grid<T>& from, Grid<T>& to, const TileSet& tiles) { copy_tiles(from, to, tiles); }
};
template <class T>
using GridGenerations = Generations<Grid<T>, GridCopy<T>>;

}  // namespace biotope
