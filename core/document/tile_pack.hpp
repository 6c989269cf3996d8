#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace biotope {

/// How the cells of a tile lie in memory: `lanes` words of `word_bytes` each (1 or 4).
struct CellLayout {
  std::size_t word_bytes = 4;
  std::size_t lanes = 2;
  [[nodiscard]] std::size_t cell_bytes() const { return word_bytes * lanes; }
};

/// Two states of one tile, as bytes of the same length.
struct TileStates {
  std::span<const std::byte> kept;
  std::span<const std::byte> other;
};

/// Packs, without loss, what it takes to get from `other` to `kept`: which cells differ to the bit, and their kept values.
/// Neighbouring values are subtracted, their bytes sorted by weight, and the rest is left to Zstandard at its fastest.
[[nodiscard]] std::vector<std::byte> pack_tile_states(std::span<const TileStates> tiles, const CellLayout& layout);

/// The way back: each tile comes in as `other` and leaves as `kept`.
void unpack_tile_states(std::span<const std::byte> packed, std::span<const std::span<std::byte>> tiles, const CellLayout& layout);

}  // namespace biotope
