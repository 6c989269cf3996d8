#include "ui/brush_presets.hpp"

#include <algorithm>

#include "core/exchange/atomic_file.hpp"
#include "ui/brush_stamps.hpp"
#include "ui/editor_actions.hpp"
#include "ui/paint_targets.hpp"

namespace biotope {
namespace {

constexpr std::size_t most_bytes = std::size_t(4) << 20;

BrushPreset preset(const char* name, Tool tool, float size, float strength, float hardness) {
  BrushPreset made;
  made.name = name;
  made.tool = tool;
  made.size = size;
  made.brush.strength = strength;
  made.brush.hardness = hardness;
  return made;
}

std::vector<BrushPreset> make_built_in() {
  std::vector<BrushPreset> list;
  list.push_back(preset("Soft grow", Tool::add, 120, 0.25F, 0));
  list.push_back(preset("Hard edge", Tool::add, 80, 1, 1));
  list.push_back(preset("Clearing", Tool::erase, 60, 0.8F, 0.6F));
  list.push_back(preset("Loose patches", Tool::add, 120, 0.5F, 0.3F));
  list.back().stamp = "Patches";
  list.back().brush.stamp_turns_by_chance = true;
  list.back().brush.spacing = 0.6F;
  list.push_back(preset("River bank moisture", Tool::add, 150, 0.5F, 0.3F));
  list.back().target = LayerId{LayerKind::resource, "moisture"};
  list.back().value = 8.5F;
  list.back().brush.filter.conditions = {{FilterQuantity::water_distance, {}, 0, 30, 40, false}};
  list.push_back(preset("Meadow on flat ground", Tool::add, 150, 0.6F, 0.3F));
  list.back().brush.filter.conditions = {{FilterQuantity::slope, {}, 0, 12, 6, false}};
  list.push_back(preset("Fire", Tool::set, 120, 0.9F, 0.4F));
  list.back().target = LayerId{LayerKind::loss, ""};
  list.back().value = 0.9F;
  list.back().all_plants = true;
  list.back().stamp = "Patches";
  list.back().brush.stamp_turns_by_chance = true;
  list.push_back(preset("Disease", Tool::add, 150, 0.2F, 0));
  list.back().target = LayerId{LayerKind::loss, ""};
  list.back().value = 0.6F;
  list.push_back(preset("Wall", Tool::set, 12, 1, 1));
  list.back().target = LayerId{LayerKind::passage, "all"};
  list.back().value = 1;
  list.push_back(preset("Gate", Tool::set, 20, 1, 1));
  list.back().target = LayerId{LayerKind::passage, "all"};
  list.back().value = -1;
  return list;
}

/// The person's file lies beside the settings.
std::filesystem::path presets_file(const EditorState& state) { return state.settings_file.parent_path() / "brushes.json"; }

void save_own(EditorState& state) {
  if (state.settings_file.empty()) return;
  if (const Status saved = save_presets(presets_file(state), *state.presets); !saved) complain(state, "Brushes", saved.error());
}

void select_all_plants(EditorState& state) {
  const FoodWeb* web = state.web();
  if (web == nullptr || web->levels.empty() || web->levels[0].empty()) return;
  const std::vector<int>& plants = web->levels[0];
  if (std::find(plants.begin(), plants.end(), state.selected_species) == plants.end()) select_species(state, plants.front());
  for (const int plant : plants) {
    if (plant != state.selected_species) state.also_selected.insert(plant);
  }
}

/// The layer a preset is for, once it is known of which species.
std::optional<LayerId> target_of(EditorState& state, const BrushPreset& preset) {
  if (!preset.target || preset.target->kind != LayerKind::loss || !preset.target->name.empty()) return preset.target;
  const FoodWeb* web = state.web();
  if (web == nullptr || state.selected_species < 0 || state.selected_species >= int(web->species.size())) return std::nullopt;
  return LayerId{LayerKind::loss, web->species[std::size_t(state.selected_species)].name};
}

}  // namespace

const std::vector<BrushPreset>& built_in_presets() {
  static const std::vector<BrushPreset> list = make_built_in();
  return list;
}

std::vector<BrushPreset> load_presets(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  const auto text = read_text(file, most_bytes);
  return text ? presets_from_json(*text) : std::vector<BrushPreset>();
}

Status save_presets(const std::filesystem::path& file, const std::vector<BrushPreset>& presets) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  return write_text(file, presets_to_json(presets) + "\n");
}

