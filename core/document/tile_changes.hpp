#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/paint.hpp"
#include "core/base/parallel.hpp"
#include "core/document/tile_pack.hpp"

namespace biotope {

/// Called with every block of memory that may be shared with others, and its bytes.
using BlockVisitor = std::function<void(const void* block, std::size_t bytes)>;

/// One side of changed tiles, packed: the other side is what the map shows when it is needed.
struct PackedTiles {
  struct Note {
    std::uint32_t tile = 0;
    /// The kept state is no tile at all.
    bool blank = false;
  };
  bool holds_before = true;
  std::vector<Note> notes;
  /// Each of `tiles_a_chunk` tiles that are not blank, the last of fewer.
  std::vector<std::vector<std::byte>> chunks;

  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = notes.capacity() * sizeof(Note) + chunks.capacity() * sizeof(chunks.front());
    for (const auto& chunk : chunks) sum += chunk.capacity();
    return sum;
  }
};

/// Tiles before and after a change, whatever their cells: what History packs when a step is old.
class PackableTiles {
 public:
  PackableTiles() = default;
  PackableTiles(const PackableTiles&) = default;
  PackableTiles& operator=(const PackableTiles&) = default;
  virtual ~PackableTiles() = default;
  /// False while packed.
  [[nodiscard]] virtual bool loose() const = 0;
  virtual void visit_blocks(const BlockVisitor& visit) const = 0;
  /// Memory besides the blocks.
  [[nodiscard]] virtual std::size_t own_bytes() const = 0;
  /// Packs the loose tiles, on any thread; keeps them alive meanwhile. `holds_before`: the change is done and will be reverted.
  [[nodiscard]] virtual std::function<PackedTiles()> pack_task(bool holds_before) const = 0;
  /// Takes the packed tiles instead of the loose ones.
  virtual void adopt(PackedTiles packed) = 0;
};

/// Tiles before and after a change of one map. Packed, it holds only the side that the map does not show, and unpacks when the
/// map goes there.
template <class T>
class TileChanges final : public PackableTiles {
 public:
  using Map = TiledMap<T>;
  using TilePointer = typename Map::TilePointer;
  struct Change {
    std::size_t tile = 0;
    TilePointer before;
    TilePointer after;
  };

  /// `background` is the map's.
  explicit TileChanges(std::vector<Change> changes, T background = T{}) : loose_(std::move(changes)), background_(background) {}

  /// The map, which shows the state before, shows the state after; and the way back.
  void apply(Map& map) const {
    unpack(map, false);
    for (const Change& change : loose_) map.set_tile(change.tile, change.after);
  }
  void revert(Map& map) const {
    unpack(map, true);
    for (const Change& change : loose_) map.set_tile(change.tile, change.before);
  }

  [[nodiscard]] bool empty() const { return loose_.empty() && packed_.notes.empty(); }
  [[nodiscard]] bool loose() const override { return !loose_.empty(); }
  void visit_blocks(const BlockVisitor& visit) const override {
    for (const Change& change : loose_) {
      if (change.before) visit(change.before.get(), sizeof(Tile));
      if (change.after) visit(change.after.get(), sizeof(Tile));
    }
  }
  [[nodiscard]] std::size_t own_bytes() const override {
    return sizeof(*this) + loose_.capacity() * sizeof(Change) + packed_.bytes();
  }
  [[nodiscard]] std::function<PackedTiles()> pack_task(bool holds_before) const override {
    return [changes = loose_, background = background_, holds_before] { return pack(changes, background, holds_before); };
  }
  void adopt(PackedTiles packed) override {
    packed_ = std::move(packed);
    loose_ = {};
  }

 private:
  using Tile = typename Map::Tile;
  static constexpr std::size_t tiles_a_chunk = 32;
  static constexpr CellLayout layout{sizeof(T) % 4 == 0 ? std::size_t(4) : std::size_t(1),
                                     sizeof(T) % 4 == 0 ? sizeof(T) / 4 : sizeof(T)};

  static PackedTiles pack(const std::vector<Change>& changes, T background, bool holds_before) {
    Tile blank;
    blank.fill(background);
    const auto bytes_of = [&](const TilePointer& tile) { return std::as_bytes(std::span(tile ? *tile : blank)); };
    PackedTiles packed;
    packed.holds_before = holds_before;
    std::vector<TileStates> states;
    for (const Change& change : changes) {
      const TilePointer& kept = holds_before ? change.before : change.after;
      packed.notes.push_back({std::uint32_t(change.tile), !kept});
      if (kept) states.push_back({bytes_of(kept), bytes_of(holds_before ? change.after : change.before)});
    }
    for (std::size_t first = 0; first < states.size(); first += tiles_a_chunk) {
      const std::size_t count = std::min(tiles_a_chunk, states.size() - first);
      packed.chunks.push_back(pack_tile_states(std::span(states).subspan(first, count), layout));
    }
    packed.notes.shrink_to_fit();
    packed.chunks.shrink_to_fit();
    return packed;
  }

  void unpack(const Map& map, bool to_before) const {
    if (packed_.notes.empty()) return;
    assert(packed_.holds_before == to_before);
    std::vector<std::span<std::byte>> kept;
    for (const PackedTiles::Note& note : packed_.notes) {
      const TilePointer shown = map.tile(note.tile);
      std::shared_ptr<Tile> tile;
      if (!note.blank) {
        tile = std::make_shared<Tile>();
        if (shown) {
          *tile = *shown;
        } else {
          tile->fill(background_);
        }
        kept.push_back(std::as_writable_bytes(std::span(*tile)));
      }
      loose_.push_back(to_before ? Change{note.tile, tile, shown} : Change{note.tile, shown, tile});
    }
    parallel_each(packed_.chunks.size(), [&](std::size_t chunk) {
      const std::size_t first = chunk * tiles_a_chunk;
      unpack_tile_states(packed_.chunks[chunk], std::span(kept).subspan(first, std::min(tiles_a_chunk, kept.size() - first)),
                         layout);
    });
    packed_ = {};
  }

  // How the tiles are held changes when the map comes to need them; what the change does never does.
  mutable std::vector<Change> loose_;
  mutable PackedTiles packed_;
  T background_;
};

}  // namespace biotope
