#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/tiled_map.hpp"
#include "core/ecosystem/cell_runs.hpp"
#include "core/species/species.hpp"

namespace biotope {

class PresentTiles;

/// Part of a run that lies in one tile; columns and row count within the tile, `group` within the tile in the order of
/// appearance.
struct TileRun {
  std::uint8_t y = 0;
  std::uint8_t x0 = 0;
  std::uint8_t x1 = 0;
  std::uint16_t group = 0;
  bool operator==(const TileRun&) const = default;
};

/// Sums of some cover maps over the groups of one tile, with the runs they were taken over: as long as runs, covers and losses of
/// the tile are the same, so are they, whatever happens elsewhere and whatever number a group has on the whole map.
struct TileSums {
  std::vector<TileRun> runs;
  std::vector<std::uint64_t> covered;  ///< by group and map
  std::vector<std::uint64_t> lost;     ///< empty when nothing is lost in the tile
};
/// By tile; null where there is no run.
using SumsOfTiles = std::vector<std::shared_ptr<const TileSums>>;

/// Where a stratum is present in a tile: a bit a cell, a word a row.
using PresenceTile = std::array<std::uint64_t, tile_side>;

/// What a level summed up tile by tile, for the next computation of the level to take over where nothing changed.
struct SupplyTiles {
  SumsOfTiles pieces;
  std::array<SumsOfTiles, strata> patches;
  std::array<SumsOfTiles, strata> nodes;
  /// By stratum and tile; null where the stratum is nowhere present.
  std::array<std::vector<std::shared_ptr<const PresenceTile>>, strata> presence;
};

/// How a computation may take over what an earlier one found.
struct TileReuse {
  /// Found by the earlier one; null: nothing.
  const SupplyTiles* before = nullptr;
  /// By tile: whether covers or losses differ from the earlier ones. Only read with `before`.
  std::span<const char> changed = {};
  /// Filled by this one; null: not wanted.
  SupplyTiles* found = nullptr;
};

/// Sums of cover by group and map, at [group * maps + i] for the i-th of some maps.
struct CoverSums {
  std::vector<std::uint64_t> covered;  ///< 1/full_cover cells
  /// Part of it whose growth is lost, in 1/whole_loss of that; empty when nothing is lost anywhere.
  std::vector<std::uint64_t> lost;
  /// Cover that grows, 1/full_cover cells.
  [[nodiscard]] double growing(std::size_t i) const;
};

/// The runs' values are the groups. Parallel; whole numbers, so any order of adding gives the same. Tiles of `before` that are
/// the same are taken over; `found` (null: not wanted) gets all.
[[nodiscard]] CoverSums cover_sums(const RunTable& table, std::size_t groups, const PresentTiles& tiles,
                                   std::span<const std::size_t> maps, std::span<const char> changed = {},
                                   const SumsOfTiles* before = nullptr, SumsOfTiles* found = nullptr);

/// Where the summed cover of some maps is above the threshold of presence, by tile.
[[nodiscard]] std::vector<std::shared_ptr<const PresenceTile>> presence_tiles(
    const PresentTiles& tiles, std::span<const std::size_t> maps, std::span<const char> changed = {},
    const std::vector<std::shared_ptr<const PresenceTile>>* before = nullptr);

/// The parts of a table's runs where the bits are set.
[[nodiscard]] RunTable present_parts(const RunTable& table, std::span<const std::shared_ptr<const PresenceTile>> presence);

}  // namespace biotope
