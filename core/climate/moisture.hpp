#pragma once

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/climate/climate.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Moisture index of open water before the month's rain is added: 9 in any month.
inline constexpr float open_water_index = 20;

/// Index of soil that can take up no more: the wettest that any plant of the thesis's table A.1 lives in (Alnus, Poaceae, Artemisia).
inline constexpr float wettest_soil = 8;

/// How far water spreads from a wet place on flat ground, standard deviation in metres. Our choice: at a river's bank the index falls
/// from that of the river to that of the slope within two to three of these.
inline constexpr double moisture_spread = 30;

/// Moisture index 1..9 of the ground in a month of 1 mm of rain, the layer of a MonthlyMap (see moisture_offset):
/// water = (a / (0.1 + sqrt(slope)))^(2/3) (Ecormier-Nocca 2021, public code), spread by diffusion, on moisture_scale.
///
/// The authors diffuse with a diffusivity that grows with the water itself, relative to the map's wettest cell, in 500 explicit steps of
/// 1 m cells. Here it depends on the slope alone (their exp(ln 0.01 / 0.57 slope)) and lengths are in metres, so that no place depends on
/// the rest of the map or on the cell size; channels and lakes keep their water, as a river is not emptied by what its banks soak up.
/// Water spreads, not its logarithm: water is what is conserved, and the logarithm of its tail makes the banks' even gradient.
/// Four implicit steps of alternating direction: positive everywhere, O(cells), parallel. Nothing when stopped.
[[nodiscard]] Result<Grid<float>> moisture_layer(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                                                 const TaskContext& context = {});

/// What a month's precipitation (mm, at least 0.5) adds to the index.
[[nodiscard]] double moisture_offset(double precipitation);

}  // namespace biotope
