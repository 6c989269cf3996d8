#include <algorithm>
#include <cmath>
#include <utility>

#include "core/ecosystem/explanation.hpp"
#include "ui/editor_actions.hpp"

namespace biotope {

void select_species(EditorState& state, int species) {
  state.selected_species = species;
  state.also_selected.clear();
  const FoodWeb* web = state.web();
  if (web == nullptr || species < 0 || species >= int(web->species.size())) return;
  const bool plant = web->species[std::size_t(species)].is_plant();
  const Tab tab = plant ? Tab::plants : Tab::animals;
  MapId& map = state.view.shown[std::size_t(tab)];
  // The kind of map that was looked at is kept, so that fitness can be compared from species to species.
  const bool keeps_kind = map.kind != MapKind::none && map.kind != MapKind::group_cover && map.kind != MapKind::passage;
  map = {keeps_kind ? map.kind : plant ? MapKind::plant_cover : MapKind::animal_density, species};
}

void select_for_tab(EditorState& state) {
  const FoodWeb* web = state.web();
  const bool plants = state.view.tab == Tab::plants;
  if (web == nullptr || (!plants && state.view.tab != Tab::animals)) return;
  const auto of_kind = [&](int number, bool plant) {
    return number >= 0 && number < int(web->species.size()) && web->species[std::size_t(number)].is_plant() == plant;
  };
  const std::size_t kind = plants ? 0 : 1;
  if (of_kind(state.selected_species, plants)) {
    state.last_selected[kind] = state.selected_species;
    return;
  }
  if (of_kind(state.selected_species, !plants)) state.last_selected[1 - kind] = state.selected_species;
  if (!of_kind(state.last_selected[kind], plants)) {
    const auto level = std::find_if(web->levels.begin() + (plants || web->levels.empty() ? 0 : 1), web->levels.end(),
                                    [](const std::vector<int>& species) { return !species.empty(); });
    if (level == web->levels.end() || !of_kind(level->front(), plants)) return;
    state.last_selected[kind] = level->front();
  }
  state.also_selected.clear();
  state.selected_species = state.last_selected[kind];
}

void toggle_species(EditorState& state, int species) {
  const FoodWeb* web = state.web();
  if (web == nullptr || species < 0 || species >= int(web->species.size())) return;
  const int selected = state.selected_species;
  const bool alone = selected < 0 || selected >= int(web->species.size()) ||
                     web->species[std::size_t(selected)].is_plant() != web->species[std::size_t(species)].is_plant();
  if (alone) {
    select_species(state, species);
  } else if (species == selected) {
    if (state.also_selected.empty()) return;
    // Another of the group takes its place.
    std::set<int> others = state.also_selected;
    const int next = *others.begin();
    others.erase(next);
    select_species(state, next);
    state.also_selected = std::move(others);
  } else if (state.also_selected.erase(species) == 0) {
    state.also_selected.insert(species);
  }
}

const MapId& shown_map(const EditorState& state) { return state.view.shown[std::size_t(state.view.tab)]; }

MapId visible_map(const EditorState& state) {
  MapId map = shown_map(state);
  const bool monthly = map.kind == MapKind::illumination || map.kind == MapKind::temperature || map.kind == MapKind::moisture;
  map.month = monthly && state.view.by_month ? state.clock.month : -1;
  return map;
}

void show_map(EditorState& state, const MapId& map) {
  state.view.shown[std::size_t(state.view.tab)] = map;
  const FoodWeb* web = state.web();
  if (web == nullptr) return;
  const std::optional<LayerId> layer = layer_of_map(map, *web);
  const bool of_species = layer && (layer->kind == LayerKind::plant_density || layer->kind == LayerKind::animal_density ||
                                    layer->kind == LayerKind::loss);
  if (!of_species) return;
  if (state.selected_species != map.item) state.also_selected.clear();
  state.selected_species = map.item;
}

void ask_why(EditorState& state, int x, int y) {
  if (!state.shown || !state.shown->document.terrain || !state.shown->terrain().height.contains(x, y)) return;
  CellQuestion question{x, y, state.selected_species, std::nullopt, state.shown->revision};
  const MapsSnapshot& snapshot = *state.shown;
  const FoodWeb* web = snapshot.web.get();
  if (web != nullptr && question.species >= 0 && question.species < int(web->species.size())) {
    const bool plant = web->species[std::size_t(question.species)].is_plant();
    if (plant && snapshot.environment && !snapshot.cover.empty()) {
      question.answer = explain_plant(*web, snapshot.plant_environment(), question.species, snapshot.cover, x, y,
                                      snapshot.loss(question.species).get());
    } else if (!plant) {
      const AnimalPlace place = find_animal(snapshot, question.species);
      if (place.level != nullptr) question.answer = explain_animal(*web, *place.level, question.species, snapshot.ground(), x, y);
    }
  }
  state.question = std::move(question);
}

void follow_pointer(EditorState& state, double now) {
  constexpr double asking_seconds = 0.08;
  if (!state.question || !state.view.why_follows || !state.pointer.over_map || now < state.ask_again_at) return;
  const int x = int(std::lround(state.pointer.x));
  const int y = int(std::lround(state.pointer.y));
  if (x == state.question->x && y == state.question->y) return;
  state.ask_again_at = now + asking_seconds;
  ask_why(state, x, y);
}

}  // namespace biotope
