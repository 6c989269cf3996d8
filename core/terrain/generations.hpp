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

/// A dense copy of which versions can be made, by many threads.
template <class T>
[[nodiscard]] Grid<T> copy_of(const Grid<T>& from) {
  Grid<T> to = Grid<T>::shareable(from.width(), from.height());
  parallel_rows(0, from.height(), [&](int y) { std::copy_n(from.row(y).data(), from.row(y).size(), to.row(y).data()); });
  return to;
}

/// The last versions of something made of dense rasters, of which others hold pointers. The next version is made from the newest:
/// in the memory of one that nobody else holds any more, where only the tiles that changed since have to be copied; or as a fork
/// of the first version's rasters (see SharedPages), to which the tiles that changed since are copied; or else, when these are
/// many, in a whole copy, which is the next first version. `Copy` has
///   bool fork(const T&, T&)                 rasters that share their memory with the first version's; whether that can be done
///   T value(const T&)                       a whole copy
///   void tiles(const T&, T&, const TileSet&)  copies some tiles, and all that is no raster.
template <class T, class Copy>
class Generations {
 public:
  [[nodiscard]] std::shared_ptr<const T> newest() const { return newest_; }
  [[nodiscard]] explicit operator bool() const { return newest_ != nullptr; }

  /// Forgets everything before `value`.
  void restart(std::shared_ptr<T> value) {
    older_.clear();
    since_first_ = {};
    newest_ = std::move(value);
  }
  /// A copy of the newest that only the caller holds. Lost unless it comes back by `put`.
  [[nodiscard]] std::shared_ptr<T> copy() {
    whole_ = false;
    if (auto value = reused()) return value;
    const bool few = 4 * since_first_.count() <= since_first_.tile_count();
    if (auto value = std::make_shared<T>(); few && Copy::fork(*newest_, *value)) {
      Copy::tiles(*newest_, *value, since_first_);
      return value;
    }
    older_.clear();
    whole_ = true;
    return std::make_shared<T>(Copy::value(*newest_));
  }
  /// Makes a changed copy the newest; one in which no tile changed is kept for the next time.
  void put(std::shared_ptr<T> value, const TileSet& changed) {
    if (!changed.any()) {
      if (!whole_) older_.push_back({std::move(value), changed});
    } else if (whole_) {
      since_first_ = {};
      newest_ = std::move(value);
    } else {
      const bool first = since_first_.tile_count() == 0;
      for (Older& one : older_) one.behind |= changed;
      // Into the first version nothing is written any more: its forks show it.
      if (!first) older_.push_back({std::move(newest_), changed});
      since_first_ = first ? changed : since_first_ | changed;
      newest_ = std::move(value);
    }
    if (older_.size() > most_older) older_.erase(older_.begin());
  }
  /// Gives back the memory that only waits for another version.
  void release_unused() {
    std::erase_if(older_, [](const Older& one) { return one.value.use_count() == 1; });
  }

 private:
  static constexpr std::size_t most_older = 2;
  struct Older {
    std::shared_ptr<T> value;
    TileSet behind;  ///< tiles in which the newest is another
  };

  /// An older version that nobody else holds, brought up to date; or null.
  [[nodiscard]] std::shared_ptr<T> reused() {
    const auto unused = std::find_if(older_.begin(), older_.end(), [](const Older& one) { return one.value.use_count() == 1; });
    if (unused == older_.end()) return nullptr;
    // What the last other owner read happened before it let go.
    std::atomic_thread_fence(std::memory_order_acquire);
    const Older found = std::move(*unused);
    older_.erase(unused);
    Copy::tiles(*newest_, *found.value, found.behind);
    return found.value;
  }

  std::shared_ptr<T> newest_;
  /// Versions that were forked from the same first one as the newest.
  std::vector<Older> older_;
  /// Tiles in which the newest may differ from that first one; of no raster as long as it is the first.
  TileSet since_first_;
  /// Whether the copy that is out is a whole one.
  bool whole_ = false;
};

/// Forks a raster; whether that could be done.
template <class T>
[[nodiscard]] bool fork_of(const Grid<T>& from, Grid<T>& to) {
  to = from.fork();
  return !to.empty();
}

template <class T>
struct GridCopy {
  static bool fork(const Grid<T>& from, Grid<T>& to) { return fork_of(from, to); }
  static Grid<T> value(const Grid<T>& from) { return copy_of(from); }
  static void tiles(const Grid<T>& from, Grid<T>& to, const TileSet& tiles) { copy_tiles(from, to, tiles); }
};
template <class T>
using GridGenerations = Generations<Grid<T>, GridCopy<T>>;

}  // namespace biotope
