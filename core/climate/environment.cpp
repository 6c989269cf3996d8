#include "core/climate/environment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/climate/environment_layers.hpp"
#include "core/climate/moisture.hpp"
#include "core/climate/soil.hpp"
#include "core/terrain/sun.hpp"

namespace biotope {
namespace {

/// Runs body over rows of a raster, many at once.
template <class Body>
void each_row(const Grid<float>& layer, const Body& body) {
  parallel_rows(0, layer.height(), [&](int y) { body(Rect{0, y, layer.width(), y + 1}); });
}

/// Twelve layers: the irradiance ratio, dimmed by the month's clouds, on the index scale.
MonthlyMap illumination_map(std::array<Grid<float>, months> ratios, const Climate& climate) {
  MonthlyMap map;
  for (std::size_t month = 0; month < ratios.size(); ++month) {
    Grid<float> layer = std::move(ratios[month]);
    each_row(layer, [&](const Rect& row) { irradiance_to_index(climate, month, row, layer); });
    map.layers.push_back(std::make_shared<const Grid<float>>(std::move(layer)));
  }
  return map;
}

MonthlyMap temperature_map(const Terrain& terrain, const Climate& climate) {
  Grid<float> layer(terrain.height.width(), terrain.height.height());
  each_row(layer, [&](const Rect& row) { temperature_of_heights(terrain, climate, row, layer); });
  return {{std::make_shared<const Grid<float>>(std::move(layer))}, temperature_offsets(climate)};
}

MonthlyMap moisture_map(Grid<float> layer, const Grid<Geology>& geology, const Climate& climate) {
  each_row(layer, [&](const Rect& row) { limit_moisture(geology, climate, row, layer); });
  return {{std::make_shared<const Grid<float>>(std::move(layer))}, moisture_offsets(climate)};
}

}  // namespace

void irradiance_to_index(const Climate& climate, std::size_t month, const Rect& cells, Grid<float>& layer) {
  const auto at_dark = float(illumination_scale.index(0));
  const auto per_ratio = float((1 - climate.cloud[month]) * (illumination_scale.index(1) - illumination_scale.index(0)));
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (float& cell : layer.row(y).subspan(std::size_t(cells.x0), std::size_t(cells.width()))) cell = at_dark + per_ratio * cell;
  }
}

void temperature_of_heights(const Terrain& terrain, const Climate& climate, const Rect& cells, Grid<float>& layer) {
  const double per_degree = temperature_scale.index(1) - temperature_scale.index(0);
  const auto per_metre = float(-per_degree * climate.lapse_rate / 1000);
  const auto at_zero = float(temperature_scale.index(0));
  const auto reference = float(climate.reference_height);
  for (int y = cells.y0; y < cells.y1; ++y) {
    const auto heights = terrain.height.row(y);
    const auto out = layer.row(y);
    for (auto x = std::size_t(cells.x0); x < std::size_t(cells.x1); ++x) out[x] = at_zero + per_metre * (heights[x] - reference);
  }
}

std::array<float, months> temperature_offsets(const Climate& climate) {
  const double per_degree = temperature_scale.index(1) - temperature_scale.index(0);
  std::array<float, months> offsets{};
  for (std::size_t month = 0; month < offsets.size(); ++month) {
    offsets[month] = float(per_degree * climate.temperature_mean[month]);
  }
  return offsets;
}

std::array<float, months> moisture_offsets(const Climate& climate) {
  std::array<float, months> offsets{};
  for (std::size_t month = 0; month < offsets.size(); ++month) {
    offsets[month] = float(moisture_offset(climate.precipitation[month]));
  }
  return offsets;
}

void limit_moisture(const Grid<Geology>& geology, const Climate& climate, const Rect& cells, Grid<float>& layer) {
  const auto offsets = moisture_offsets(climate);
  const float most = wettest_soil - *std::max_element(offsets.begin(), offsets.end());
  for (int y = cells.y0; y < cells.y1; ++y) {
    const auto rocks = geology.row(y);
    const auto row = layer.row(y);
    for (auto x = std::size_t(cells.x0); x < std::size_t(cells.x1); ++x) {
      if (rocks[x] != Geology::water) row[x] = std::min(row[x], most);
    }
  }
}

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
