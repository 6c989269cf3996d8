#pragma once

#include "core/base/grid.hpp"
#include "core/climate/environment.hpp"

namespace biotope {

/// Soil of a terrain that has no soil map, guessed from what shapes it. Our choice throughout:
///   water      where a river is wide enough to be seen, in lakes and the sea
///   alluvium   flat and near running or standing water (as the spread moisture tells): flood plains and wet bottoms
///   scree      steep ground (but no cliff) in a hollow, where what falls off the cliff above comes to rest
///   marl       gentle lower slopes, where fine ground gathers
///   limestone  all else: plateaus, ridges, open slopes and cliffs
struct SoilMaps {
  /// Index 1 (clay) .. 9 (stones): 3.5 (loam) on ordinary ground, finer in wet bottoms, coarser where it is steep.
  Grid<float> texture;
  Grid<Geology> geology;
};

/// `moisture` is moisture_layer's result. Parallel.
[[nodiscard]] SoilMaps estimate_soil(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                                     const Grid<float>& moisture);

}  // namespace biotope
