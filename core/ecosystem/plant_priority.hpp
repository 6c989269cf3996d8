#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace biotope {

/// The cells of a map by priority: which has the highest key (0 = none), and of those the first in row order.
/// A tree of maxima over blocks of 64 keys: a byte a cell, and one block a floor to find or to change a cell.
class CellPriority {
 public:
  explicit CellPriority(std::size_t cells) {
    do {
      const std::size_t blocks = (cells + block - 1) / block;
      floors_.emplace_back(blocks * block);
      cells = blocks;
    } while (cells > 1);
  }

  /// Sets a key without looking at the rest; index_all must follow. May be called for different cells at a time.
  void put(std::size_t cell, std::uint8_t key) { floors_[0][cell] = key; }

  void index_all() {
    for (std::size_t floor = 1; floor < floors_.size(); ++floor) {
      for (std::size_t i = 0; i * block < floors_[floor - 1].size(); ++i) floors_[floor][i] = maximum(floor - 1, i);
    }
    best_ = maximum(floors_.size() - 1, 0);
  }

  [[nodiscard]] std::uint8_t key(std::size_t cell) const { return floors_[0][cell]; }
  /// The highest key of all.
  [[nodiscard]] std::uint8_t best() const { return best_; }

  /// The first cell that has the highest key. Mostly it is near the last one found, before which nothing is as high.
  [[nodiscard]] std::size_t first_best() {
    const std::size_t rest = block - last_ % block;
    const void* const near = std::memchr(floors_[0].data() + last_, best_, rest);
    last_ = near != nullptr ? std::size_t(static_cast<const std::uint8_t*>(near) - floors_[0].data()) : search();
    return last_;
  }

  void set(std::size_t cell, std::uint8_t key) {
    const std::uint8_t highest = best_;
    if (key >= highest) last_ = std::min(last_, cell);
    change(cell, key);
    if (best_ != highest) last_ = 0;
  }

 private:
  static constexpr std::size_t block = 64;

  /// The first cell that has the highest key, found from the top of the tree.
  [[nodiscard]] std::size_t search() const {
    std::size_t i = 0;
    for (std::size_t floor = floors_.size(); floor-- > 0;) {
      const std::uint8_t* const keys = floors_[floor].data() + i * block;
      i = i * block + std::size_t(static_cast<const std::uint8_t*>(std::memchr(keys, best_, block)) - keys);
    }
    return i;
  }

  void change(std::size_t cell, std::uint8_t key) {
    for (std::size_t floor = 0; floor < floors_.size(); ++floor) {
      std::vector<std::uint8_t>& keys = floors_[floor];
      const std::uint8_t old = keys[cell];
      if (key == old) return;
      keys[cell] = key;
      cell /= block;
      const std::uint8_t above = floor + 1 < floors_.size() ? floors_[floor + 1][cell] : best_;
      if (key > old) {
        if (key <= above) return;
      } else {
        // Only a fall from the block's maximum needs a look at the others, and often one of them is as high as it was.
        if (old < above || std::memchr(keys.data() + cell * block, old, block) != nullptr) return;
        key = maximum(floor, cell);
      }
    }
    best_ = key;
  }

  [[nodiscard]] std::uint8_t maximum(std::size_t floor, std::size_t i) const {
    const std::uint8_t* const keys = floors_[floor].data() + i * block;
    std::uint8_t most = 0;
    for (std::size_t k = 0; k < block; ++k) most = std::max(most, keys[k]);
    return most;
  }

  std::vector<std::vector<std::uint8_t>> floors_;  ///< cells, then maxima of blocks, blocks of blocks, ..
  std::uint8_t best_ = 0;
  std::size_t last_ = 0;  ///< no cell before it has the highest key
};

}  // namespace biotope
