#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/document/edit_commands.hpp"

namespace biotope {
namespace {

/// Points farther away than this are mistakes, cells (our choice; no map is a tenth as wide).
constexpr float farthest_point = 1e6F;

constexpr std::array<const char*, 4> resource_names{"illumination", "temperature", "moisture", "texture"};

bool known_species(const Document& document, const LayerId& layer) {
  if (!document.species) return false;
  return std::any_of(document.species->begin(), document.species->end(), [&](const Species& species) {
    if (species.name != layer.name) return false;
    return layer.kind == LayerKind::loss || species.is_plant() == (layer.kind == LayerKind::plant_density);
  });
}

bool known_layer(const Document& document, const LayerId& layer) {
  switch (layer.kind) {
    case LayerKind::resource:
      return std::find(resource_names.begin(), resource_names.end(), layer.name) != resource_names.end();
    case LayerKind::plant_density:
    case LayerKind::animal_density:
    case LayerKind::loss:
      return known_species(document, layer);
    case LayerKind::geology:
      return layer.name == "class";
    case LayerKind::passage:
      return layer.name == "all";
    case LayerKind::ground:
      return layer.name == "height";
  }
  return false;
}

std::string size_words(Rect rect) { return std::to_string(rect.width()) + " x " + std::to_string(rect.height()); }

std::string quantity_words(const FilterCondition& condition) {
  switch (condition.quantity) {
    case FilterQuantity::slope:
      return "slope";
    case FilterQuantity::altitude:
      return "altitude";
    case FilterQuantity::aspect:
      return "aspect";
    case FilterQuantity::water_distance:
      return "distance to water";
    case FilterQuantity::map:
      break;
  }
  return "map of " + layer_words(condition.map);
}

Status check_condition(const FilterCondition& condition) {
  if (std::isfinite(condition.low) && std::isfinite(condition.high) && std::isfinite(condition.softness)) return {};
  return fail("A limit of the filter's " + quantity_words(condition) + " is not a number. Enter numbers as its limits.");
}

}  // namespace

Status check_layer(const Document& document, const LayerId& layer) {
  if (!document.terrain) return fail("There is no terrain to edit. Open a landscape first.");
  if (!known_layer(document, layer)) {
    return fail("There is no map of '" + layer.name +
                "' to edit here. Check the name, and that the species is in this landscape.");
  }
  const auto paint = document.layers.find(layer);
  if (paint == document.layers.end() || !paint->second) return {};
  return check_size(document, paint->second->rect(), "The paint on " + layer_words(layer));
}

Status check_editable(const Document& document, const LayerId& layer) {
  if (const Status known = check_layer(document, layer); !known) return known;
  if (is_locked(document, layer)) return fail("The layer " + layer_words(layer) + " is locked. Unlock it to edit it.");
  return {};
}

Status check_brush(const Brush& brush) {
  const std::array<float, 10> numbers{brush.radius,         brush.strength,      brush.hardness,   brush.value,
                                      brush.floor,          brush.spacing,       brush.noise_size, brush.stamp_turn,
                                      brush.clone_offset.x, brush.clone_offset.y};
  if (!std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); })) {
    return fail("A setting of the brush is not a number. Choose the brush's settings again.");
  }
  if (!(brush.radius > 0) || brush.radius > farthest_point) {
    return fail("The brush's radius must be more than 0 and at most 1,000,000 cells.");
  }
  if (brush.stamp && brush.stamp->empty()) return fail("The brush's stamp is an image without pixels. Choose another image.");
  return {};
}

Status check_point(PathPoint point) {
  if (std::abs(point.x) <= farthest_point && std::abs(point.y) <= farthest_point) return {};
  return fail("A point of the edit lies more than 1,000,000 cells from the map, or is not a number.");
}

Status check_size(const Document& document, Rect rect, const std::string& what) {
  const Rect map = document.terrain->height.rect();
  if (rect == map) return {};
  return fail(what + " has " + size_words(rect) + " cells, but the terrain has " + size_words(map) + ". Resample it first.");
}

Result<std::shared_ptr<const Grid<float>>> computed_under(const Document& document, const LayerId& layer,
                                                          const EditGrounds& grounds) {
  auto computed = grounds.computed ? grounds.computed(layer) : nullptr;
  const Grid<float>& height = document.terrain->height;
  if (!computed && (layer.kind == LayerKind::loss || layer.kind == LayerKind::passage)) {
    computed = std::make_shared<const Grid<float>>(height.width(), height.height(), 0.0F);
  }
  if (!computed && layer.kind == LayerKind::ground) computed = std::shared_ptr<const Grid<float>>(document.terrain, &height);
  if (!computed)
    return fail("The map of " + layer_words(layer) + " is not computed yet. Wait until it is shown, then try again.");
  if (const Status size = check_size(document, computed->rect(), "The map of " + layer_words(layer)); !size) {
    return tl::unexpected(size.error());
  }
  return computed;
}

std::shared_ptr<const Grid<float>> final_map(const Document& document, const LayerId& layer,
                                             std::shared_ptr<const Grid<float>> computed) {
  const auto paint = active_paint(document, layer);
  if (!paint || !computed) return computed;
  auto map = std::make_shared<Grid<float>>(computed->width(), computed->height());
  parallel_rows(0, computed->height(), [&](int y) {
    std::vector<Paint> row(static_cast<std::size_t>(computed->width()));
    paint->read_row(y, 0, row);
    for (std::size_t x = 0; x < row.size(); ++x) map->row(y)[x] = painted(computed->row(y)[x], row[x]);
  });
  return map;
}

Result<FilterMaps> maps_for(const Document& document, const std::vector<FilterCondition>& conditions,
                            const EditGrounds& grounds) {
  FilterMaps maps = grounds.filters;
  for (const FilterCondition& condition : conditions) {
    if (const Status numbers = check_condition(condition); !numbers) return tl::unexpected(numbers.error());
    if (condition.quantity == FilterQuantity::map) {
      if (const Status known = check_layer(document, condition.map); !known) return tl::unexpected(known.error());
      auto computed = computed_under(document, condition.map, grounds);
      if (!computed) return tl::unexpected(computed.error());
      maps.values[condition.map] = final_map(document, condition.map, std::move(*computed));
    }
    const Grid<float>* map = filter_map(condition, maps);
    if (map == nullptr)
      return fail("The filter's " + quantity_words(condition) + " is not computed yet. Wait until it is, then try again.");
    const Status size = check_size(document, map->rect(), "The filter's " + quantity_words(condition));
    if (!size) return tl::unexpected(size.error());
  }
  return maps;
}

}  // namespace biotope
