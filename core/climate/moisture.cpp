#include "core/climate/moisture.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/climate/environment.hpp"
#include "core/climate/diffusion.hpp"

namespace biotope {
namespace {

/// Steps of the diffusion; enough for a round spot.
constexpr int spread_steps = 4;
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

/// Water before it spreads, and how easily it does; cells that keep their water get a negative conductance.
void wet_row(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, int y, Grid<float>& water,
             Grid<float>& conductance) {
  const auto cell_size = float(terrain.cell_size);
  const auto flat = float(moisture_spread * moisture_spread / (2 * spread_steps * terrain.cell_area()));
  const float standing = std::exp(standing_water);
  for (int x = 0; x < water.width(); ++x) {
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

}  // namespace

Result<Grid<float>> moisture_layer(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                                   const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Grid<float> water(width, height);
  Grid<float> conductance(width, height);
  parallel_rows(0, height, [&](int y) { wet_row(terrain, derivatives, hydrology, y, water, conductance); });
  for (int step = 0; step < spread_steps; ++step) {
    if (context.stopped()) return fail("stopped");
    context.report("moisture", double(step + 1) / (spread_steps + 1));
    diffuse(water, conductance);
  }
  constexpr auto zero = float(moisture_scale.index(0));
  constexpr auto per_unit = float(8 / (moisture_scale.nine - moisture_scale.one));
  parallel_rows(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const bool open_water = hydrology.water(x, y) != WaterKind::dry;
      water(x, y) = open_water ? open_water_index : zero + per_unit * std::log(water(x, y));
    }
  });
  return water;
}

double moisture_offset(double precipitation) {
  return 8 / (moisture_scale.nine - moisture_scale.one) * std::log(std::max(precipitation, least_precipitation));
}

}  // namespace biotope
