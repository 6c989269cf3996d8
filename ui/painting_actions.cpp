#include <algorithm>
#include <utility>

#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

/// The densest a brush paints an animal: a few times what lives there at most, at least one animal per km2.
float densest(const EditorState& state, const LayerId& layer) {
  const FoodWeb* web = state.web();
  if (web == nullptr || !state.shown) return 1;
  const AnimalPlace place = find_animal(*state.shown, web->find(layer.name));
  if (place.level == nullptr) return 1;
  const ConfinementRegions& regions = *place.level->regions[std::size_t(place.index)];
  const std::vector<double>& population = place.level->computed_population[std::size_t(place.index)];
  double most = 0;
  for (std::size_t region = 0; region < std::min(regions.regions.size(), population.size()); ++region) {
    if (regions.regions[region].area > 0) most = std::max(most, population[region] / (regions.regions[region].area / 1e6));
  }
  return float(std::max(3 * most, 1.0));
}

bool locked(const EditorState& state, const LayerId& layer) {
  return layer.kind != LayerKind::resource && state.locked_species.contains(layer.name);
}

LayerId layer_of(const Species& species) {
  return {species.is_plant() ? LayerKind::plant_density : LayerKind::animal_density, species.name};
}

/// Layers the brush paints beside the target: the other selected species of its kind that are not locked.
std::vector<LayerId> companion_layers(const EditorState& state, const LayerId& target) {
  std::vector<LayerId> layers;
  const FoodWeb* web = state.web();
  if (web == nullptr || target.kind == LayerKind::resource) return layers;
  for (const int number : state.also_selected) {
    if (number < 0 || number >= int(web->species.size())) continue;
    const LayerId layer = layer_of(web->species[std::size_t(number)]);
    if (layer.kind == target.kind && layer != target && !locked(state, layer)) layers.push_back(layer);
  }
  return layers;
}

bool has_ground(const EditorState& state, const LayerId& layer) {
  const auto ground = state.companion_grounds.find(layer);
  return ground != state.companion_grounds.end() && ground->second.computed &&
         ground->second.source == computed_source(*state.shown, layer);
}

/// The next layer the brush will need whose map is not ready.
std::optional<LayerId> unprepared(const EditorState& state, const LayerId& target) {
  if (computed_source(*state.shown, target) && !state.painting.prepared(*state.shown, target)) return target;
  for (const LayerId& layer : companion_layers(state, target)) {
    if (computed_source(*state.shown, layer) && !has_ground(state, layer)) return layer;
  }
  return std::nullopt;
}

}  // namespace

std::optional<LayerId> paint_target(const EditorState& state) {
  const FoodWeb* web = state.web();
  // One paints what one looks at: resources in the climate's tab, the selected species elsewhere.
  if (web != nullptr && state.view.tab == Tab::climate) return layer_of_map(shown_map(state), *web);
  if (web == nullptr || state.selected_species < 0 || state.selected_species >= int(web->species.size())) return std::nullopt;
  const Species& species = web->species[std::size_t(state.selected_species)];
  return LayerId{species.is_plant() ? LayerKind::plant_density : LayerKind::animal_density, species.name};
}

std::string paint_hindrance(const EditorState& state) {
  if (!state.has_document) return "Open a landscape first";
  const std::optional<LayerId> target = paint_target(state);
  if (!target && state.view.tab == Tab::climate) return "Choose the map of illumination, temperature or moisture to paint it";
  if (!target) return "Choose a species in the list, or a resource map in the Climate tab, to paint it";
  if (locked(state, *target)) return "This species is locked: open its lock in the list to paint it";
  if (!state.shown || !state.shown->web || source_of(*state.shown, map_of_layer(*target, *state.shown->web)) == nullptr) {
    return "The map under the paint is still being computed";
  }
  return {};
}

