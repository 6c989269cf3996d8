#pragma once

#include "core/base/grid.hpp"
#include "core/climate/environment.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

// Stages of moisture_layer and estimate_soil. Those with a rectangle are local to cells.

/// Steps of the diffusion of water; enough for a round spot.
inline constexpr int spread_steps = 4;

/// Water before it spreads, and how easily it does; cells that keep their water get a negative conductance.
void wet_cells(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, const Rect& cells,
               Grid<float>& water, Grid<float>& conductance);

/// Moisture (see moisture_layer) of spread water.
void moisture_of_water(const Hydrology& hydrology, const Grid<float>& spread, const Rect& cells, Grid<float>& moisture);

/// Conductance of the diffusion (one step, see diffuse) that gives every cell the mean height of its surroundings, so that
/// neither the cell size nor the noise of a fine DEM shows in what is a hollow.
[[nodiscard]] float surroundings_conductance(const Terrain& terrain);

/// What soil cells have (see SoilMaps).
struct SoilInput {
  const Derivatives& derivatives;
  const Hydrology& hydrology;
  const Grid<float>& height;
  /// Mean height of the surroundings, m: hollows lie below it, bulges above.
  const Grid<float>& surroundings;
  const Grid<float>& moisture;
};
void soil_of_cells(const SoilInput& input, const Rect& cells, Grid<float>& texture, Grid<Geology>& geology);

}  // namespace biotope
