#include "ui/paint_targets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/pipeline/edit_grounds.hpp"
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

bool of_species(LayerKind kind) {
  return kind == LayerKind::plant_density || kind == LayerKind::animal_density || kind == LayerKind::loss;
}

LayerId layer_of(const Species& species, LayerKind kind) {
  if (kind == LayerKind::loss) return {kind, species.name};
  return {species.is_plant() ? LayerKind::plant_density : LayerKind::animal_density, species.name};
}

/// The key of a chosen value: plants share theirs, as do events; animals live at densities of their own.
LayerId value_key(const LayerId& layer) {
  const bool shared = layer.kind == LayerKind::plant_density || layer.kind == LayerKind::loss;
  return shared ? LayerId{layer.kind, ""} : layer;
}

float built_in_value(const EditorState& state, const LayerId& layer, ValueUse use) {
  const LayerLimits limits = limits_of(state, layer);
  switch (use) {
    case ValueUse::amplitude:
      return layer.kind == LayerKind::ground ? 5.0F : 0.25F * (limits.high - limits.low);
    case ValueUse::pass:
      return 5;
    case ValueUse::depth:
      return 2;
    case ValueUse::reach:
      break;
  }
  if (layer.kind == LayerKind::geology) return float(Geology::scree);
  if (layer.kind == LayerKind::ground) return 0.5F * (limits.low + limits.high);
  return limits.high;
}

float weight_of(const EditorState& state, const LayerId& layer) {
  const auto found = state.paint.weights.find(layer.name);
  return found == state.paint.weights.end() ? 1.0F : found->second;
}

bool selects_nothing(const Document& document) {
  if (!document.selection || document.selection->background() != 0) return false;
  for (std::size_t tile = 0; tile < document.selection->tile_count(); ++tile) {
    if (document.selection->tile(tile)) return false;
  }
  return true;
}

/// What a fill does; between classes there is nothing, so that they are set and taken off instead.
BrushMode fill_mode(BrushMode chosen, bool classes) {
  if (classes && chosen == BrushMode::add) return BrushMode::set;
  if (classes && chosen == BrushMode::subtract) return BrushMode::restore_computed;
  return chosen;
}

/// What the tool in the hand does to a layer of a kind.
BrushMode mode_of_tool(const EditorState& state, LayerKind kind) {
  const bool ground = kind == LayerKind::ground;
  const bool classes = kind == LayerKind::geology || kind == LayerKind::passage;
  switch (state.tool) {
    case Tool::erase:
      return ground ? BrushMode::lower : classes ? BrushMode::restore_computed : BrushMode::subtract;
    case Tool::smooth:
      return BrushMode::smooth;
    case Tool::sharpen:
      return BrushMode::sharpen;
    case Tool::noise:
      return BrushMode::noise;
    case Tool::clone:
      return BrushMode::clone;
    case Tool::restore:
      return BrushMode::restore_computed;
    case Tool::set:
    case Tool::flatten:
    case Tool::gradient:
      return BrushMode::set;
    case Tool::lower:
    case Tool::carve:
      return BrushMode::lower;
    case Tool::fill:
      return fill_mode(state.paint.fill_mode, classes);
    default:
      return ground ? BrushMode::raise : classes ? BrushMode::set : BrushMode::add;
  }
}

/// The layer that is looked at on the tabs of species and trails.
std::optional<LayerId> species_target(const EditorState& state, const FoodWeb& web) {
  const MapKind shown = shown_map(state).kind;
  if (shown == MapKind::passage) return LayerId{LayerKind::passage, "all"};
  if (state.selected_species < 0 || state.selected_species >= int(web.species.size())) return std::nullopt;
  const Species& species = web.species[std::size_t(state.selected_species)];
  const bool elsewhere = state.view.tab == (species.is_plant() ? Tab::animals : Tab::plants);
  if (elsewhere) return std::nullopt;
  return layer_of(species, shown == MapKind::loss ? LayerKind::loss : LayerKind::plant_density);
}

}  // namespace