const std::vector<BrushPreset>& own_presets(EditorState& state) {
  if (!state.presets) {
    state.presets = state.settings_file.empty() ? std::vector<BrushPreset>() : load_presets(presets_file(state));
  }
  return *state.presets;
}

void use_preset(EditorState& state, const BrushPreset& preset) {
  state.tool = preset.tool;
  const double cell = state.document.terrain ? state.document.terrain->cell_size : 1;
  state.brush = preset.brush;
  state.brush.radius = std::clamp(preset.size / float(cell), 1.0F, 1000.0F);
  state.paint.stamp.clear();
  state.paint.preset = preset.name;
  if (!preset.stamp.empty()) {
    if (auto stamp = load_stamp(preset.stamp)) {
      state.brush.stamp = stamp->weights;
      state.paint.stamp = preset.stamp;
    } else {
      announce(state, "The stamp " + stamp_title(preset.stamp) + " is gone: painting with a disk");
    }
  }
  if (preset.all_plants) select_all_plants(state);
  const std::optional<LayerId> target = target_of(state, preset);
  if (target) show_layer(state, *target);
  if (!preset.target) return;
  if (!target) {
    announce(state, "Choose a species in the list first");
  } else if (preset.value) {
    choose_value(state, *target, ValueUse::reach, *preset.value);
  }
}

void keep_preset(EditorState& state, const std::string& name) {
  if (name.empty()) return;
  BrushPreset made;
  made.name = name;
  made.tool = is_brush(state.tool) ? state.tool : Tool::add;
  made.size = state.brush.radius * float(state.document.terrain ? state.document.terrain->cell_size : 1);
  made.brush = state.brush;
  made.brush.stamp = nullptr;
  made.stamp = state.paint.stamp;
  const std::optional<LayerId> target = paint_target(state);
  // Species are chosen in their list; everything else a brush remembers.
  const bool remembers = target && target->kind != LayerKind::plant_density && target->kind != LayerKind::animal_density;
  if (remembers) {
    made.target = target->kind == LayerKind::loss ? LayerId{LayerKind::loss, ""} : *target;
    made.value = chosen_value(state, *target, ValueUse::reach);
  }
  (void)own_presets(state);
  std::erase_if(*state.presets, [&](const BrushPreset& each) { return each.name == name; });
  state.presets->push_back(std::move(made));
  state.paint.preset = name;
  save_own(state);
}

void remove_preset(EditorState& state, const std::string& name) {
  (void)own_presets(state);
  std::vector<BrushPreset>& own = *state.presets;
  const auto found = std::find_if(own.begin(), own.end(), [&](const BrushPreset& each) { return each.name == name; });
  if (found == own.end()) return;
  state.thrown_preset.emplace(std::size_t(found - own.begin()), *found);
  own.erase(found);
  save_own(state);
}

void take_back_preset(EditorState& state) {
  if (!state.thrown_preset) return;
  (void)own_presets(state);
  auto [place, thrown] = std::move(*state.thrown_preset);
  state.thrown_preset.reset();
  // One that was made meanwhile under the same name stays.
  const bool taken = std::any_of(state.presets->begin(), state.presets->end(),
                                 [name = thrown.name](const BrushPreset& each) { return each.name == name; });
  if (taken) return;
  state.presets->insert(state.presets->begin() + std::ptrdiff_t(std::min(place, state.presets->size())), std::move(thrown));
  save_own(state);
}

}  // namespace biotope
