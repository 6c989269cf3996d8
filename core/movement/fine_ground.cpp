#include <algorithm>
#include <cstdlib>

#include "core/base/random.hpp"
#include "core/movement/fine_path.hpp"

namespace biotope {

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

FineGround::FineGround(const Ground& ground, std::vector<const TravelGraph*> graphs, const WalkCost& walk, double step,
                       const PlacedGround* placed)
    : graphs_(std::move(graphs)),
      height_(&ground.terrain->height),
      water_(ground.hydrology ? &ground.hydrology->water_depth : nullptr),
      walk_(walk),
      cell_size_(ground.terrain->cell_size),
      stride_(std::clamp(int(std::lround(step / ground.terrain->cell_size)), 1, 8)),
      placed_(placed && !placed->empty() ? placed : nullptr) {
  assert(!graphs_.empty());
}

void FineGround::mark_block(PathCell number, std::uint8_t* out, std::size_t pitch) const {
  const Rect cells = cells_of(number);
  const auto width = std::size_t(cells.width());
  const auto row_of = [&](int y) { return out + std::size_t(y - cells.y0) * pitch; };
  for (int y = cells.y0; y < cells.y1; ++y) std::fill_n(row_of(y), width, std::uint8_t(1));
  for (const TravelGraph* graph : graphs_) {
    if (open_cells(*graph, number) == 0) continue;
    const auto& pieces =
        graph->vertex_of_cell.pieces(std::size_t(number.y) * std::size_t(graph->columns) + std::size_t(number.x));
    for (int y = cells.y0; y < cells.y1; ++y) {
      std::uint8_t* const row = row_of(y);
      if (!pieces) {
        std::fill_n(row, width, std::uint8_t(0));
        continue;
      }
      const std::uint16_t* piece = pieces->data() + std::size_t(y - cells.y0) * width;
      for (std::size_t i = 0; i < width; ++i) row[i] = std::uint8_t(row[i] & std::uint8_t(piece[i] != BlockVertices::blocked));
    }
  }
  if (!placed_) return;
  const Rect marked = intersection(placed_->bounds(), cells);
  for (int y = marked.y0; y < marked.y1; ++y) {
    for (int x = marked.x0; x < marked.x1; ++x) {
      std::uint8_t& cell = row_of(y)[x - cells.x0];
      if (cell) cell = std::uint8_t(cell + placed_->at(x, y));
    }
  }
}

std::uint64_t FineGround::block_key(PathCell number) const {
  std::uint64_t key = 0;
  for (const TravelGraph* graph : graphs_) {
    if (const std::uint64_t open = open_cells(*graph, number)) key += mix_bits(open);
  }
  if (!placed_) return key;
  const Rect cells = cells_of(number);
  const Rect marked = intersection(placed_->bounds(), cells);
  for (int y = marked.y0; y < marked.y1; ++y) {
    for (int x = marked.x0; x < marked.x1; ++x) {
      if (const auto mark = placed_->at(x, y))
        key += random_bits({std::uint64_t(x - cells.x0), std::uint64_t(y - cells.y0), mark});
    }
  }
  return key;
}

bool FineGround::clear(PathPoint a, PathPoint b) const {
  if (!passable(a) || !passable(b)) return false;
  PathCell at = cell_at(a);
  const PathCell last = cell_at(b);
  const double dx = double(b.x) - double(a.x);
  const double dy = double(b.y) - double(a.y);
  const int step_x = dx < 0 ? -1 : 1;
  const int step_y = dy < 0 ? -1 : 1;
  int left_x = std::abs(last.x - at.x);
  int left_y = std::abs(last.y - at.y);
  // Shares of the line up to the next border to the side and up or down, and from one such border to the next.
  const double over_x = left_x > 0 ? 1 / std::abs(dx) : 0;
  const double over_y = left_y > 0 ? 1 / std::abs(dy) : 0;
  double next_x = (0.5 + step_x * (at.x - double(a.x))) * over_x;
  double next_y = (0.5 + step_y * (at.y - double(a.y))) * over_y;
  // A line this near to a corner (cells) goes through it, and needs both cells beside it.
  const double corner = 1e-3 * std::max(over_x, over_y);
  while (left_x > 0 || left_y > 0) {
    const bool both = left_x > 0 && left_y > 0;
    if (both && std::abs(next_x - next_y) < corner && !(open(at.x + step_x, at.y) && open(at.x, at.y + step_y))) return false;
    if (left_y == 0 || (both && next_x < next_y)) {
      at.x += step_x;
      next_x += over_x;
      --left_x;
    } else {
      at.y += step_y;
      next_y += over_y;
      --left_y;
    }
    if (!open(at.x, at.y)) return false;
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
    const double piece = walk_between(last, next);
    const PathCell cell = cell_at(next);
    cost += placed_ ? piece * double(placed_->factor(cell.x, cell.y)) : piece;
    last = next;
  }
  return cost;
}

}  // namespace biotope
