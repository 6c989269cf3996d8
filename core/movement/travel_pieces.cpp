#include "core/movement/travel_pieces.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <span>

#include "core/base/random.hpp"

namespace biotope {
namespace {

bool all_passable(const RegionRows& label, const Rect& block) {
  for (int y = block.y0; y < block.y1; ++y) {
    const std::int32_t* row = label.row(y);
    if (std::any_of(row + block.x0, row + block.x1, [](std::int32_t region) { return region < 0; })) return false;
  }
  return true;
}

/// The cell of `cells` nearest to their mean (the first on ties).
TravelGraph::Vertex representative(const std::vector<std::array<int, 2>>& cells, int region) {
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : cells) {
    mean_x += x;
    mean_y += y;
  }
  mean_x /= double(cells.size());
  mean_y /= double(cells.size());
  TravelGraph::Vertex best{cells[0][0], cells[0][1], region};
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [x, y] : cells) {
    const double distance = (x - mean_x) * (x - mean_x) + (y - mean_y) * (y - mean_y);
    if (distance < nearest) {
      nearest = distance;
      best.x = x;
      best.y = y;
    }
  }
  return best;
}

}  // namespace

RegionRows::RegionRows(const RunMap& label, int first, int last)
    : width_(std::size_t(label.width())), first_(first), cells_(width_ * std::size_t(last - first)) {
  for (int y = first; y < last; ++y) label.read_row(y, 0, std::span(cells_).subspan(std::size_t(y - first) * width_, width_));
}

BlockPieces pieces_of_block(const RegionRows& label, const Rect& block) {
  BlockPieces result;
  if (all_passable(label, block)) {
    const int x = block.x0 + block.width() / 2;
    const int y = block.y0 + block.height() / 2;
    result.vertices.push_back({x, y, label(x, y)});
    return result;
  }
  constexpr std::uint16_t blocked = BlockVertices::blocked;
  std::vector<std::uint16_t> number(std::size_t(block.width()) * std::size_t(block.height()), blocked);
  const auto number_at = [&](int x, int y) -> std::uint16_t& {
    return number[std::size_t(y - block.y0) * std::size_t(block.width()) + std::size_t(x - block.x0)];
  };
  std::vector<std::array<int, 2>> piece;
  for (int y = block.y0; y < block.y1; ++y) {
    for (int x = block.x0; x < block.x1; ++x) {
      if (label(x, y) < 0 || number_at(x, y) != blocked) continue;
      const auto own = std::uint16_t(result.vertices.size());
      assert(own < blocked);
      piece.assign(1, {x, y});
      number_at(x, y) = own;
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const auto [px, py] = piece[i];
        for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}, std::array{-1, 0}, std::array{0, -1}}) {
          const int nx = px + dx;
          const int ny = py + dy;
          if (!block.contains(nx, ny) || label(nx, ny) < 0 || number_at(nx, ny) != blocked) continue;
          number_at(nx, ny) = own;
          piece.push_back({nx, ny});
        }
      }
      result.vertices.push_back(representative(piece, label(x, y)));
    }
  }
  if (!result.vertices.empty()) result.piece_of_cell = std::make_shared<const std::vector<std::uint16_t>>(std::move(number));
  return result;
}

std::uint64_t hash_of_open(const BlockPieces& pieces) {
  if (!pieces.piece_of_cell) return pieces.vertices.empty() ? 1 : 0;
  const std::vector<std::uint16_t>& cells = *pieces.piece_of_cell;
  std::uint64_t hash = 1;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    bits = (bits << 1) | std::uint64_t(cells[i] != BlockVertices::blocked);
    if (i % 64 == 63) hash = mix_bits(hash ^ bits);
  }
  return mix_bits(hash ^ bits) | 1;
}

bool surely_same_open_rows(const RunMap& a, const RunMap& b, int first, int last) {
  for (int y = first; y < last; ++y) {
    const auto one = a.runs().row(y);
    const auto other = b.runs().row(y);
    const auto same_cells = [](const CellRun& p, const CellRun& q) { return p.x0 == q.x0 && p.x1 == q.x1; };
    if (!std::equal(one.begin(), one.end(), other.begin(), other.end(), same_cells)) return false;
  }
  return true;
}

bool same_open_cells(const RegionRows& a, const RegionRows& b, const Rect& block) {
  for (int y = block.y0; y < block.y1; ++y) {
    const std::int32_t* one = a.row(y);
    const std::int32_t* other = b.row(y);
    std::int32_t differs = 0;
    for (int x = block.x0; x < block.x1; ++x) differs |= one[x] ^ other[x];
    // The sign says what is passable; regions may have other numbers.
    if (differs < 0) return false;
  }
  return true;
}

}  // namespace biotope
