#include "render/trail_lines.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Side of the squares by which pieces are found, m: that of a block of herbs.
constexpr float square_side = 16;
/// Steps between no and the greatest use.
constexpr float use_steps = 32;

float distance(const TrailPiece& piece, glm::vec2 place) {
  const glm::vec2 along = piece.to - piece.from;
  const float t = glm::clamp(glm::dot(place - piece.from, along) / std::max(glm::dot(along, along), 1e-6F), 0.0F, 1.0F);
  return glm::length(place - piece.from - t * along);
}

/// Squares [x0, x1] x [y0, y1] that a piece may matter to.
struct Squares {
  int x0, x1, y0, y1;
};
Squares squares_of(const TrailPiece& piece, int columns, int rows) {
  const float margin = piece.half_width + TrailLines::reach;
  const auto square = [](float metres) { return int(std::floor(metres / square_side)); };
  return {std::max(0, square(std::min(piece.from.x, piece.to.x) - margin)),
          std::min(columns - 1, square(std::max(piece.from.x, piece.to.x) + margin)),
          std::max(0, square(std::min(piece.from.y, piece.to.y) - margin)),
          std::min(rows - 1, square(std::max(piece.from.y, piece.to.y) + margin))};
}

template <class Visit>
void each_square(const TrailPiece& piece, int columns, int rows, const Visit& visit) {
  const Squares squares = squares_of(piece, columns, rows);
  const float reach = piece.half_width + TrailLines::reach + 0.7072F * square_side;
  for (int y = squares.y0; y <= squares.y1; ++y) {
    for (int x = squares.x0; x <= squares.x1; ++x) {
      const glm::vec2 middle((float(x) + 0.5F) * square_side, (float(y) + 0.5F) * square_side);
      if (distance(piece, middle) <= reach) visit(std::size_t(y) * std::size_t(columns) + std::size_t(x));
    }
  }
}

std::vector<TrailPiece> pieces_of(const Terrain& terrain, const TrailNetwork& trails) {
  const float heaviest = heaviest_weight(trails);
  std::vector<TrailPiece> pieces;
  if (heaviest <= 0) return pieces;
  const auto cell = float(terrain.cell_size);
  const float top = float(terrain.height.height()) - 0.5F;
  const auto place = [&](const PathPoint& point) { return glm::vec2((point.x + 0.5F) * cell, (top - point.y) * cell); };
  for (const TrailRoute& route : trails.routes) {
    for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
      const float use = trail_use(route.weight[i], heaviest);
      pieces.push_back({place(route.points[i]), place(route.points[i + 1]), trail_half_width(use), use});
    }
  }
  return pieces;
}

}  // namespace

float heaviest_weight(const TrailNetwork& trails) {
  float heaviest = 0;
  for (const TrailRoute& route : trails.routes) {
    for (const float weight : route.weight) heaviest = std::max(heaviest, weight);
  }
  return heaviest;
}

float trail_use(float weight, float heaviest) {
  const float use = std::pow(std::clamp(weight / heaviest, 0.0F, 1.0F), 0.3F);
  return std::round(use * use_steps) / use_steps;
}

float worn_share(float inside, float use, float soft) {
  return std::clamp(inside / soft + 1, 0.0F, 1.0F) * (0.35F + 0.65F * use);
}

TrailLines::TrailLines(const Terrain& terrain, const TrailNetwork& trails, float soft)
    : columns_(int(std::ceil(terrain.width_metres() / double(square_side)))),
      rows_(int(std::ceil(terrain.height_metres() / double(square_side)))),
      soft_(soft),
      first_(std::size_t(columns_) * std::size_t(rows_) + 1, 0) {
  const std::vector<TrailPiece> all = pieces_of(terrain, trails);
  for (const TrailPiece& piece : all) {
    each_square(piece, columns_, rows_, [&](std::size_t square) { ++first_[square + 1]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  pieces_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (const TrailPiece& piece : all) {
    each_square(piece, columns_, rows_, [&](std::size_t square) { pieces_[next[square]++] = piece; });
  }
}

std::span<const TrailPiece> TrailLines::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return {};
  const std::size_t square = std::size_t(row) * std::size_t(columns_) + std::size_t(column);
  return {pieces_.data() + first_[square], pieces_.data() + first_[square + 1]};
}

float TrailLines::inside(float x, float y) const {
  float most = -reach;
  for (const TrailPiece& piece : at(int(std::floor(x / square_side)), int(std::floor(y / square_side)))) {
    most = std::max(most, piece.half_width - distance(piece, {x, y}));
  }
  return most;
}

float TrailLines::worn(float x, float y) const {
  float most = 0;
  for (const TrailPiece& piece : at(int(std::floor(x / square_side)), int(std::floor(y / square_side)))) {
    most = std::max(most, worn_share(piece.half_width - distance(piece, {x, y}), piece.use, soft_));
  }
  return most;
}

bool TrailLines::none_within(float west, float south, float side) const {
  for (int row = int(std::floor(south / square_side)); float(row) * square_side < south + side; ++row) {
    for (int column = int(std::floor(west / square_side)); float(column) * square_side < west + side; ++column) {
      if (!at(column, row).empty()) return false;
    }
  }
  return true;
}

bool TrailLines::same_within(const TrailLines& other, float west, float south, float side) const {
  if (soft_ != other.soft_) return false;
  for (int row = int(std::floor(south / square_side)); float(row) * square_side < south + side; ++row) {
    for (int column = int(std::floor(west / square_side)); float(column) * square_side < west + side; ++column) {
      const auto mine = at(column, row);
      const auto its = other.at(column, row);
      if (!std::equal(mine.begin(), mine.end(), its.begin(), its.end())) return false;
    }
  }
  return true;
}

}  // namespace biotope
