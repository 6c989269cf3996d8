#pragma once

#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

// Where water stands and runs on a ground that changed in some tiles; see water_marking.hpp for the whole ground.

/// A ground and the water on it.
struct WateredGround {
  const Terrain& terrain;
  const Hydrology& hydrology;
};

/// Marks the lakes again that reach near the changed tiles, those where heights, filled heights or the sea differ between
/// `before` and now, and the sea in them. `water` holds the lakes and the sea of before and gets those of now. Returns the cells
/// of all of these lakes, and those that the sea took or left.
[[nodiscard]] std::vector<std::uint32_t> update_standing_water(const WateredGround& before, const Terrain& terrain,
                                                               const Grid<std::uint8_t>& sea, const TileSet& changed,
                                                               const HydrologyOptions& options, Hydrology& water);

/// What discharge follows from, beside the cells upstream.
struct DischargeChange {
  /// Cells where the number of cells upstream or standing water may be another.
  std::vector<std::uint32_t> cells;
  const std::vector<Inflow>& inflows_before;
};
/// Discharges after some cells changed: `water` has directions and standing water of now, and the discharges of before. Returns
/// the tiles in which they differ.
[[nodiscard]] TileSet update_discharge(const Terrain& terrain, const HydrologyOptions& options,
                                       const Grid<std::uint32_t>& upstream, const Hydrology& before, DischargeChange change,
                                       Hydrology& water);

/// Takes the rivers from the map; returns the tiles they were in.
[[nodiscard]] TileSet clear_rivers(Hydrology& water);
/// Tiles that the rivers' reaches may be marked in.
[[nodiscard]] TileSet tiles_of_rivers(const Terrain& terrain, const Hydrology& water);

}  // namespace biotope
