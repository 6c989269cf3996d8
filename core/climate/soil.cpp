#include "core/climate/soil.hpp"

#include <algorithm>

#include "core/base/parallel.hpp"

namespace biotope {
namespace {

/// 0 below `from`, 1 above `to`, smooth between.
float ramp(float from, float to, float value) {
  const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

/// ln(water) above which flat ground is a flood plain, and above which a gentle slope gathers fine ground.
constexpr float flood_plain_water = 8;
constexpr float lower_slope_water = 4.5F;

Geology geology_of(float slope, float curvature, float water) {
  if (slope < 0.2F && water > flood_plain_water) return Geology::alluvium;
  if (slope > 0.55F && slope < 1.1F && curvature > 0.002F) return Geology::scree;
  if (slope < 0.3F && water > lower_slope_water) return Geology::marl;
  return Geology::limestone;
}

float texture_of(float slope, float water, Geology geology) {
  const float coarser = 4.5F * ramp(0.5F, 1.3F, slope);
  const float finer = 1.3F * (1 - ramp(0.03F, 0.2F, slope)) * ramp(6, 9, water);
  const float loam = 3.5F + coarser - finer;
  return geology == Geology::scree ? std::max(loam, 6.0F) : loam;
}

}  // namespace

SoilMaps estimate_soil(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, const Grid<float>& moisture) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  SoilMaps soil{Grid<float>(width, height), Grid<Geology>(width, height)};
  parallel_rows(0, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const float slope = derivatives.slope(x, y);
      const auto water = float(moisture_scale.physical(moisture(x, y)));
      const bool open_water = hydrology.water(x, y) != WaterKind::dry;
      const Geology geology = open_water ? Geology::water : geology_of(slope, derivatives.curvature(x, y), water);
      soil.geology(x, y) = geology;
      soil.texture(x, y) = texture_of(slope, water, geology);
    }
  });
  return soil;
}

}  // namespace biotope
