#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/ecosystem/confinement.hpp"

namespace biotope {

/// What a person's paint says of a cell.
enum class Passage : std::uint8_t { none, obstacle, passage };

/// An obstacle where the final value is at least 0.5, a passage where it is at most -0.5.
[[nodiscard]] constexpr Passage passage_of(Paint paint) {
  const float value = painted(0, paint);
  return value >= 0.5F ? Passage::obstacle : (value <= -0.5F ? Passage::passage : Passage::none);
}

/// Densest tree cover that an animal pushes through, in 1/full_cover.
[[nodiscard]] inline int most_trees(const Mobility& mobility) {
  return int(std::floor(double(mobility.max_tree_cover) * full_cover + 0.5));
}

/// Obstacles of one kind of animal, row by row. A placed exit opens everything within its radius; else a painted obstacle closes
/// and a painted passage opens whatever the ground is; else slope, water (but for fords) and trees count. The ground must outlive
/// it.
class ObstacleRows {
 public:
  ObstacleRows(const Ground& ground, const Mobility& mobility);

  /// Writes `open` or `closed` for every cell of row y.
  template <class Value>
  void fill_row(int y, std::span<Value> out, Value open, Value closed) const {
    const auto slope = slope_.row(y);
    const auto depth = depth_.row(y);
    for (std::size_t x = 0; x < out.size(); ++x) {
      out[x] = (slope[x] > mobility_.max_slope) | (depth[x] > mobility_.wade_depth) ? closed : open;
    }
    for (const Interval& ford : fords_[std::size_t(y)]) {
      for (int x = ford.x0; x < ford.x1; ++x) out[std::size_t(x)] = slope[std::size_t(x)] > mobility_.max_slope ? closed : open;
    }
    if (trees_ != nullptr) {
      const auto trees = trees_->row(y);
      for (std::size_t x = 0; x < out.size(); ++x) out[x] = trees[x] > max_trees_ ? closed : out[x];
    }
    if (passage_ != nullptr) paint_row(y, out, open, closed);
    if (exits_.empty()) return;
    for (const Interval& exit : exits_[std::size_t(y)]) std::fill(out.begin() + exit.x0, out.begin() + exit.x1, open);
  }

  /// What keeps the animal out of a cell.
  [[nodiscard]] Obstacle at(int x, int y) const;

 private:
  /// Columns [x0, x1) of a row.
  struct Interval {
    int x0 = 0;
    int x1 = 0;
  };
  using Rows = std::vector<std::vector<Interval>>;

  void add_disk(Rows& rows, double x, double y, double radius) const;
  [[nodiscard]] static bool inside(const std::vector<Interval>& row, int x) {
    return std::any_of(row.begin(), row.end(), [&](const Interval& i) { return x >= i.x0 && x < i.x1; });
  }

  /// Lays paint over a row, a tile at a time; tiles without paint cost nothing.
  template <class Value>
  void paint_row(int y, std::span<Value> out, Value open, Value closed) const {
    for (int x0 = 0; x0 < passage_->width(); x0 += tile_side) {
      if (!passage_->tile(passage_->tile_index(x0, y)) && passage_of(passage_->background()) == Passage::none) continue;
      std::array<Paint, tile_side> cells;
      const std::size_t count = std::size_t(std::min(tile_side, passage_->width() - x0));
      passage_->read_row(y, x0, std::span(cells).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        Value& cell = out[std::size_t(x0) + i];
        const Passage passage = passage_of(cells[i]);
        cell = passage == Passage::obstacle ? closed : (passage == Passage::passage ? open : cell);
      }
    }
  }

  const Grid<float>& slope_;
  const Grid<float>& depth_;
  const Grid<Cover>* trees_;
  const PaintLayer* passage_;
  Mobility mobility_;
  int max_trees_;
  Rows fords_;
  /// Empty without exits.
  Rows exits_;
};

}  // namespace biotope