LayerLimits limits_of(const EditorState& state, const LayerId& layer) {
  switch (layer.kind) {
    case LayerKind::resource:
      return {1, 9, ""};
    case LayerKind::plant_density:
    case LayerKind::loss:
      return {0, 1, "%"};
    case LayerKind::animal_density:
      return {0, densest(state, layer), "/km²"};
    case LayerKind::geology:
      return {0, float(geology_classes - 1), ""};
    case LayerKind::passage:
      return {-1, 1, ""};
    case LayerKind::ground:
      return {state.ground.height_range[0] - 100, state.ground.height_range[1] + 100, "m"};
  }
  return {};
}

bool layer_locked(const EditorState& state, const LayerId& layer) { return is_locked(state.document, layer); }

std::optional<LayerId> paint_target(const EditorState& state) {
  const LayerId ground{LayerKind::ground, "height"};
  if (is_ground_tool(state.tool)) return ground;
  const FoodWeb* web = state.web();
  if (web == nullptr) return std::nullopt;
  // One paints what one looks at.
  switch (state.view.tab) {
    case Tab::climate:
      return layer_of_map(shown_map(state), *web);
    case Tab::terrain:
      return layer_of_map(shown_map(state), *web).value_or(ground);
    default:
      return species_target(state, *web);
  }
}

std::vector<LayerId> painted_layers(const EditorState& state) {
  std::vector<LayerId> layers;
  const std::optional<LayerId> target = paint_target(state);
  const FoodWeb* web = state.web();
  if (!target) return layers;
  layers.push_back(*target);
  if (web == nullptr || !of_species(target->kind)) return layers;
  for (const int number : state.also_selected) {
    if (number < 0 || number >= int(web->species.size())) continue;
    const LayerId layer = layer_of(web->species[std::size_t(number)], target->kind);
    if (layer.kind == target->kind && layer != *target && !layer_locked(state, layer)) layers.push_back(layer);
  }
  return layers;
}

std::string paint_hindrance(const EditorState& state) {
  if (!state.has_document) return "Open a landscape first";
  const std::optional<LayerId> target = paint_target(state);
  if (!target && state.view.tab == Tab::climate) return "Choose the map of a resource, the soil or the geology to paint it";
  if (!target) return "Choose a species in the list, or a map in another tab, to paint it";
  if (layer_locked(state, *target)) {
    return "This layer is locked: open its lock in the list of layers, or of species, to paint it";
  }
  const auto layer_state = state.document.layer_states.find(*target);
  if (layer_state != state.document.layer_states.end() && layer_state->second.hidden) {
    return "This layer is hidden: open its eye in the list of layers to paint it";
  }
  const bool classes = target->kind == LayerKind::geology || target->kind == LayerKind::passage;
  const bool mixes =
      state.tool == Tool::smooth || state.tool == Tool::sharpen || state.tool == Tool::noise || state.tool == Tool::gradient;
  if (classes && mixes) return "Classes have nothing between them: paint, erase, fill or clone them";
  if (selects_nothing(state.document)) return "Nothing is selected: deselect to paint everywhere";
  if (!state.shown || !computed_map_source(*state.shown, *target)) return "The map under the paint is still being computed";
  return {};
}

std::optional<ValueUse> value_use(const EditorState& state, const LayerId& layer) {
  const bool ground = layer.kind == LayerKind::ground;
  switch (state.tool) {
    case Tool::add:
    case Tool::erase:
      if (ground) return ValueUse::pass;
      return state.tool == Tool::add ? std::optional(ValueUse::reach) : std::nullopt;
    case Tool::raise:
    case Tool::lower:
      return ValueUse::pass;
    case Tool::carve:
      return ValueUse::depth;
    case Tool::set:
    case Tool::gradient:
      return ValueUse::reach;
    case Tool::fill:
      if (state.paint.fill_mode == BrushMode::noise) return ValueUse::amplitude;
      return state.paint.fill_mode == BrushMode::set || state.paint.fill_mode == BrushMode::add ? std::optional(ValueUse::reach)
                                                                                                : std::nullopt;
    case Tool::noise:
      return ValueUse::amplitude;
    default:
      return std::nullopt;
  }
}

