#include <algorithm>

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
  if (auto made = state.preparing.take(); made && *made) state.painting.prepare(std::move(**made));
  if (state.tool == Tool::select || !state.shown || state.preparing.running() || state.painting.stroking()) return;
  const std::optional<LayerId> target = paint_target(state);
  if (!target || !computed_source(*state.shown, *target) || state.painting.prepared(*state.shown, *target)) return;
  state.preparing.start("Preparing", [snapshot = state.shown, layer = *target](const TaskContext&) -> Result<PaintGround> {
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
  const Rect changed = state.painting.move_to(state.document, brush_of_tool(state), x, y);
  if (!changed.empty()) state.must_post = true;
}

void end_stroke(EditorState& state) {
  if (!state.painting.stroking()) return;
  std::unique_ptr<Command> command = state.painting.finish(state.document);
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
