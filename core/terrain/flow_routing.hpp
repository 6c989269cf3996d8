#pragma once

#include <cstdint>
#include <span>

#include "core/base/grid.hpp"
#include "core/terrain/hydrology.hpp"

namespace biotope {

/// The stages of compute_hydrology up to accumulated flow; each is deterministic for any thread count.

/// 1 on cells below `sea_level` that connect (8 neighbours) to a border cell below it; empty when no border cell is.
[[nodiscard]] Grid<std::uint8_t> find_sea(const Grid<float>& height, float sea_level);

/// 1 on the border cells through which rivers enter, and some of their widths to either side: no water leaves the map there, or a hollow
/// of the border would swallow the river where it comes in. Empty when no river enters on the border, or when they take all of it.
[[nodiscard]] Grid<std::uint8_t> find_inlets(const Terrain& terrain, const HydrologyOptions& options);

/// Heights with every depression raised to its spill level: the least highest point of any way to the border (but for the inlets) or the
/// sea. Sea cells hold `sea_level`. Tiles are flooded on their own and joined by the graph of their watersheds (after Barnes 2016).
[[nodiscard]] Grid<float> fill_depressions(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level,
                                           const Grid<std::uint8_t>& inlets = {});

/// Hydrology::receiver of each cell: steepest fall on the filled ground; across flats the shortest way to where they empty. Water leaves
/// at sea cells, and at border cells (but for the inlets) whose fall toward the outside (continued from inside) is steepest or that have
/// no lower neighbour. `filled` comes from fill_depressions with the same sea and inlets.
[[nodiscard]] Grid<std::uint8_t> flow_directions(const Grid<float>& filled, const Grid<std::uint8_t>& sea,
                                                 const Grid<std::uint8_t>& inlets = {});

/// Number of cells whose water passes each cell along the receivers, itself included.
[[nodiscard]] Grid<std::uint32_t> upstream_cells(const Grid<std::uint8_t>& receiver);

/// Upslope area (m2) by multiple flow directions: a cell gives to every lower neighbour in proportion to slope^1.1 (Freeman 1991);
/// on flats and where water leaves the map it follows the receiver.
[[nodiscard]] Grid<float> multiple_flow_area(const Grid<float>& filled, const Grid<std::uint8_t>& receiver, double cell_area,
                                             std::span<const Inflow> inflows);

}  // namespace biotope