Brush brush_of_tool(const EditorState& state) {
  Brush brush = state.brush;
  const std::optional<LayerId> target = paint_target(state);
  const LayerKind kind = target ? target->kind : LayerKind::plant_density;
  brush.floor = kind == LayerKind::resource ? 1.0F : 0.0F;
  brush.value = kind == LayerKind::resource ? 9.0F : 1.0F;
  if (kind == LayerKind::animal_density) brush.value = densest(state, *target);
  // Species painted together share the ground in equal parts.
  if (target) brush.value /= float(1 + companion_layers(state, *target).size());
  switch (state.tool) {
    case Tool::erase:
      brush.mode = BrushMode::subtract;
      break;
    case Tool::smooth:
      brush.mode = BrushMode::smooth;
      break;
    case Tool::restore:
      brush.mode = BrushMode::restore_computed;
      break;
    default:
      brush.mode = BrushMode::add;
      break;
  }
  return brush;
}

void prepare_painting(EditorState& state) {
  if (auto made = state.preparing.take(); made && *made) {
    const std::optional<LayerId> target = paint_target(state);
    if (target && *target != (*made)->layer) {
      state.companion_grounds[(*made)->layer] = std::move(**made);
    } else {
      state.painting.prepare(std::move(**made));
    }
  }
  if (state.tool == Tool::select || !state.shown || state.preparing.running() || state.painting.stroking()) return;
  if (state.also_selected.empty()) state.companion_grounds.clear();
  const std::optional<LayerId> target = paint_target(state);
  const std::optional<LayerId> wanted = target ? unprepared(state, *target) : std::nullopt;
  if (!wanted) return;
  state.preparing.start("Preparing", [snapshot = state.shown, layer = *wanted](const TaskContext&) -> Result<PaintGround> {
    return PaintGround{layer, computed_source(*snapshot, layer), computed_under(*snapshot, layer)};
  });
}

void begin_stroke(EditorState& state, float x, float y) {
  const std::string hindrance = paint_hindrance(state);
  if (!hindrance.empty()) {
    announce(state, hindrance);
    return;
  }
  const LayerId target = *paint_target(state);
  if (!state.painting.begin(*state.shown, state.document, target)) return;
  state.companions.close();
  for (const LayerId& layer : companion_layers(state, target)) {
    if (!has_ground(state, layer)) {
      state.companion_grounds[layer] = {layer, computed_source(*state.shown, layer), computed_under(*state.shown, layer)};
    }
    if (state.companion_grounds[layer].computed) state.companions.begin(state.companion_grounds[layer]);
  }
  // One sees what one paints.
  const MapId map = map_of_layer(target, *state.shown->web);
  if (target.kind == LayerKind::resource) {
    state.view.tab = Tab::climate;
  } else {
    state.view.tab = target.kind == LayerKind::plant_density ? Tab::plants : Tab::animals;
  }
  state.view.shown[std::size_t(state.view.tab)] = map;
  state.view.by_month = false;
  continue_stroke(state, x, y);
}

void continue_stroke(EditorState& state, float x, float y) {
  if (!state.painting.stroking()) return;
  const Brush brush = brush_of_tool(state);
  const Rect changed = state.painting.move_to(state.document, brush, x, y);
  const bool others = state.companions.move_to(state.document, brush, x, y);
  if (!changed.empty() || others) state.must_post = true;
}

void end_stroke(EditorState& state) {
  if (!state.painting.stroking()) return;
  std::unique_ptr<Command> command = state.painting.finish(state.document);
  std::vector<std::unique_ptr<Command>> others = state.companions.finish(state.document);
  if (!others.empty()) {
    const std::string name = "Paint " + std::to_string(others.size() + (command ? 1 : 0)) + " species";
    if (command) others.insert(others.begin(), std::move(command));
    command = std::make_unique<GroupCommand>(name, std::move(others));
  }
  if (!command) return;
  state.history.record(std::move(command));
  ++state.edits;
  state.must_post = true;
}

void clear_paint(EditorState& state, const LayerId& layer) {
  state.painting.close();
  change_document(state, "Take the paint off " + layer.name, [&](Document& document) { document.layers.erase(layer); });
}

}  // namespace biotope
