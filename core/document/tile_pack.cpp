#include "core/document/tile_pack.hpp"

#include <zstd.h>

#include <cassert>
#include <cstring>
#include <memory>
#include <type_traits>

namespace biotope {
namespace {

constexpr int fastest_level = 1;

/// Differing cells of tiles, a bit each, eight to a byte.
std::size_t mask_bytes(std::size_t tile_bytes, const CellLayout& layout) { return (tile_bytes / layout.cell_bytes() + 7) / 8; }

bool is_marked(std::span<const std::byte> mask, std::size_t cell) {
  return (mask[cell / 8] & std::byte(1U << (cell % 8))) != std::byte{0};
}

/// Marks the cells that differ; returns how many.
std::size_t mark_differences(const TileStates& tile, std::size_t cell_bytes, std::span<std::byte> mask) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < tile.kept.size() / cell_bytes; ++cell) {
    if (std::memcmp(tile.kept.data() + cell * cell_bytes, tile.other.data() + cell * cell_bytes, cell_bytes) == 0) continue;
    mask[cell / 8] |= std::byte(1U << (cell % 8));
    ++count;
  }
  return count;
}

/// Small differences of either sign become small numbers.
template <class Word>
Word folded(Word difference) {
  using Signed = std::make_signed_t<Word>;
  constexpr int bits = int(sizeof(Word)) * 8;
  return Word(Word(difference << 1) ^ Word(Signed(difference) >> (bits - 1)));
}
template <class Word>
Word unfolded(Word value) {
  return Word(Word(value >> 1) ^ Word(~Word(value & 1) + 1));
}

/// Where word `index` of lane `lane` has its bytes: all lowest bytes of the lane come first, then the next.
struct Planes {
  std::byte* begin;
  std::size_t count;
  template <class Word>
  void put(std::size_t lane, std::size_t index, Word word) const {
    for (std::size_t b = 0; b < sizeof(Word); ++b)
      begin[(lane * sizeof(Word) + b) * count + index] = std::byte((word >> (8 * b)) & 0xff);
  }
  template <class Word>
  [[nodiscard]] Word get(std::size_t lane, std::size_t index) const {
    std::uint32_t word = 0;
    for (std::size_t b = 0; b < sizeof(Word); ++b)
      word |= std::uint32_t(begin[(lane * sizeof(Word) + b) * count + index]) << (8 * b);
    return Word(word);
  }
};

template <class Word>
void put_values(std::span<const TileStates> tiles, std::span<const std::byte> masks, std::size_t lanes, const Planes& planes) {
  const std::size_t mask_size = masks.size() / tiles.size();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    Word last = 0;
    std::size_t index = 0;
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
      const auto mask = masks.subspan(tile * mask_size, mask_size);
      const auto kept = tiles[tile].kept;
      for (std::size_t cell = 0; cell < kept.size() / (lanes * sizeof(Word)); ++cell) {
        if (!is_marked(mask, cell)) continue;
        Word word = 0;
        std::memcpy(&word, kept.data() + (cell * lanes + lane) * sizeof(Word), sizeof(Word));
        planes.put(lane, index++, folded<Word>(Word(word - last)));
        last = word;
      }
    }
  }
}

template <class Word>
void get_values(std::span<const std::span<std::byte>> tiles, std::span<const std::byte> masks, std::size_t lanes,
                const Planes& planes) {
  const std::size_t mask_size = masks.size() / tiles.size();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    Word last = 0;
    std::size_t index = 0;
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
      const auto mask = masks.subspan(tile * mask_size, mask_size);
      for (std::size_t cell = 0; cell < tiles[tile].size() / (lanes * sizeof(Word)); ++cell) {
        if (!is_marked(mask, cell)) continue;
        last = Word(last + unfolded<Word>(planes.get<Word>(lane, index++)));
        std::memcpy(tiles[tile].data() + (cell * lanes + lane) * sizeof(Word), &last, sizeof(Word));
      }
    }
  }
}

}  // namespace

std::vector<std::byte> pack_tile_states(std::span<const TileStates> tiles, const CellLayout& layout) {
  if (tiles.empty()) return {};
  const std::size_t mask_size = mask_bytes(tiles.front().kept.size(), layout);
  std::vector<std::byte> raw(mask_size * tiles.size());
  std::size_t cells = 0;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    cells += mark_differences(tiles[tile], layout.cell_bytes(), std::span(raw).subspan(tile * mask_size, mask_size));
  }
  const std::size_t masks = raw.size();
  raw.resize(masks + cells * layout.cell_bytes());
  const Planes planes{raw.data() + masks, cells};
  const auto put = layout.word_bytes == 4 ? put_values<std::uint32_t> : put_values<std::uint8_t>;
  put(tiles, std::span(raw).first(masks), layout.lanes, planes);

  std::vector<std::byte> packed(ZSTD_compressBound(raw.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), fastest_level);
  assert(ZSTD_isError(size) == 0);
  // A copy of its own, since shrinking may keep the memory.
  return {packed.begin(), packed.begin() + std::ptrdiff_t(size)};
}

void unpack_tile_states(std::span<const std::byte> packed, std::span<const std::span<std::byte>> tiles,
                        const CellLayout& layout) {
  if (tiles.empty()) return;
  std::vector<std::byte> raw(std::size_t(ZSTD_getFrameContentSize(packed.data(), packed.size())));
  [[maybe_unused]] const std::size_t size = ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size());
  assert(size == raw.size());
  const std::size_t masks = mask_bytes(tiles.front().size(), layout) * tiles.size();
  const Planes planes{raw.data() + masks, (raw.size() - masks) / layout.cell_bytes()};
  const auto get = layout.word_bytes == 4 ? get_values<std::uint32_t> : get_values<std::uint8_t>;
  get(tiles, std::span(raw).first(masks), layout.lanes, planes);
}

}  // namespace biotope
