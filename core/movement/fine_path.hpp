#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ecosystem/confinement.hpp"
#include "core/movement/trails.hpp"
#include "core/movement/walk_cost.hpp"

namespace biotope {

/// A cell a path goes through.
struct PathCell {
  int x = 0;
  int y = 0;
  bool operator==(const PathCell&) const = default;
};

/// Column or row of the cell that holds a coordinate not below -1.
[[nodiscard]] inline int nearest_cell(float coordinate) { return int(coordinate + 1.5F) - 1; }
[[nodiscard]] inline PathCell cell_at(PathPoint point) { return {nearest_cell(point.x), nearest_cell(point.y)}; }

/// Steps of the paths that become trails, and of herds' walks between resources, m. Our choice.
inline constexpr double trail_step = 6;
inline constexpr double plan_step = 9;

/// The fine ground under the feet of one or several mobilities together: passable only where all of them can be.
class FineGround {
 public:
  /// The grids must outlive this; `walk` is the cost for the mobility that counts most. Paths go in steps of `step` metres, at least one cell
  /// and at most eight.
  FineGround(const Ground& ground, std::vector<const Grid<std::int32_t>*> regions, const WalkCost& walk, double step);

  [[nodiscard]] bool passable(int x, int y) const {
    if (!regions_.front()->contains(x, y)) return false;
    return passable(regions_.front()->index(x, y));
  }
  [[nodiscard]] bool passable(std::size_t cell) const {
    for (const auto* region : regions_) {
      if ((*region)[cell] < 0) return false;
    }
    return true;
  }
  /// Writes 1 for every passable cell of a piece of row y that begins at x, else 0.
  void mark_passable(int x, int y, std::span<std::uint8_t> out) const {
    std::fill(out.begin(), out.end(), std::uint8_t(1));
    for (const auto* region : regions_) {
      const auto cells = region->row(y).subspan(std::size_t(x), out.size());
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::uint8_t(out[i] & std::uint8_t(cells[i] >= 0));
    }
  }
  [[nodiscard]] bool passable(PathPoint p) const { return passable(nearest_cell(p.x), nearest_cell(p.y)); }
  /// Whether the straight line enters no blocked cell (sampled closer than half a cell).
  [[nodiscard]] bool clear(PathPoint a, PathPoint b) const;

  [[nodiscard]] bool wet(std::size_t cell) const { return water_ && (*water_)[cell] > 0; }
  [[nodiscard]] const Grid<float>& height() const { return *height_; }
  [[nodiscard]] const WalkCost& walk() const { return walk_; }
  [[nodiscard]] double cell_size() const { return cell_size_; }
  [[nodiscard]] int stride() const { return stride_; }
  /// Metres of flat walking from one point to another close by, and along a straight line of any length.
  [[nodiscard]] double walk_along(PathPoint a, PathPoint b) const;
  [[nodiscard]] double walk_between(PathPoint a, PathPoint b) const;

 private:
  std::vector<const Grid<std::int32_t>*> regions_;
  const Grid<float>* height_;
  const Grid<float>* water_;
  WalkCost walk_;
  double cell_size_;
  int stride_;
};

/// Unevenness underfoot (tussocks, stones) that a height grid does not hold: a cost factor of 1 to 1.6 that varies smoothly over about 45 m. It gives ways
/// over even ground their bends, and is the same for all who walk there. Our choice.
[[nodiscard]] float unevenness(PathCell cell, double cell_size);

/// Cells near a coarse way where a search looks for the fine one: within the blocks of the way and their neighbours.
struct Tube {
  Rect cells;
  /// 1 where the ground is passable and in the tube; rows of `cells`.
  std::vector<std::uint8_t> open;
};
[[nodiscard]] Tube tube_around(const FineGround& ground, int block, std::span<const PathCell> over, PathCell from, PathCell to);

/// A cheap way on the fine grid from `from` to `to` inside a tube (16 neighbours, A* with a slightly greedy guess; steps of
/// FineGround::stride cells where that succeeds, else of one). Empty when there is none. Passable ends are needed.
[[nodiscard]] std::vector<PathCell> fine_path(const FineGround& ground, const Tube& tube, PathCell from, PathCell to);
[[nodiscard]] std::vector<PathCell> fine_path(const FineGround& ground, int block, std::span<const PathCell> over, PathCell from, PathCell to);

[[nodiscard]] std::vector<PathPoint> points_of(std::span<const PathCell> cells);

/// A path as a smooth line of as many points: rounded corners, then Catmull-Rom splines, wherever that enters no blocked cell; less smooth, down to
/// the path itself, where it would. Ends stay where they are.
[[nodiscard]] std::vector<PathPoint> smooth_path(const FineGround& ground, std::vector<PathPoint> points);

/// Rounds the corners of a path, wherever that enters no blocked cell, but for points marked 1 in `fixed` (a number a point) and the ends.
void round_path(const FineGround& ground, std::span<const std::uint8_t> fixed, std::vector<PathPoint>& points);

}  // namespace biotope
