#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/rect.hpp"

namespace biotope {

/// The vertex of a travel graph that each cell belongs to, by square blocks of cells: a block that is passable or blocked as a
/// whole takes no more than a number, and graphs share the others where the same cells are passable.
class BlockVertices {
 public:
  /// Pieces of the cells of a block, row by row, numbered from 0.
  using Pieces = std::shared_ptr<const std::vector<std::uint16_t>>;
  /// Piece of a blocked cell.
  static constexpr std::uint16_t blocked = 0xffff;

  BlockVertices() = default;
  BlockVertices(int width, int height, int block)
      : width_(width),
        height_(height),
        block_(block),
        columns_((width + block - 1) / block),
        blocks_(std::size_t(columns_) * std::size_t((height + block - 1) / block)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Rect rect() const { return {0, 0, width_, height_}; }
  [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

  /// Vertex of a cell, -1 where it is blocked.
  [[nodiscard]] std::int32_t operator()(int x, int y) const {
    const Block& block = block_of(x, y);
    if (!block.pieces) return block.count > 0 ? block.first : -1;
    const std::uint16_t piece = piece_at(block, x, y);
    return piece == blocked ? -1 : block.first + piece;
  }
  /// Whether a cell is passable.
  [[nodiscard]] bool open(int x, int y) const {
    const Block& block = block_of(x, y);
    return block.pieces ? piece_at(block, x, y) != blocked : block.count > 0;
  }

  /// A block's vertices are [first, first + count).
  [[nodiscard]] std::int32_t first(std::size_t block) const { return blocks_[block].first; }
  [[nodiscard]] std::int32_t count(std::size_t block) const { return blocks_[block].count; }
  /// Null where the block is one vertex or none.
  [[nodiscard]] const Pieces& pieces(std::size_t block) const { return blocks_[block].pieces; }
  /// Blocks are numbered row by row. Without pieces all cells are in the one vertex, or none is in any.
  void set(std::size_t block, std::int32_t first, std::int32_t count, Pieces pieces) {
    assert(pieces ? count < blocked : count <= 1);
    blocks_[block] = {first, count, std::move(pieces)};
  }

  bool operator==(const BlockVertices& other) const {
    return rect() == other.rect() && block_ == other.block_ &&
           std::equal(blocks_.begin(), blocks_.end(), other.blocks_.begin(), other.blocks_.end());
  }

 private:
  struct Block {
    std::int32_t first = 0;
    std::int32_t count = 0;
    Pieces pieces;
    bool operator==(const Block& other) const {
      if (first != other.first || count != other.count) return false;
      return pieces == other.pieces || (pieces && other.pieces && *pieces == *other.pieces);
    }
  };

  [[nodiscard]] const Block& block_of(int x, int y) const {
    assert(contains(x, y));
    return blocks_[std::size_t(y / block_) * std::size_t(columns_) + std::size_t(x / block_)];
  }
  [[nodiscard]] std::uint16_t piece_at(const Block& block, int x, int y) const {
    const int x0 = x / block_ * block_;
    const int side = std::min(block_, width_ - x0);
    return (*block.pieces)[std::size_t(y % block_) * std::size_t(side) + std::size_t(x - x0)];
  }

  int width_ = 0;
  int height_ = 0;
  int block_ = 1;
  int columns_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace biotope
