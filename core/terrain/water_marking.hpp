#pragma once

#include "core/base/grid.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// The stages of compute_hydrology that say where water stands and runs. Each writes its own fields of the result and reads those
/// of the stages before it.

/// A channel narrower than this share of a cell leaves its cell dry ground with a discharge: one steps over it. Our choice.
inline constexpr float narrowest_channel = 0.35F;

/// Marks the sea and the depressions that are deep and large enough to be lakes, with their depths.
void mark_standing_water(const Terrain& terrain, const Grid<std::uint8_t>& sea, const HydrologyOptions& options,
                         Hydrology& hydrology);

/// Sets the mean yearly discharge (m3/s) of every cell where a channel runs, none in lakes or the sea. Returns upstream_cells.
Grid<std::uint32_t> mark_discharge(const Terrain& terrain, const HydrologyOptions& options, Hydrology& hydrology);

/// Cuts the channels into reaches at junctions, lakes and the border.
void trace_reaches(Hydrology& hydrology);

/// Marks river cells with their depth, over the whole width of the channels.
void mark_rivers(const Terrain& terrain, Hydrology& hydrology);

/// Finds where rivers can be forded.
void find_fords(const Terrain& terrain, Hydrology& hydrology);

}  // namespace biotope
