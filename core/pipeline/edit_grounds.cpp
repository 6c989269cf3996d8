#include "core/pipeline/edit_grounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/base/parallel.hpp"

namespace biotope {
namespace {

using MapPointer = std::shared_ptr<const Grid<float>>;

constexpr float degrees = 180 / std::numbers::pi_v<float>;

/// A map of the size of another, cell by cell.
template <class Value>
MapPointer made(int width, int height, const Value& value) {
  auto grid = std::make_shared<Grid<float>>(width, height);
  parallel_rows(0, height, [&](int y) {
    const std::span<float> row = grid->row(y);
    for (int x = 0; x < width; ++x) row[std::size_t(x)] = value(x, y);
  });
  return grid;
}

std::optional<Resource> monthly_resource(std::string_view name) {
  static constexpr std::array<std::string_view, monthly_resources> names{"illumination", "temperature", "moisture"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return Resource(found - names.begin());
}

/// Place of a species among the plants of a snapshot's web; -1 when there is none.
int plant_index(const MapsSnapshot& snapshot, const std::string& name) {
  if (!snapshot.web || snapshot.web->levels.empty()) return -1;
  const int species = snapshot.web->find(name);
  const auto& plants = snapshot.web->levels.front();
  const auto found = std::find(plants.begin(), plants.end(), species);
  return found == plants.end() ? -1 : int(found - plants.begin());
}

std::shared_ptr<const CoverMap> computed_cover(const MapsSnapshot& snapshot, const std::string& name) {
  const int plant = plant_index(snapshot, name);
  return plant >= 0 && plant < int(snapshot.computed_cover.size()) ? snapshot.computed_cover[std::size_t(plant)] : nullptr;
}

std::shared_ptr<const AnimalLevel> level_of(const MapsSnapshot& snapshot, const std::string& name) {
  const int species = snapshot.web ? snapshot.web->find(name) : -1;
  for (const auto& level : snapshot.animals) {
    if (level && std::find(level->species.begin(), level->species.end(), species) != level->species.end()) return level;
  }
  return nullptr;
}

MapPointer cover_map(const CoverMap& cover) {
  auto grid = std::make_shared<Grid<float>>(cover.width(), cover.height());
  parallel_rows(0, cover.height(), [&](int y) {
    std::vector<Cover> row(std::size_t(cover.width()));
    cover.read_row(y, 0, row);
    std::transform(row.begin(), row.end(), grid->row(y).begin(), [](Cover c) { return cover_fraction(c); });
  });
  return grid;
}

/// Individuals per km2 by region, as competition made them; 0 outside all regions.
MapPointer density_map(const AnimalLevel& level, int species) {
  const auto index = std::size_t(std::find(level.species.begin(), level.species.end(), species) - level.species.begin());
  const ConfinementRegions& regions = *level.regions[index];
  std::vector<float> density(regions.regions.size(), 0);
  for (std::size_t region = 0; region < density.size(); ++region) {
    const double square_km = regions.regions[region].area / 1e6;
    const bool known = index < level.computed_population.size() && region < level.computed_population[index].size();
    if (known && square_km > 0) density[region] = float(level.computed_population[index][region] / square_km);
  }
  return made(regions.label.width(), regions.label.height(), [&](int x, int y) {
    const std::int32_t region = regions.label(x, y);
    return region >= 0 ? density[std::size_t(region)] : 0.0F;
  });
}

MapPointer resource_map(const EnvironmentMaps& environment, const std::string& name) {
  if (name == "texture") return environment.texture;
  const auto resource = monthly_resource(name);
  if (!resource) return nullptr;
  const MonthlyMap& map = environment.map(*resource);
  return made(map.layer(0).width(), map.layer(0).height(), [&](int x, int y) { return map.mean(x, y); });
}

MapPointer aspect_map(const Derivatives& derivatives) {
  const auto& slope = derivatives.slope;
  return made(slope.width(), slope.height(), [&](int x, int y) {
    const float east = derivatives.east(x, y);
    const float north = derivatives.north(x, y);
    return east == 0 && north == 0 ? -1.0F : aspect(east, north) * degrees;
  });
}

MapPointer water_distance_map(const Hydrology& hydrology, double cell_size) {
  Grid<std::uint8_t> wet(hydrology.water.width(), hydrology.water.height());
  std::transform(hydrology.water.cells().begin(), hydrology.water.cells().end(), wet.cells().begin(),
                 [](WaterKind kind) { return std::uint8_t(kind == WaterKind::dry ? 0 : 1); });
  return std::make_shared<const Grid<float>>(distance_to(wet, cell_size));
}

/// Computed maps made at first use.
class ComputedMaps {
 public:
  explicit ComputedMaps(std::shared_ptr<const MapsSnapshot> snapshot) : snapshot_(std::move(snapshot)) {}
  MapPointer operator()(const LayerId& layer) {
    const std::lock_guard lock(mutex_);
    const auto found = maps_.find(layer);
    return found != maps_.end() ? found->second : maps_.emplace(layer, computed_map(*snapshot_, layer)).first->second;
  }

 private:
  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::mutex mutex_;
  std::map<LayerId, MapPointer> maps_;
};

EditGrounds grounds_without_filters(const std::shared_ptr<const MapsSnapshot>& snapshot) {
  EditGrounds grounds;
  grounds.computed = [maps = std::make_shared<ComputedMaps>(snapshot)](const LayerId& layer) { return (*maps)(layer); };
  return grounds;
}

void add_filter_map(FilterMaps& filters, const MapsSnapshot& snapshot, FilterQuantity quantity) {
  switch (quantity) {
    case FilterQuantity::slope:
      if (!filters.slope) filters.slope = filter_map(snapshot, quantity);
      break;
    case FilterQuantity::altitude:
      if (!filters.altitude) filters.altitude = filter_map(snapshot, quantity);
      break;
    case FilterQuantity::aspect:
      if (!filters.aspect) filters.aspect = filter_map(snapshot, quantity);
      break;
    case FilterQuantity::water_distance:
      if (!filters.water_distance) filters.water_distance = filter_map(snapshot, quantity);
      break;
    case FilterQuantity::map:
      break;
  }
}

/// A layer that this snapshot's species and resources will never have.
bool unknown_layer(const MapsSnapshot& snapshot, const LayerId& layer) {
  switch (layer.kind) {
    case LayerKind::resource:
      return layer.name != "texture" && !monthly_resource(layer.name);
    case LayerKind::plant_density:
      return snapshot.web && plant_index(snapshot, layer.name) < 0;
    case LayerKind::animal_density: {
      const int species = snapshot.web ? snapshot.web->find(layer.name) : 0;
      return species < 0 || (snapshot.web && snapshot.web->level[std::size_t(species)] == 0);
    }
    default:
      return false;
  }
}

bool holds_filter(const MapsSnapshot& snapshot, FilterQuantity quantity) {
  switch (quantity) {
    case FilterQuantity::slope:
    case FilterQuantity::aspect:
      return snapshot.derivatives != nullptr;
    case FilterQuantity::water_distance:
      return snapshot.hydrology != nullptr;
    case FilterQuantity::altitude:
      return snapshot.land != nullptr;
    case FilterQuantity::map:
      return true;
  }
  return true;
}

}  // namespace

std::shared_ptr<const void> computed_map_source(const MapsSnapshot& snapshot, const LayerId& layer) {
  switch (layer.kind) {
    case LayerKind::resource:
      return unknown_layer(snapshot, layer) ? nullptr : snapshot.environment;
    case LayerKind::geology:
      return snapshot.environment;
    case LayerKind::plant_density:
      return computed_cover(snapshot, layer.name);
    case LayerKind::animal_density:
      return level_of(snapshot, layer.name);
    case LayerKind::loss:
    case LayerKind::passage:
    case LayerKind::ground:
      return snapshot.document.terrain;
  }
  return nullptr;
}

std::shared_ptr<const Grid<float>> computed_map(const MapsSnapshot& snapshot, const LayerId& layer) {
  if (!computed_map_source(snapshot, layer)) return nullptr;
  switch (layer.kind) {
    case LayerKind::resource:
      return resource_map(*snapshot.environment, layer.name);
    case LayerKind::geology: {
      const Grid<Geology>& geology = *snapshot.environment->geology;
      return made(geology.width(), geology.height(), [&](int x, int y) { return float(geology(x, y)); });
    }
    case LayerKind::plant_density:
      return cover_map(*computed_cover(snapshot, layer.name));
    case LayerKind::animal_density:
      return density_map(*level_of(snapshot, layer.name), snapshot.web->find(layer.name));
    case LayerKind::loss:
    case LayerKind::passage: {
      const auto& height = snapshot.document.terrain->height;
      return std::make_shared<const Grid<float>>(height.width(), height.height(), 0.0F);
    }
    case LayerKind::ground:
      return {snapshot.document.terrain, &snapshot.document.terrain->height};
  }
  return nullptr;
}

std::shared_ptr<const Grid<float>> filter_map(const MapsSnapshot& snapshot, FilterQuantity quantity) {
  if (!holds_filter(snapshot, quantity)) return nullptr;
  switch (quantity) {
    case FilterQuantity::slope: {
      const Grid<float>& slope = snapshot.derivatives->slope;
      return made(slope.width(), slope.height(), [&](int x, int y) { return std::atan(slope(x, y)) * degrees; });
    }
    case FilterQuantity::altitude:
      return {snapshot.land, &snapshot.land->height};
    case FilterQuantity::aspect:
      return aspect_map(*snapshot.derivatives);
    case FilterQuantity::water_distance:
      return water_distance_map(*snapshot.hydrology, snapshot.terrain().cell_size);
    case FilterQuantity::map:
      break;
  }
  return nullptr;
}

EditGrounds edit_grounds(std::shared_ptr<const MapsSnapshot> snapshot) {
  EditGrounds grounds = grounds_without_filters(snapshot);
  for (const FilterQuantity quantity :
       {FilterQuantity::slope, FilterQuantity::altitude, FilterQuantity::aspect, FilterQuantity::water_distance}) {
    add_filter_map(grounds.filters, *snapshot, quantity);
  }
  return grounds;
}

EditGrounds edit_grounds(std::shared_ptr<const MapsSnapshot> snapshot, std::span<const FilterCondition> conditions) {
  EditGrounds grounds = grounds_without_filters(snapshot);
  for (const FilterCondition& condition : conditions) add_filter_map(grounds.filters, *snapshot, condition.quantity);
  return grounds;
}

EditGrounds edit_grounds(std::shared_ptr<const MapsSnapshot> snapshot, const EditNeeds& needs) {
  EditGrounds grounds = edit_grounds(snapshot, needs.conditions);
  grounds.computed = [known = std::move(grounds.computed), layers = needs.computed,
                      terrain = snapshot->document.terrain](const LayerId& layer) {
    if (std::find(layers.begin(), layers.end(), layer) != layers.end()) return known(layer);
    return std::make_shared<const Grid<float>>(terrain->height.width(), terrain->height.height(), 0.0F);
  };
  return grounds;
}

EditNeeds needs_of(const Edit& edit) {
  EditNeeds needs;
  const auto take_conditions = [&](std::span<const FilterCondition> conditions) {
    for (const FilterCondition& condition : conditions) {
      needs.conditions.push_back(condition);
      if (condition.quantity == FilterQuantity::map) needs.computed.push_back(condition.map);
    }
  };
  const auto take_brush = [&](const auto& painting) {
    // What these two make of a cell does not depend on what is computed there.
    const BrushMode mode = painting.brush.mode;
    if (mode != BrushMode::set && mode != BrushMode::restore_computed) {
      for (const EditTarget& target : painting.targets) needs.computed.push_back(target.layer);
    }
    if (painting.clone_from && mode == BrushMode::clone) needs.computed.push_back(*painting.clone_from);
    take_conditions(painting.brush.filter.conditions);
  };
  if (const auto* stroke = std::get_if<StrokeEdit>(&edit)) take_brush(*stroke);
  if (const auto* fill = std::get_if<FillEdit>(&edit)) take_brush(*fill);
  if (const auto* select = std::get_if<SelectEdit>(&edit); select && select->shape == SelectEdit::Shape::range) {
    take_conditions({&select->range, 1});
  }
  if (const auto* image = std::get_if<ImageEdit>(&edit)) take_conditions(image->filter.conditions);
  if (const auto* mix = std::get_if<MixEdit>(&edit); mix && mix->mix == LayerMix::maximum) needs.computed = {mix->into};
  return needs;
}

bool holds(const MapsSnapshot& snapshot, const EditNeeds& needs) {
  const auto known = [&](const LayerId& layer) {
    return unknown_layer(snapshot, layer) || computed_map_source(snapshot, layer) != nullptr;
  };
  return std::all_of(needs.computed.begin(), needs.computed.end(), known) &&
         std::all_of(needs.conditions.begin(), needs.conditions.end(),
                     [&](const FilterCondition& condition) { return holds_filter(snapshot, condition.quantity); });
}

}  // namespace biotope
