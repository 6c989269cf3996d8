#include <algorithm>
#include <cstdlib>
#include <limits>

#include "core/movement/fine_path.hpp"

namespace biotope {
namespace {

/// Eight neighbours, and the eight a knight's move away: ways bend in steps of about 22 degrees.
constexpr std::array<PathCell, 16> directions{{{1, 0},
                                               {1, 1},
                                               {0, 1},
                                               {-1, 1},
                                               {-1, 0},
                                               {-1, -1},
                                               {0, -1},
                                               {1, -1},
                                               {2, 1},
                                               {1, 2},
                                               {-1, 2},
                                               {-2, 1},
                                               {-2, -1},
                                               {-1, -2},
                                               {1, -2},
                                               {2, -1}}};
constexpr float unreached = std::numeric_limits<float>::infinity();
/// What is left of the way is guessed to cost as much a metre as ground that is easy but for tussocks, or nearly as much as the
/// straight line does: close to what it does cost, so that the search looks at little beside its way, though it may miss a
/// slightly cheaper one. Our choice.
constexpr double easy_guess = 1.45;
constexpr double straight_guess = 0.85;
constexpr double highest_guess = 3;
/// By what a tube holds of a cell.
constexpr std::array<float, 4> open_factors{unreached, PlacedGround::factors[0], PlacedGround::factors[1],
                                            PlacedGround::factors[2]};

/// The cells of a tube.
struct OpenCells {
  Rect cells;
  /// 0 where the ground is blocked or not in the tube, else 1 and what was placed there; rows of `cells`.
  std::vector<std::uint8_t> open;
};

/// A* on the cells that lie a whole number of strides from the start, inside the tube around a coarse way.
class TubeSearch {
 public:
  TubeSearch(const FineGround& ground, const OpenCells& tube, PathCell from, PathCell to, int stride)
      : ground_(ground), tube_(tube), stride_(stride), from_(from), to_(to) {
    const Rect& cells = tube.cells;
    // First lattice cell in the window that is a whole number of strides from the start.
    origin_ = {cells.x0 + (from.x - cells.x0) % stride, cells.y0 + (from.y - cells.y0) % stride};
    columns_ = (cells.x1 - origin_.x + stride - 1) / stride;
    rows_ = (cells.y1 - origin_.y + stride - 1) / stride;
    best_.assign(std::size_t(columns_) * std::size_t(rows_), unreached);
    came_.assign(best_.size(), 0xff);
    const auto point = [](PathCell c) { return PathPoint{float(c.x), float(c.y)}; };
    const double metres = std::hypot(double(to.x - from.x), double(to.y - from.y)) * ground.cell_size();
    const double straight =
        std::min(highest_guess, straight_guess * ground.walk_along(point(from), point(to)) / std::max(metres, 1e-3));
    guess_ = float(std::max(easy_guess * double(ground.walk().easiest()), straight) * ground.cell_size());
    for (std::size_t d = 0; d < directions.size(); ++d) moves_[d] = move_along(directions[d]);
  }

  std::vector<PathCell> run() {
    push(index_of(from_), from_, 0, 0xff);
    while (!heap_.empty()) {
      const auto [estimate, index, cost] = pop();
      if (cost > best_[index]) continue;
      const PathCell at = cell_of(index);
      if (arrives(at)) return trace(index);
      // A greedy guess may find a cell again cheaper; it is not opened twice.
      best_[index] = -unreached;
      expand(at, index, cost);
    }
    return {};
  }

 private:
  struct Entry {
    float estimate;
    std::uint32_t index;
    float cost;
    /// Order of a heap whose top is the smallest estimate, then the smallest index.
    bool operator<(const Entry& other) const {
      return estimate != other.estimate ? estimate > other.estimate : index > other.index;
    }
  };
  /// A step of the search and what must be passable for it: offsets in the tube's grid.
  struct Move {
    PathCell step;
    float run = 0;  ///< m
    float least = 0;
    std::int64_t index = 0;
    std::vector<std::int32_t> over;
  };

