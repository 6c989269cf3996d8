#include "core/climate/environment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/climate/moisture.hpp"
#include "core/climate/soil.hpp"
#include "core/terrain/sun.hpp"

namespace biotope {
namespace {

/// Twelve layers: the irradiance ratio, dimmed by the month's clouds, on the index scale.
MonthlyMap illumination_map(std::array<Grid<float>, months> ratios, const Climate& climate) {
  MonthlyMap map;
  for (std::size_t month = 0; month < ratios.size(); ++month) {
    Grid<float> layer = std::move(ratios[month]);
    const auto at_dark = float(illumination_scale.index(0));
    const auto per_ratio = float((1 - climate.cloud[month]) * (illumination_scale.index(1) - illumination_scale.index(0)));
    parallel_rows(0, layer.height(), [&](int y) {
      for (float& cell : layer.row(y)) cell = at_dark + per_ratio * cell;
    });
    map.layers.push_back(std::make_shared<const Grid<float>>(std::move(layer)));
  }
  return map;
}

/// One layer, the index of 0 deg C at the reference height cooled with height; months shift it.
MonthlyMap temperature_map(const Terrain& terrain, const Climate& climate) {
  Grid<float> layer(terrain.height.width(), terrain.height.height());
  const double per_degree = temperature_scale.index(1) - temperature_scale.index(0);
  const auto per_metre = float(-per_degree * climate.lapse_rate / 1000);
  const auto at_zero = float(temperature_scale.index(0));
  const auto reference = float(climate.reference_height);
  parallel_rows(0, layer.height(), [&](int y) {
    const auto heights = terrain.height.row(y);
    const auto out = layer.row(y);
    for (std::size_t x = 0; x < out.size(); ++x) out[x] = at_zero + per_metre * (heights[x] - reference);
  });
  MonthlyMap map;
  map.layers.push_back(std::make_shared<const Grid<float>>(std::move(layer)));
  for (std::size_t month = 0; month < map.offset.size(); ++month) {
    map.offset[month] = float(per_degree * climate.temperature_mean[month]);
  }
  return map;
}

/// One layer that months shift. Soil holds no more than soil can: even in the wettest month a bank is as wet as the wettest soil of the
/// species tables, and only open water is wetter. Without this a broad strip along every river would drown what grows there.
MonthlyMap moisture_map(Grid<float> layer, const Grid<Geology>& geology, const Climate& climate) {
  MonthlyMap map;
  for (std::size_t month = 0; month < map.offset.size(); ++month) {
    map.offset[month] = float(moisture_offset(climate.precipitation[month]));
  }
  const float most = wettest_soil - *std::max_element(map.offset.begin(), map.offset.end());
  parallel_rows(0, layer.height(), [&](int y) {
    const auto rocks = geology.row(y);
    const auto row = layer.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      if (rocks[x] != Geology::water) row[x] = std::min(row[x], most);
    }
  });
  map.layers.push_back(std::make_shared<const Grid<float>>(std::move(layer)));
  return map;
}

}  // namespace

Result<EnvironmentMaps> compute_environment(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                                            const Climate& climate, const TaskContext& context) {
  assert(derivatives.slope.rect() == terrain.height.rect() && hydrology.catchment_area.rect() == terrain.height.rect());
  auto ratios = compute_monthly_illumination(terrain, derivatives, context);
  if (!ratios) return tl::unexpected(ratios.error());
  EnvironmentMaps maps;
  maps.monthly[std::size_t(Resource::illumination)] = illumination_map(std::move(*ratios), climate);
  if (context.stopped()) return fail("stopped");
  maps.monthly[std::size_t(Resource::temperature)] = temperature_map(terrain, climate);

  Result<Grid<float>> moisture = moisture_layer(terrain, derivatives, hydrology, context);
  if (!moisture) return tl::unexpected(moisture.error());
  context.report("soil", 0);
  SoilMaps soil = estimate_soil(terrain, derivatives, hydrology, *moisture);
  maps.texture = std::make_shared<const Grid<float>>(std::move(soil.texture));
  maps.geology = std::make_shared<const Grid<Geology>>(std::move(soil.geology));
  maps.monthly[std::size_t(Resource::moisture)] = moisture_map(std::move(*moisture), *maps.geology, climate);
  return maps;
}

}  // namespace biotope
