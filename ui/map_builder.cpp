#include "ui/map_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/ecosystem/surplus.hpp"
#include "core/pipeline/edit_grounds.hpp"
#include "ui/layer_values.hpp"

namespace biotope {
namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

template <class Value>
std::shared_ptr<Grid<float>> fill(int width, int height, const Value& value) {
  auto grid = std::make_shared<Grid<float>>(width, height);
  parallel_rows(0, height, [&](int y) {
    const std::span<float> row = grid->row(y);
    for (int x = 0; x < width; ++x) row[std::size_t(x)] = value(x, y);
  });
  return grid;
}

MapValues with_range(std::shared_ptr<const Grid<float>> cells) {
  MapValues values{std::move(cells), 0, 0};
  if (!values.cells) return values;
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const float value : values.cells->cells()) {
    if (std::isnan(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low <= high) {
    values.low = low;
    values.high = high;
  }
  return values;
}

constexpr Resource resource_of(MapKind kind) {
  if (kind == MapKind::illumination) return Resource::illumination;
  return kind == MapKind::temperature ? Resource::temperature : Resource::moisture;
}

LayerId resource_layer(MapKind kind) {
  if (kind == MapKind::illumination) return {LayerKind::resource, "illumination"};
  return {LayerKind::resource, kind == MapKind::temperature ? "temperature" : "moisture"};
}

/// A resource with paint at a cell: paint shifts all months by what it changes of the yearly mean.
float resource_value(const MonthlyMap& map, const PaintLayer* paint, int month, int x, int y) {
  const Paint over = paint != nullptr ? (*paint)(x, y) : Paint{};
  if (month < 0 || over.coverage > 0) {
    const float mean = map.mean(x, y);
    const float shifted = painted(mean, over);
    return std::clamp(month < 0 ? shifted : map.value(month, x, y) + shifted - mean, 1.0F, 9.0F);
  }
  return map.value(month, x, y);
}

float slope_degrees(float rise_over_run) { return std::atan(rise_over_run) * 57.29578F; }

std::shared_ptr<Grid<float>> cover_grid(const CoverMap& cover) {
  auto grid = std::make_shared<Grid<float>>(cover.width(), cover.height());
  std::vector<Cover> row(std::size_t(cover.width()));
  for (int y = 0; y < cover.height(); ++y) {
    cover.read_row(y, 0, row);
    std::transform(row.begin(), row.end(), grid->row(y).begin(), [](Cover c) { return cover_fraction(c); });
  }
  return grid;
}

/// Ground covered by a stratum: covers of a stratum share its ground, so they add up to at most 1.
std::shared_ptr<Grid<float>> group_grid(const MapsSnapshot& snapshot, int stratum) {
  std::shared_ptr<Grid<float>> sum;
  for (std::size_t i = 0; i < snapshot.cover.size(); ++i) {
    const Species& species = snapshot.web->species[std::size_t(snapshot.web->levels[0][i])];
    if (!snapshot.cover[i] || int(species.plant().stratum) != stratum) continue;
    const auto grid = cover_grid(*snapshot.cover[i]);
    if (!sum) {
      sum = grid;
      continue;
    }
    for (std::size_t cell = 0; cell < sum->size(); ++cell) (*sum)[cell] = std::min((*sum)[cell] + (*grid)[cell], 1.0F);
  }
  return sum;
}

std::shared_ptr<const Grid<float>> ground_map(const MapsSnapshot& snapshot, MapKind kind) {
  const Terrain& terrain = snapshot.terrain();
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  switch (kind) {
    case MapKind::height:
      return std::shared_ptr<const Grid<float>>(snapshot.land ? snapshot.land : snapshot.document.terrain, &terrain.height);
    case MapKind::slope:
      return fill(width, height, [&](int x, int y) { return slope_degrees(snapshot.derivatives->slope(x, y)); });
    case MapKind::curvature:
      return std::shared_ptr<const Grid<float>>(snapshot.derivatives, &snapshot.derivatives->curvature);
    case MapKind::water_depth:
      return std::shared_ptr<const Grid<float>>(snapshot.hydrology, &snapshot.hydrology->water_depth);
    default:
      return nullptr;
  }
}

/// The layer of paint that a map shows beside what lies under it; nothing for maps that are no layer's own.
std::optional<LayerId> shown_layer(const MapsSnapshot& snapshot, const MapId& id) {
  switch (id.kind) {
    case MapKind::texture:
      return LayerId{LayerKind::resource, "texture"};
    case MapKind::geology:
      return LayerId{LayerKind::geology, "class"};
    case MapKind::ground_change:
      return LayerId{LayerKind::ground, "height"};
    case MapKind::passage:
      return LayerId{LayerKind::passage, "all"};
    case MapKind::loss:
      if (!snapshot.web || id.item < 0 || id.item >= int(snapshot.web->species.size())) return std::nullopt;
      return LayerId{LayerKind::loss, snapshot.web->species[std::size_t(id.item)].name};
    default:
      return std::nullopt;
  }
}

/// What is computed under such a layer at a cell.
float computed_at(const MapsSnapshot& snapshot, LayerKind kind, int x, int y) {
  switch (kind) {
    case LayerKind::resource:
      return (*snapshot.environment->texture)(x, y);
    case LayerKind::geology:
      return float((*snapshot.environment->geology)(x, y));
    case LayerKind::ground:
      return snapshot.document.terrain->height(x, y);
    default:
      return 0;
  }
}

std::shared_ptr<const Grid<float>> layer_map(const MapsSnapshot& snapshot, const LayerId& layer) {
  const auto& height = snapshot.document.terrain->height;
  const auto paint = snapshot.paint(layer);
  if (layer.name == "texture" && !paint) return snapshot.environment->texture;
  return fill(height.width(), height.height(), [&](int x, int y) {
    return shown_value(layer.kind, computed_at(snapshot, layer.kind, x, y), paint ? (*paint)(x, y) : Paint{});
  });
}

/// What such a map is made from: its paint, or what lies under it where there is none.
const void* layer_map_source(const MapsSnapshot& snapshot, const LayerId& layer) {
  const bool needs_environment = layer.kind == LayerKind::resource || layer.kind == LayerKind::geology;
  if (needs_environment && !snapshot.environment) return nullptr;
  const auto paint = snapshot.paint(layer);
  if (paint && needs_environment) return &snapshot;
  if (paint) return paint.get();
  return needs_environment ? static_cast<const void*>(snapshot.environment.get()) : snapshot.document.terrain.get();
}

std::shared_ptr<const Grid<float>> plant_map(const MapsSnapshot& snapshot, const MapId& id) {
  if (id.kind == MapKind::group_cover) return group_grid(snapshot, id.item);
  const auto plant = std::size_t(find_plant(snapshot, id.item));
  if (id.kind == MapKind::plant_cover) return cover_grid(*snapshot.cover[plant]);
  if (id.kind == MapKind::plant_fitness) {
    const PlantTraits& traits = snapshot.web->species[std::size_t(id.item)].plant();
    return std::make_shared<Grid<float>>(fitness_map(traits, snapshot.plant_environment()));
  }
  return std::make_shared<Grid<float>>(
      plant_surplus(*snapshot.web, id.item, *snapshot.cover[plant], snapshot.animals, snapshot.loss(id.item).get()));
}

std::shared_ptr<const Grid<float>> animal_map(const MapsSnapshot& snapshot, const MapId& id) {
  const auto [level, index] = find_animal(snapshot, id.item);
  if (id.kind == MapKind::animal_density) {
    const auto paint = snapshot.paint({LayerKind::animal_density, snapshot.web->species[std::size_t(id.item)].name});
    return std::make_shared<Grid<float>>(animal_density(*level, index, paint.get()));
  }
  if (id.kind == MapKind::animal_surplus) {
    return std::make_shared<Grid<float>>(
        animal_surplus(*snapshot.web, id.item, *level, snapshot.animals, snapshot.loss(id.item).get()));
  }
  const RunMap& label = level->regions[std::size_t(index)]->label;
  return fill(label.width(), label.height(), [&](int x, int y) { return float(label(x, y)); });
}

}  // namespace

AnimalPlace find_animal(const MapsSnapshot& snapshot, int species) {
  for (const auto& level : snapshot.animals) {
    if (!level) continue;
    const auto found = std::find(level->species.begin(), level->species.end(), species);
    if (found != level->species.end()) return {level.get(), int(found - level->species.begin())};
  }
  return {};
}

int find_plant(const MapsSnapshot& snapshot, int species) {
  if (!snapshot.web || snapshot.web->levels.empty()) return -1;
  const std::vector<int>& plants = snapshot.web->levels[0];
  const auto found = std::find(plants.begin(), plants.end(), species);
  return found == plants.end() ? -1 : int(found - plants.begin());
}

const void* source_of(const MapsSnapshot& snapshot, const MapId& id) {
  switch (id.kind) {
    case MapKind::none:
      return nullptr;
    case MapKind::height:
      return &snapshot.terrain();
    case MapKind::slope:
    case MapKind::curvature:
      return snapshot.derivatives.get();
    case MapKind::water_depth:
      return snapshot.hydrology.get();
    case MapKind::texture:
    case MapKind::geology:
    case MapKind::ground_change:
    case MapKind::passage:
    case MapKind::loss: {
      const std::optional<LayerId> layer = shown_layer(snapshot, id);
      return layer ? layer_map_source(snapshot, *layer) : nullptr;
    }
    case MapKind::illumination:
    case MapKind::temperature:
    case MapKind::moisture: {
      if (!snapshot.environment) return nullptr;
      const auto paint = snapshot.paint(resource_layer(id.kind));
      return paint ? static_cast<const void*>(&snapshot) : snapshot.environment.get();
    }
    case MapKind::plant_cover: {
      const int plant = find_plant(snapshot, id.item);
      return plant >= 0 && plant < int(snapshot.cover.size()) ? snapshot.cover[std::size_t(plant)].get() : nullptr;
    }
    case MapKind::plant_fitness:
      return snapshot.environment && find_plant(snapshot, id.item) >= 0 ? &snapshot : nullptr;
    case MapKind::group_cover:
      return snapshot.web && !snapshot.cover.empty() ? &snapshot : nullptr;
    case MapKind::plant_surplus: {
      const int plant = find_plant(snapshot, id.item);
      const bool known =
          plant >= 0 && plant < int(snapshot.cover.size()) && snapshot.cover[std::size_t(plant)] && snapshot.complete;
      return known ? &snapshot : nullptr;
    }
    case MapKind::animal_density:
    case MapKind::animal_regions:
    case MapKind::animal_surplus:
      return find_animal(snapshot, id.item).level;
    case MapKind::trail_wear:
      return snapshot.trails.get();
  }
  return nullptr;
}

MapValues build_map(const MapsSnapshot& snapshot, const MapId& id) {
  if (source_of(snapshot, id) == nullptr) return {};
  switch (id.kind) {
    case MapKind::none:
      return {};
    case MapKind::height:
    case MapKind::slope:
    case MapKind::curvature:
    case MapKind::water_depth:
      return with_range(ground_map(snapshot, id.kind));
    case MapKind::texture:
    case MapKind::geology:
    case MapKind::ground_change:
    case MapKind::passage:
    case MapKind::loss:
      return with_range(layer_map(snapshot, *shown_layer(snapshot, id)));
    case MapKind::illumination:
    case MapKind::temperature:
    case MapKind::moisture: {
      const MonthlyMap& map = snapshot.environment->map(resource_of(id.kind));
      const auto paint = snapshot.paint(resource_layer(id.kind));
      const Grid<float>& layer = map.layer(0);
      return with_range(
          fill(layer.width(), layer.height(), [&](int x, int y) { return resource_value(map, paint.get(), id.month, x, y); }));
    }
    case MapKind::plant_cover:
    case MapKind::plant_fitness:
    case MapKind::plant_surplus:
    case MapKind::group_cover:
      return with_range(plant_map(snapshot, id));
    case MapKind::animal_density:
    case MapKind::animal_regions:
    case MapKind::animal_surplus:
      return with_range(animal_map(snapshot, id));
    case MapKind::trail_wear:
      return with_range(std::shared_ptr<const Grid<float>>(snapshot.trails, &snapshot.trails->wear));
  }
  return {};
}

std::shared_ptr<const Grid<float>> computed_under(const MapsSnapshot& snapshot, const LayerId& layer) {
  return computed_map(snapshot, layer);
}

std::shared_ptr<const void> computed_source(const MapsSnapshot& snapshot, const LayerId& layer) {
  return computed_map_source(snapshot, layer);
}

float value_at(const MapsSnapshot& snapshot, const MapId& id, int x, int y) {
  if (!snapshot.document.terrain || !snapshot.terrain().height.contains(x, y) || source_of(snapshot, id) == nullptr)
    return unknown;
  switch (id.kind) {
    case MapKind::height:
      return snapshot.terrain().height(x, y);
    case MapKind::slope:
      return slope_degrees(snapshot.derivatives->slope(x, y));
    case MapKind::curvature:
      return snapshot.derivatives->curvature(x, y);
    case MapKind::water_depth:
      return snapshot.hydrology->water_depth(x, y);
    case MapKind::texture:
    case MapKind::geology:
    case MapKind::ground_change:
    case MapKind::passage:
    case MapKind::loss: {
      const LayerId layer = *shown_layer(snapshot, id);
      const auto paint = snapshot.paint(layer);
      return shown_value(layer.kind, computed_at(snapshot, layer.kind, x, y), paint ? (*paint)(x, y) : Paint{});
    }
    case MapKind::plant_cover:
      return cover_fraction((*snapshot.cover[std::size_t(find_plant(snapshot, id.item))])(x, y));
    case MapKind::illumination:
    case MapKind::temperature:
    case MapKind::moisture:
      return resource_value(snapshot.environment->map(resource_of(id.kind)), snapshot.paint(resource_layer(id.kind)).get(),
                            id.month, x, y);
    case MapKind::trail_wear:
      return snapshot.trails->wear(x, y);
    default:
      return unknown;
  }
}

}  // namespace biotope
