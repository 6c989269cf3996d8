#include "core/climate/moisture.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/climate/diffusion.hpp"
#include "core/climate/environment.hpp"
#include "core/climate/soil_parts.hpp"

namespace biotope {
namespace {

/// Diffusivity falls to 1 % at slope 0.57 (Ecormier-Nocca 2021, public code).
const float slope_damping = float(std::log(0.01) / 0.57);
/// ln(water) of lakes and the sea for their banks: index 9 in a month of 55 mm. Our choice.
constexpr float standing_water = 11;
/// Narrowest bed of a channel that water spreads from, m. Our choice; makes the banks of a brook independent of the cell size.
constexpr float narrowest_bed = 2;
/// A dry month still has dew, mm.
constexpr double least_precipitation = 0.5;

/// Cube root of the square: the authors' exponent of the water, 2/3.
float two_thirds_power(float value) { return std::cbrt(value * value); }

}  // namespace

void wet_cells(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, const Rect& cells,
               Grid<float>& water, Grid<float>& conductance) {
  const auto cell_size = float(terrain.cell_size);
  const auto flat = float(moisture_spread * moisture_spread / (2 * spread_steps * terrain.cell_area()));
  const float standing = std::exp(standing_water);
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const float slope = derivatives.slope(x, y);
      const float discharge = hydrology.discharge(x, y);
      const WaterKind kind = hydrology.water(x, y);
      const bool stands = kind == WaterKind::lake || kind == WaterKind::sea;
      const float width = discharge > 0 ? std::max(narrowest_bed, river_width(discharge)) : cell_size;
      const float catchment = hydrology.catchment_area(x, y) / width;
      water(x, y) = stands ? standing : two_thirds_power(catchment / (0.1F + std::sqrt(slope)));
      const float eases = flat * std::exp(slope_damping * slope);
      conductance(x, y) = stands || discharge > 0 ? -eases : eases;
    }
  }
}

void moisture_of_water(const Hydrology& hydrology, const Grid<float>& spread, const Rect& cells, Grid<float>& moisture) {
  constexpr auto zero = float(moisture_scale.index(0));
  constexpr auto per_unit = float(8 / (moisture_scale.nine - moisture_scale.one));
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const bool open_water = hydrology.water(x, y) != WaterKind::dry;
      moisture(x, y) = open_water ? open_water_index : zero + per_unit * std::log(spread(x, y));
    }
  }
}

Result<Grid<float>> moisture_layer(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                                   const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Grid<float> water(width, height);
  Grid<float> conductance(width, height);
  parallel_rows(0, height, [&](int y) { wet_cells(terrain, derivatives, hydrology, {0, y, width, y + 1}, water, conductance); });
  for (int step = 0; step < spread_steps; ++step) {
    if (context.stopped()) return fail("stopped");
    context.report("moisture", double(step + 1) / (spread_steps + 1));
    diffuse(water, conductance);
  }
  parallel_rows(0, height, [&](int y) { moisture_of_water(hydrology, water, {0, y, width, y + 1}, water); });
  return water;
}

double moisture_offset(double precipitation) {
  return 8 / (moisture_scale.nine - moisture_scale.one) * std::log(std::max(precipitation, least_precipitation));
}

}  // namespace biotope
