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

/// How far the ground lies below the mean of its surroundings, m; negative on bulges. Smoothed, so that neither the cell size nor
/// the noise of a fine DEM shows.
[[nodiscard]] Grid<float> hollows(const Terrain& terrain);

/// What soil cells have (see SoilMaps).
struct SoilInput {
  const Derivatives& derivatives;
  const Hydrology& hydrology;
  const Grid<float>& hollow;
  const Grid<float>& moisture;
};
void soil_of_cells(const SoilInput& input, const Rect& cells, Grid<float>& texture, Grid<Geology>& geology);

}  // namespace biotope
