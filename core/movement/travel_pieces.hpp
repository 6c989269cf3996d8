#pragma once

#include <cstdint>
#include <vector>

#include "core/ecosystem/run_map.hpp"
#include "core/movement/travel.hpp"

namespace biotope {

/// Some rows of a map of regions, cell by cell.
class RegionRows {
 public:
  RegionRows(const RunMap& label, int first, int last);

  [[nodiscard]] std::int32_t operator()(int x, int y) const { return row(y)[x]; }
  [[nodiscard]] const std::int32_t* row(int y) const { return cells_.data() + std::size_t(y - first_) * width_; }

 private:
  std::size_t width_;
  int first_;
  std::vector<std::int32_t> cells_;
};

/// The 4-connected pieces inside a block, numbered by their first cell.
struct BlockPieces {
  std::vector<TravelGraph::Vertex> vertices;
  /// Null when all cells are in one piece or none is in any.
  BlockVertices::Pieces piece_of_cell;
};
[[nodiscard]] BlockPieces pieces_of_block(const RegionRows& label, const Rect& block);

/// A hash of which cells of a block are passable; 0 where all are, else never 0.
[[nodiscard]] std::uint64_t hash_of_open(const BlockPieces& pieces);

/// Whether the same cells of some rows are passable, found without looking at every cell; false where that does not tell.
[[nodiscard]] bool surely_same_open_rows(const RunMap& a, const RunMap& b, int first, int last);
/// Whether the same cells of a block are passable.
[[nodiscard]] bool same_open_cells(const RegionRows& a, const RegionRows& b, const Rect& block);

}  // namespace biotope