  [[nodiscard]] Move move_along(PathCell direction) const {
    Move move;
    move.step = {direction.x * stride_, direction.y * stride_};
    move.run = std::sqrt(float(direction.x * direction.x + direction.y * direction.y)) * float(stride_ * ground_.cell_size());
    move.least = move.run * ground_.walk().easiest();
    move.index = direction.x + std::int64_t(direction.y) * columns_;
    const auto add = [&](int x, int y) {
      const auto offset = std::int32_t(y * tube_.cells.width() + x);
      if (std::find(move.over.begin(), move.over.end(), offset) == move.over.end()) move.over.push_back(offset);
    };
    add(move.step.x, move.step.y);
    const int span = std::max(std::abs(move.step.x), std::abs(move.step.y));
    // Cells on both sides of the line, so that no blocked corner is cut.
    for (int i = 1; i <= 4 * span; ++i) {
      const double t = (i - 0.5) / (4 * span);
      for (const double side : {-0.15, 0.15}) {
        add(int(std::lround(t * move.step.x + side)), int(std::lround(t * move.step.y)));
        add(int(std::lround(t * move.step.x)), int(std::lround(t * move.step.y + side)));
      }
    }
    return move;
  }

  [[nodiscard]] std::uint32_t index_of(PathCell c) const {
    return std::uint32_t((c.y - origin_.y) / stride_) * std::uint32_t(columns_) + std::uint32_t((c.x - origin_.x) / stride_);
  }
  [[nodiscard]] PathCell cell_of(std::uint32_t index) const {
    return {origin_.x + int(index % std::uint32_t(columns_)) * stride_,
            origin_.y + int(index / std::uint32_t(columns_)) * stride_};
  }
  [[nodiscard]] std::size_t tube_index(PathCell c) const {
    return std::size_t(c.y - tube_.cells.y0) * std::size_t(tube_.cells.width()) + std::size_t(c.x - tube_.cells.x0);
  }

  [[nodiscard]] float guess_from(PathCell c) const {
    const auto dx = float(c.x - to_.x);
    const auto dy = float(c.y - to_.y);
    return guess_ * std::sqrt(dx * dx + dy * dy);
  }

  [[nodiscard]] bool arrives(PathCell c) const {
    if (std::abs(c.x - to_.x) >= stride_ || std::abs(c.y - to_.y) >= stride_) return false;
    return c == to_ || ground_.clear({float(c.x), float(c.y)}, {float(to_.x), float(to_.y)});
  }

  void push(std::uint32_t index, PathCell at, float cost, std::uint8_t came) {
    best_[index] = cost;
    came_[index] = came;
    heap_.push_back({cost + guess_from(at), index, cost});
    std::push_heap(heap_.begin(), heap_.end());
  }
  Entry pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry top = heap_.back();
    heap_.pop_back();
    return top;
  }

  void expand(PathCell at, std::uint32_t index, float cost) {
    const Grid<float>& height = ground_.height();
    const float here = height(at.x, at.y);
    const std::uint8_t* const open = tube_.open.data() + tube_index(at);
    for (std::uint8_t d = 0; d < directions.size(); ++d) {
      const Move& move = moves_[d];
      const PathCell next{at.x + move.step.x, at.y + move.step.y};
      if (!tube_.cells.contains(next.x, next.y) || !open[move.over.front()]) continue;
      const auto next_index = std::uint32_t(std::int64_t(index) + move.index);
      const float factor = open_factors[open[move.over.front()]];
      if (cost + move.least * factor >= best_[next_index]) continue;
      if (!std::all_of(move.over.begin(), move.over.end(), [open](std::int32_t offset) { return open[offset] != 0; })) continue;
      const std::size_t cell = height.index(next.x, next.y);
      float there = factor * move.run * ground_.walk()((height[cell] - here) / move.run);
      if (ground_.wet(cell)) there *= wading_factor;
      if (cost + there >= best_[next_index]) continue;
      there *= unevenness(next, ground_.cell_size());
      if (cost + there < best_[next_index]) push(next_index, next, cost + there, d);
    }
  }