float chosen_value(const EditorState& state, const LayerId& layer, ValueUse use) {
  if (layer.kind == LayerKind::passage && use == ValueUse::reach) return state.paint.opens_passages ? -1.0F : 1.0F;
  const auto found = state.paint.values.find({value_key(layer), use});
  return found == state.paint.values.end() ? built_in_value(state, layer, use) : found->second;
}

void choose_value(EditorState& state, const LayerId& layer, ValueUse use, float value) {
  if (layer.kind == LayerKind::passage) {
    state.paint.opens_passages = value < 0;
  } else {
    state.paint.values[{value_key(layer), use}] = value;
  }
}

std::vector<EditTarget> edit_targets(const EditorState& state, const Brush& brush) {
  const std::vector<LayerId> layers = painted_layers(state);
  float sum = 0;
  float most = 0;
  for (const LayerId& layer : layers) {
    sum += weight_of(state, layer);
    most = std::max(most, weight_of(state, layer));
  }
  std::vector<EditTarget> targets;
  for (const LayerId& layer : layers) {
    EditTarget target{layer, 1, std::nullopt, std::nullopt};
    if (layers.size() > 1 && sum > 0) {
      const float weight = weight_of(state, layer);
      const bool to_value = brush.mode == BrushMode::add || brush.mode == BrushMode::set;
      // Of densities the values are shares of the ground; an event takes from each what it takes.
      const float share = layer.kind == LayerKind::loss ? weight : weight / sum;
      if (to_value) target.value = chosen_value(state, layer, ValueUse::reach) * share;
      if (!to_value) target.weight = weight / most;
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

float metres_a_dab(const Brush& brush, float metres) {
  // Dabs lie `spacing` radii apart: their weights over a cell add up to the integral of the falloff divided by the spacing.
  const float soft = 1 - std::clamp(brush.hardness, 0.0F, 0.99F);
  float fall = 0.5F;  // integral of the falloff's soft part over a unit length: smooth and linear
  if (brush.falloff == Falloff::sphere) fall = std::numbers::pi_v<float> / 4;
  if (brush.falloff == Falloff::sharp) fall = 1.0F / 3;
  const float integral = 2 * (1 - soft + soft * fall);
  return metres * std::max(brush.spacing, 0.01F) / integral;
}

Brush brush_of_tool(const EditorState& state) {
  Brush brush = state.brush;
  const LayerId target = paint_target(state).value_or(LayerId{});
  const LayerLimits limits = limits_of(state, target);
  const std::optional<ValueUse> use = value_use(state, target);
  brush.mode = mode_of_tool(state, target.kind);
  brush.floor = limits.low;
  brush.value = use ? chosen_value(state, target, *use) : limits.high;
  brush.noise_seed = state.paint.strokes + 1;
  brush.clone_offset = state.paint.clone_offset;
  if (state.tool == Tool::fill || state.tool == Tool::gradient) brush.strength = state.paint.fill_strength;
  // A trench is as deep as it was asked to be, with its steepest sides in the middle of them.
  if (state.tool == Tool::carve) {
    brush.falloff = Falloff::smooth;
    brush.hardness = 0.25F;
  }
  if (brush.mode == BrushMode::raise || brush.mode == BrushMode::lower) {
    brush.strength = 1;  // the metres of a pass say it all
    brush.value = metres_a_dab(brush, brush.value);
  }
  return brush;
}

void show_layer(EditorState& state, const LayerId& layer) {
  const FoodWeb* web = state.web();
  if (web == nullptr) return;
  const MapId map = map_of_layer(layer, *web);
  const bool offered_here = (layer.kind == LayerKind::passage && state.view.tab != Tab::climate &&
                             state.view.tab != Tab::plants && state.view.tab != Tab::project) ||
                            (layer.kind == LayerKind::geology && state.view.tab == Tab::terrain);
  if (!offered_here) state.view.tab = tab_of_layer(layer, *web);
  state.view.shown[std::size_t(state.view.tab)] = map;
  state.view.by_month = false;
}

}  // namespace biotope
