#include "core/climate/soil.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/climate/diffusion.hpp"
#include "core/climate/soil_parts.hpp"

namespace biotope {
namespace {

/// 0 below `from`, 1 above `to`, smooth between.
float ramp(float from, float to, float value) {
  const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// ln(water) above which gentle ground is a flood plain, and above which it gathers fine ground.
constexpr float flood_plain_water = 6.7F;
constexpr float lower_slope_water = 4.5F;
/// Over what distance ground is compared with its surroundings to tell hollows from bulges, standard deviation in metres.
constexpr double hollow_radius = 15;

/// 0..1: how much loose rock has come to rest: steep ground below what is steeper, but not a cliff itself.
float scree_share(float slope, float hollow) {
  return ramp(0.5F, 0.65F, slope) * (1 - ramp(1.0F, 1.3F, slope)) * ramp(-0.2F, 0.4F, hollow);
}

Geology geology_of(float slope, float hollow, float water) {
  if (slope < 0.25F && water > flood_plain_water) return Geology::alluvium;
  if (scree_share(slope, hollow) > 0.5F) return Geology::scree;
  if (slope < 0.3F && water > lower_slope_water) return Geology::marl;
  return Geology::limestone;
}

float texture_of(float slope, float hollow, float water) {
  const float coarser = 4.5F * std::max(ramp(0.55F, 1.4F, slope), 0.6F * scree_share(slope, hollow));
  const float finer = 1.3F * (1 - ramp(0.03F, 0.2F, slope)) * ramp(6, 9, water);
  return 3.5F + coarser - finer;
}

}  // namespace

float surroundings_conductance(const Terrain& terrain) {
  return float(hollow_radius * hollow_radius / (2 * terrain.cell_area()));
}

void soil_of_cells(const SoilInput& input, const Rect& cells, Grid<float>& texture, Grid<Geology>& geology) {
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const float slope = input.derivatives.slope(x, y);
      const float hollow = input.surroundings(x, y) - input.height(x, y);
      const auto water = float(moisture_scale.physical(input.moisture(x, y)));
      const bool open_water = input.hydrology.water(x, y) != WaterKind::dry;
      geology(x, y) = open_water ? Geology::water : geology_of(slope, hollow, water);
      texture(x, y) = texture_of(slope, hollow, water);
    }
  }
}

SoilMaps estimate_soil(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                       const Grid<float>& moisture) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Grid<float> surroundings = terrain.height;
  diffuse(surroundings, Grid<float>(width, height, surroundings_conductance(terrain)));
  SoilMaps soil{Grid<float>(width, height), Grid<Geology>(width, height)};
  const SoilInput input{derivatives, hydrology, terrain.height, surroundings, moisture};
  parallel_rows(0, height, [&](int y) { soil_of_cells(input, {0, y, width, y + 1}, soil.texture, soil.geology); });
  return soil;
}

}  // namespace biotope