  [[nodiscard]] std::vector<PathCell> trace(std::uint32_t index) const {
    std::vector<PathCell> path;
    if (cell_of(index) != to_) path.push_back(to_);
    while (true) {
      path.push_back(cell_of(index));
      if (came_[index] == 0xff) break;
      index = std::uint32_t(std::int64_t(index) - moves_[came_[index]].index);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const FineGround& ground_;
  const OpenCells& tube_;
  int stride_;
  PathCell from_;
  PathCell to_;
  float guess_ = 1;  ///< a cell
  PathCell origin_;
  int columns_ = 0;
  int rows_ = 0;
  std::array<Move, directions.size()> moves_;
  std::vector<float> best_;
  std::vector<std::uint8_t> came_;
  std::vector<Entry> heap_;
};

}  // namespace

Tube tube_around(const FineGround& ground, std::span<const PathCell> over, PathCell from, PathCell to) {
  const Rect all = ground.height().rect();
  const int block = ground.block();
  Rect blocks{from.x / block, from.y / block, from.x / block + 1, from.y / block + 1};
  std::vector<PathCell> marked{{from.x / block, from.y / block}, {to.x / block, to.y / block}};
  for (const PathCell& c : over) marked.push_back({c.x / block, c.y / block});
  for (const PathCell& c : marked) blocks = bounding(blocks, {c.x, c.y, c.x + 1, c.y + 1});
  blocks = intersection(grown(blocks, 1), {0, 0, (all.x1 + block - 1) / block, (all.y1 + block - 1) / block});
  Grid<std::uint8_t> inside(blocks.width(), blocks.height());
  for (const PathCell& c : marked) {
    const Rect near = intersection(blocks, {c.x - 1, c.y - 1, c.x + 2, c.y + 2});
    for (int y = near.y0; y < near.y1; ++y) {
      for (int x = near.x0; x < near.x1; ++x) inside(x - blocks.x0, y - blocks.y0) = 1;
    }
  }
  Tube tube{intersection(all, {blocks.x0 * block, blocks.y0 * block, blocks.x1 * block, blocks.y1 * block}), {}};
  for (int y = blocks.y0; y < blocks.y1; ++y) {
    for (int x = blocks.x0; x < blocks.x1; ++x) {
      if (inside(x - blocks.x0, y - blocks.y0)) tube.blocks.push_back({x, y});
    }
  }
  return tube;
}

std::vector<PathCell> fine_path(const FineGround& ground, const Tube& tube, PathCell from, PathCell to) {
  if (!ground.passable(from.x, from.y) || !ground.passable(to.x, to.y)) return {};
  if (from == to) return {from};
  const auto width = std::size_t(tube.cells.width());
  OpenCells cells{tube.cells, std::vector<std::uint8_t>(width * std::size_t(tube.cells.height()), 0)};
  for (const PathCell& block : tube.blocks) {
    const auto row = std::size_t(block.y * ground.block() - tube.cells.y0);
    const auto column = std::size_t(block.x * ground.block() - tube.cells.x0);
    ground.mark_block(block, cells.open.data() + row * width + column, width);
  }
  std::vector<PathCell> path;
  if (ground.stride() > 1) path = TubeSearch(ground, cells, from, to, ground.stride()).run();
  if (path.empty()) path = TubeSearch(ground, cells, from, to, 1).run();
  return path;
}

std::vector<PathCell> fine_path(const FineGround& ground, std::span<const PathCell> over, PathCell from, PathCell to) {
  return fine_path(ground, tube_around(ground, over, from, to), from, to);
}

}  // namespace biotope
