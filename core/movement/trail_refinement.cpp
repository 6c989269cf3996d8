#include <algorithm>
#include <cstdlib>
#include <limits>

#include "core/base/random.hpp"
#include "core/movement/fine_path.hpp"

namespace biotope {
namespace {

/// Eight neighbours, and the eight a knight's move away: ways bend in steps of about 22 degrees.
constexpr std::array<PathCell, 16> directions{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1},
                                               {2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}}};
constexpr float unreached = std::numeric_limits<float>::infinity();

/// A* on the cells that lie a whole number of strides from the start, inside the tube around a coarse way.
class TubeSearch {
 public:
  TubeSearch(const FineGround& ground, int block, std::span<const PathCell> over, PathCell from, PathCell to, int stride)
      : ground_(ground), block_(block), stride_(stride), from_(from), to_(to) {
    mark_tube(over);
    const Rect cells = intersection(ground.height().rect(), {tube_.x0 * block, tube_.y0 * block, tube_.x1 * block, tube_.y1 * block});
    // First lattice cell in the window that is a whole number of strides from the start.
    origin_ = {cells.x0 + (from.x - cells.x0) % stride, cells.y0 + (from.y - cells.y0) % stride};
    columns_ = (cells.x1 - origin_.x + stride - 1) / stride;
    rows_ = (cells.y1 - origin_.y + stride - 1) / stride;
    best_.assign(std::size_t(columns_) * std::size_t(rows_), unreached);
    came_.assign(best_.size(), 0xff);
  }

