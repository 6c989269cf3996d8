#include "core/exchange/document_scale.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/exchange/dem_import.hpp"
#include "core/exchange/resample.hpp"

namespace biotope {
namespace {

/// The cell of the source under the centre of cell `at` of the result.
int nearest_cell(int at, double ratio, int source_side) { return std::clamp(int((at + 0.5) * ratio), 0, source_side - 1); }

/// Values are weighted by their coverage, so that unpainted cells lend no colour to their neighbours.
std::shared_ptr<const PaintLayer> resampled_layer(const PaintLayer& layer, double ratio, int width, int height) {
  Grid<float> weighted(layer.width(), layer.height());
  Grid<float> coverage(layer.width(), layer.height());
  parallel_rows(0, layer.height(), [&](int y) {
    std::vector<Paint> row(std::size_t(layer.width()));
    layer.read_row(y, 0, row);
    for (int x = 0; x < layer.width(); ++x) {
      const Paint paint = row[std::size_t(x)];
      weighted(x, y) = paint.value * paint.coverage;
      coverage(x, y) = paint.coverage;
    }
  });
  weighted = resampled_grid(weighted, ratio, width, height);
  coverage = resampled_grid(coverage, ratio, width, height);
  auto result = std::make_shared<PaintLayer>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (coverage(x, y) > 0) result->set(x, y, {weighted(x, y) / coverage(x, y), coverage(x, y)});
    }
  }
  return result;
}

/// The nearest cell's paint: classes must not mix.
std::shared_ptr<const PaintLayer> nearest_layer(const PaintLayer& layer, double ratio, int width, int height) {
  auto result = std::make_shared<PaintLayer>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Paint paint = layer(nearest_cell(x, ratio, layer.width()), nearest_cell(y, ratio, layer.height()));
      if (paint != Paint{}) result->set(x, y, paint);
    }
  }
  return result;
}

std::shared_ptr<const SelectionMask> resampled_selection(const SelectionMask& mask, double ratio, int width, int height) {
  Grid<float> values(mask.width(), mask.height());
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) values(x, y) = float(mask(x, y));
  }
  values = resampled_grid(values, ratio, width, height);
  auto result = std::make_shared<SelectionMask>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto selected = std::uint8_t(std::lround(std::clamp(values(x, y), 0.0F, 255.0F)));
      if (selected != 0) result->set(x, y, selected);
    }
  }
  return result;
}

/// Calls `change` with every point of the placements.
template <class Change>
void change_points(Placements& placements, const Change& change) {
  const auto change_all = [&](auto& items, auto member) {
    for (auto& item : items) {
      for (PathPoint& point : item.*member) change(point);
    }
  };
  change_all(placements.water.rivers, &DrawnRiver::course);
  change_all(placements.water.lakes, &DrawnLake::shore);
  change_all(placements.places.pinned_trails, &PinnedTrail::points);
  change_all(placements.places.forbidden_trails, &ForbiddenTrail::points);
  for (PlacedFord& ford : placements.places.fords) change(ford.at);
  for (PlacedExit& exit : placements.places.exits) change(exit.at);
  for (Waypoint& waypoint : placements.places.waypoints) change(waypoint.at);
  for (PlanEdit& plan : placements.plans) {
    change(plan.home);
    for (PlanStopEdit& stop : plan.stops) change(stop.at);
  }
}

std::shared_ptr<const Grid<Geology>> resampled_geology(const Grid<Geology>& geology, double ratio, int width, int height) {
  auto result = std::make_shared<Grid<Geology>>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      (*result)(x, y) = geology(nearest_cell(x, ratio, geology.width()), nearest_cell(y, ratio, geology.height()));
    }
  }
  return result;
}

}  // namespace

Document resampled_document(const Document& document, int longer_side) {
  const Terrain& source = *document.terrain;
  const int source_longer = std::max(source.height.width(), source.height.height());
  if (longer_side == source_longer) return document;
  const double ratio = double(source_longer) / longer_side;
  Document result = document;
  auto terrain = std::make_shared<Terrain>(resampled(source, longer_side));
  const int width = terrain->height.width();
  const int height = terrain->height.height();
  result.terrain = std::move(terrain);
  for (Inflow& inflow : result.inflows) {
    inflow.x = std::clamp(int((inflow.x + 0.5) / ratio), 0, width - 1);
    inflow.y = std::clamp(int((inflow.y + 0.5) / ratio), 0, height - 1);
  }
  for (auto& [id, layer] : result.layers) {
    const auto& resample = id.kind == LayerKind::geology ? nearest_layer : resampled_layer;
    if (layer) layer = resample(*layer, ratio, width, height);
  }
  if (result.selection) result.selection = resampled_selection(*result.selection, ratio, width, height);
  if (result.locked_area) result.locked_area = resampled_selection(*result.locked_area, ratio, width, height);
  // Points lie at cell centres plus whole numbers: the map's corner is at -0.5.
  change_points(result.placements, [&](PathPoint& point) {
    point = {float((point.x + 0.5) / ratio - 0.5), float((point.y + 0.5) / ratio - 0.5)};
  });
  for (auto& maps : result.given_environment.monthly) {
    for (auto& map : maps) map = std::make_shared<Grid<float>>(resampled_grid(*map, ratio, width, height));
  }
  auto& geology = result.given_environment.geology;
  if (geology) geology = resampled_geology(*geology, ratio, width, height);
  return result;
}

Document with_cell_size(const Document& document, double cell_size) {
  Document result = document;
  auto terrain = std::make_shared<Terrain>(*document.terrain);
  const double ratio = cell_size / terrain->cell_size;
  terrain->cell_size = cell_size;
  terrain->georeference.wkt.clear();
  terrain->georeference.transform = {0, cell_size, 0, terrain->height.height() * cell_size, 0, -cell_size};
  for (Inflow& inflow : result.inflows) inflow.catchment_area *= ratio * ratio;
  for (DrawnRiver& river : result.placements.water.rivers) river.discharge *= ratio * ratio;
  for (PlacedFord& ford : result.placements.places.fords) ford.radius *= float(ratio);
  for (PlacedExit& exit : result.placements.places.exits) exit.radius *= float(ratio);
  for (ForbiddenTrail& trail : result.placements.places.forbidden_trails) trail.radius *= float(ratio);
  result.terrain = std::move(terrain);
  return result;
}

}  // namespace biotope
