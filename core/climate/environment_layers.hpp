#pragma once

#include "core/climate/climate.hpp"
#include "core/climate/environment.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Parts of compute_environment that are local to cells.

/// Turns irradiance ratios of a month into indices, dimmed by its clouds.
void irradiance_to_index(const Climate& climate, std::size_t month, const Rect& cells, Grid<float>& layer);

/// Index of 0 deg C at the reference height, cooled with height; months shift it.
void temperature_of_heights(const Terrain& terrain, const Climate& climate, const Rect& cells, Grid<float>& layer);
/// What each month adds to it.
[[nodiscard]] std::array<float, months> temperature_offsets(const Climate& climate);

/// What each month's rain adds to the moisture.
[[nodiscard]] std::array<float, months> moisture_offsets(const Climate& climate);
/// Soil holds no more than soil can: even in the wettest month a bank is as wet as the wettest soil of the species tables, and
/// only open water is wetter. Without this a broad strip along every river would drown what grows there.
void limit_moisture(const Grid<Geology>& geology, const Climate& climate, const Rect& cells, Grid<float>& layer);

}  // namespace biotope
