#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ecosystem/confinement.hpp"
#include "core/movement/placed_ground.hpp"
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

/// The fine ground under the feet of the mobilities of one or several travel graphs together: passable only where all of them can
/// be.
class FineGround {
 public:
  /// Graphs have blocks of one size; they and the ground must outlive this, and so must what was placed (may be null); `walk` is
  /// the cost for the mobility that counts most. Paths go in steps of `step` metres, at least one cell and at most eight.
  FineGround(const Ground& ground, std::vector<const TravelGraph*> graphs, const WalkCost& walk, double step,
             const PlacedGround* placed = nullptr);

  [[nodiscard]] bool passable(int x, int y) const { return height_->contains(x, y) && open(x, y); }
  /// The same of a cell on the grid.
  [[nodiscard]] bool open(int x, int y) const {
    for (const auto* graph : graphs_) {
      if (!graph->vertex_of_cell.open(x, y)) return false;
    }
    return true;
  }
  /// Side of a block, cells.
  [[nodiscard]] int block() const { return graphs_.front()->block; }
  /// Writes for every cell of a block: 0 where it is blocked, else 1 and what was placed there (PlacedGround::Mark). Its first
  /// cell goes to `out`, each row `pitch` cells after the one before.
  void mark_block(PathCell number, std::uint8_t* out, std::size_t pitch) const;
  /// A hash of what mark_block writes: equal for equal graphs and marks.
  [[nodiscard]] std::uint64_t block_key(PathCell number) const;
  [[nodiscard]] bool passable(PathPoint p) const { return passable(nearest_cell(p.x), nearest_cell(p.y)); }
  /// Whether the straight line enters no blocked cell, not even at a corner.
  [[nodiscard]] bool clear(PathPoint a, PathPoint b) const;
  /// Whether it enters a forbidden one, and whether it enters neither.
  [[nodiscard]] bool forbids(PathPoint a, PathPoint b) const { return placed_ && placed_->forbids(a, b); }
  [[nodiscard]] bool allows(PathPoint a, PathPoint b) const { return clear(a, b) && !forbids(a, b); }

  [[nodiscard]] bool wet(std::size_t cell) const { return water_ && (*water_)[cell] > 0; }
  [[nodiscard]] const Grid<float>& height() const { return *height_; }
  [[nodiscard]] const WalkCost& walk() const { return walk_; }
  [[nodiscard]] double cell_size() const { return cell_size_; }
  [[nodiscard]] int stride() const { return stride_; }
  /// Metres of flat walking from one point to another close by.
  [[nodiscard]] double walk_between(PathPoint a, PathPoint b) const;
  /// What counts in choosing a way: the same along a straight line of any length, times PlacedGround::factors.
  [[nodiscard]] double walk_along(PathPoint a, PathPoint b) const;

 private:
  [[nodiscard]] Rect cells_of(PathCell number) const {
    return intersection(height_->rect(),
                        {number.x * block(), number.y * block(), (number.x + 1) * block(), (number.y + 1) * block()});
  }
  [[nodiscard]] static std::uint64_t open_cells(const TravelGraph& graph, PathCell number) {
    return graph.open_cells[std::size_t(number.y) * std::size_t(graph.columns) + std::size_t(number.x)];
  }

  std::vector<const TravelGraph*> graphs_;
  const Grid<float>* height_;
  const Grid<float>* water_;
  WalkCost walk_;
  double cell_size_;
  int stride_;
  const PlacedGround* placed_;
};

/// Unevenness underfoot (tussocks, stones) that a height grid does not hold: a cost factor of 1 to 1.6 that varies smoothly over
/// about 45 m. It gives ways over even ground their bends, and is the same for all who walk there. Our choice.
[[nodiscard]] float unevenness(PathCell cell, double cell_size);

/// Cells near a coarse way where a search looks for the fine one: within the blocks of the way and their neighbours.
struct Tube {
  Rect cells;
  /// Blocks that are open, row by row.
  std::vector<PathCell> blocks;
};
[[nodiscard]] Tube tube_around(const FineGround& ground, std::span<const PathCell> over, PathCell from, PathCell to);

/// A cheap way on the fine grid from `from` to `to` inside a tube (16 neighbours, A* with a slightly greedy guess; steps of
/// FineGround::stride cells where that succeeds, else of one). Empty when there is none. Passable ends are needed.
[[nodiscard]] std::vector<PathCell> fine_path(const FineGround& ground, const Tube& tube, PathCell from, PathCell to);
[[nodiscard]] std::vector<PathCell> fine_path(const FineGround& ground, std::span<const PathCell> over, PathCell from,
                                              PathCell to);

[[nodiscard]] std::vector<PathPoint> points_of(std::span<const PathCell> cells);

/// A path as a smooth line of as many points: rounded corners, then Catmull-Rom splines, wherever that enters no blocked or
/// forbidden cell; less smooth, down to the path itself, where it would. Ends stay where they are.
[[nodiscard]] std::vector<PathPoint> smooth_path(const FineGround& ground, std::vector<PathPoint> points);

/// Rounds the corners of a path, wherever that enters no blocked or forbidden cell, but for points marked 1 in `fixed` (a number
/// a point) and the ends.
void round_path(const FineGround& ground, std::span<const std::uint8_t> fixed, std::vector<PathPoint>& points);

}  // namespace biotope