  std::vector<PathCell> run() {
    push(index_of(from_), 0, 0xff);
    while (!heap_.empty()) {
      const auto [estimate, index, cost] = pop();
      if (cost > best_[index]) continue;
      const PathCell at = cell_of(index);
      if (arrives(at)) return trace(index);
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

  void mark_tube(std::span<const PathCell> over) {
    tube_ = {from_.x / block_, from_.y / block_, from_.x / block_ + 1, from_.y / block_ + 1};
    const auto include = [&](PathCell c) { tube_ = bounding(tube_, {c.x / block_, c.y / block_, c.x / block_ + 1, c.y / block_ + 1}); };
    for (const PathCell& c : over) include(c);
    include(to_);
    tube_ = grown(tube_, 1);
    const int columns = (ground_.height().width() + block_ - 1) / block_;
    const int rows = (ground_.height().height() + block_ - 1) / block_;
    tube_ = intersection(tube_, {0, 0, columns, rows});
    inside_.assign(std::size_t(tube_.width()) * std::size_t(tube_.height()), 0);
    const auto mark = [&](PathCell c) {
      for (int y = std::max(tube_.y0, c.y / block_ - 1); y < std::min(tube_.y1, c.y / block_ + 2); ++y) {
        for (int x = std::max(tube_.x0, c.x / block_ - 1); x < std::min(tube_.x1, c.x / block_ + 2); ++x) inside_[tube_index(x, y)] = 1;
      }
    };
    for (const PathCell& c : over) mark(c);
    mark(from_);
    mark(to_);
  }
  [[nodiscard]] std::size_t tube_index(int x, int y) const {
    return std::size_t(y - tube_.y0) * std::size_t(tube_.width()) + std::size_t(x - tube_.x0);
  }

  [[nodiscard]] std::uint32_t index_of(PathCell c) const {
    return std::uint32_t((c.y - origin_.y) / stride_) * std::uint32_t(columns_) + std::uint32_t((c.x - origin_.x) / stride_);
  }
  [[nodiscard]] PathCell cell_of(std::uint32_t index) const {
    return {origin_.x + int(index % std::uint32_t(columns_)) * stride_, origin_.y + int(index / std::uint32_t(columns_)) * stride_};
  }

  /// Cost that any way to the goal has at least.
  [[nodiscard]] float at_least(PathCell c) const {
    const auto dx = float(c.x - to_.x);
    const auto dy = float(c.y - to_.y);
    return std::sqrt(dx * dx + dy * dy) * float(ground_.cell_size()) * ground_.walk().easiest();
  }

  [[nodiscard]] bool arrives(PathCell c) const {
    if (std::abs(c.x - to_.x) >= stride_ || std::abs(c.y - to_.y) >= stride_) return false;
    return c == to_ || ground_.clear({float(c.x), float(c.y)}, {float(to_.x), float(to_.y)});
  }

  void push(std::uint32_t index, float cost, std::uint8_t came) {
    best_[index] = cost;
    came_[index] = came;
    heap_.push_back({cost + at_least(cell_of(index)), index, cost});
    std::push_heap(heap_.begin(), heap_.end());
  }
  Entry pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry top = heap_.back();
    heap_.pop_back();
    return top;
  }

  [[nodiscard]] bool open(PathCell at, PathCell next, PathCell step) const {
    const bool knight = std::abs(step.x) + std::abs(step.y) == 3;
    return knight ? ground_.clear({float(at.x), float(at.y)}, {float(next.x), float(next.y)})
                  : ground_.straight(at.x, at.y, step.x, step.y, stride_);
  }

  void expand(PathCell at, std::uint32_t index, float cost) {
    const Grid<float>& height = ground_.height();
    for (std::uint8_t d = 0; d < directions.size(); ++d) {
      const PathCell step = directions[d];
      const PathCell next{at.x + step.x * stride_, at.y + step.y * stride_};
      if (!height.contains(next.x, next.y)) continue;
      const int block_x = next.x / block_;
      const int block_y = next.y / block_;
      if (!tube_.contains(block_x, block_y) || !inside_[tube_index(block_x, block_y)]) continue;
      const auto next_index = std::uint32_t(std::int64_t(index) + step.x + std::int64_t(step.y) * columns_);
      const float run = std::sqrt(float(step.x * step.x + step.y * step.y)) * float(stride_ * ground_.cell_size());
      if (cost + run * ground_.walk().easiest() >= best_[next_index]) continue;
      if (!open(at, next, step)) continue;
      float there = run * ground_.walk()((height(next.x, next.y) - height(at.x, at.y)) / run);
      if (ground_.wet(height.index(next.x, next.y))) there *= wading_factor;
      if (cost + there >= best_[next_index]) continue;
      there *= unevenness(next, ground_.cell_size());
      if (cost + there < best_[next_index]) push(next_index, cost + there, d);
    }
  }

  [[nodiscard]] std::vector<PathCell> trace(std::uint32_t index) const {
    std::vector<PathCell> path;
    if (cell_of(index) != to_) path.push_back(to_);
    while (true) {
      path.push_back(cell_of(index));
      if (came_[index] == 0xff) break;
      const PathCell step = directions[came_[index]];
      index = std::uint32_t(std::int64_t(index) - step.x - std::int64_t(step.y) * columns_);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const FineGround& ground_;
  int block_;
  int stride_;
  PathCell from_;
  PathCell to_;
  Rect tube_;
  std::vector<std::uint8_t> inside_;
  PathCell origin_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> best_;
  std::vector<std::uint8_t> came_;
  std::vector<Entry> heap_;
};

}  // namespace

float unevenness(PathCell cell, double cell_size) {
  constexpr float strength = 0.6F;
  constexpr double wavelength = 45;
  const double x = cell.x * cell_size / wavelength;
  const double y = cell.y * cell_size / wavelength;
  const auto column = std::uint64_t(x);
  const auto row = std::uint64_t(y);
  const auto at = [](std::uint64_t i, std::uint64_t k) { return float(mix_bits(i * 0x100000001b3ULL + k) >> 40) * 0x1.0p-24F; };
  const auto smooth = [](double t) { return float(t * t * (3 - 2 * t)); };
  const float east = smooth(x - double(column));
  const float south = smooth(y - double(row));
  const float north_side = at(column, row) + (at(column + 1, row) - at(column, row)) * east;
  const float south_side = at(column, row + 1) + (at(column + 1, row + 1) - at(column, row + 1)) * east;
  return 1 + strength * (north_side + (south_side - north_side) * south);
}

FineGround::FineGround(const Ground& ground, std::vector<const Grid<std::int32_t>*> regions, const WalkCost& walk,
                       double step)
    : regions_(std::move(regions)),
      height_(&ground.terrain->height),
      water_(ground.hydrology ? &ground.hydrology->water_depth : nullptr),
      walk_(walk),
      cell_size_(ground.terrain->cell_size),
      stride_(std::clamp(int(std::lround(step / ground.terrain->cell_size)), 1, 8)) {
  assert(!regions_.empty());
}

bool FineGround::clear(PathPoint a, PathPoint b) const {
  const float longest = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
  const int samples = int(longest / 0.4F) + 1;
  for (int i = 0; i <= samples; ++i) {
    const float t = float(i) / float(samples);
    if (!passable(PathPoint{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t})) return false;
  }
  return true;
}

bool FineGround::straight(int x, int y, int dx, int dy, int cells) const {
  for (int i = 0; i < cells; ++i) {
    if (!passable(x + dx, y + dy)) return false;
    if (dx != 0 && dy != 0 && (!passable(x + dx, y) || !passable(x, y + dy))) return false;
    x += dx;
    y += dy;
  }
  return true;
}

double FineGround::walk_between(PathPoint a, PathPoint b) const {
  const auto dx = double(b.x - a.x);
  const auto dy = double(b.y - a.y);
  const double run = std::sqrt(dx * dx + dy * dy) * cell_size_;
  if (run <= 0) return 0;
  const auto slope = float((sample_bilinear(*height_, b.x, b.y) - sample_bilinear(*height_, a.x, a.y)) / run);
  double cost = run * double(walk_(slope));
  const PathCell cell = cell_at(b);
  if (height_->contains(cell.x, cell.y) && wet(height_->index(cell.x, cell.y))) cost *= wading_factor;
  return cost;
}

double FineGround::walk_along(PathPoint a, PathPoint b) const {
  const int pieces = std::max(1, int(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y))) / stride_);
  double cost = 0;
  PathPoint last = a;
  for (int i = 1; i <= pieces; ++i) {
    const float t = float(i) / float(pieces);
    const PathPoint next{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
    cost += walk_between(last, next);
    last = next;
  }
  return cost;
}

std::vector<PathCell> fine_path(const FineGround& ground, int block, std::span<const PathCell> over, PathCell from, PathCell to) {
  if (!ground.passable(from.x, from.y) || !ground.passable(to.x, to.y)) return {};
  if (from == to) return {from};
  std::vector<PathCell> path;
  if (ground.stride() > 1) path = TubeSearch(ground, block, over, from, to, ground.stride()).run();
  if (path.empty()) path = TubeSearch(ground, block, over, from, to, 1).run();
  return path;
}

}  // namespace biotope
