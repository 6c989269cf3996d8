#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/panels/panels.hpp"
#include "ui/show_places.hpp"

namespace biotope {
namespace {

bool visible(const EditorState& state, int species) {
  const auto index = std::size_t(species);
  return index >= state.view.visible_species.size() || state.view.visible_species[index];
}

void set_visible(EditorState& state, const FoodWeb& web, int species, bool shown) {
  state.view.visible_species.resize(web.species.size(), true);
  state.view.visible_species[std::size_t(species)] = shown;
}

bool painted_on(const EditorState& state, const Species& species) {
  const LayerId layer{species.is_plant() ? LayerKind::plant_density : LayerKind::animal_density, species.name};
  const auto found = state.document.layers.find(layer);
  if (found == state.document.layers.end()) return false;
  // A layer whose paint was taken back keeps no tile.
  for (std::size_t tile = 0; tile < found->second->tile_count(); ++tile) {
    if (found->second->tile(tile)) return true;
  }
  return false;
}

/// Achieved share as a bar; the desired one as a mark on it.
void draw_shares(const Theme& theme, ImVec2 at, ImVec2 size, const SpeciesFigures& figures, float most) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, ImVec2(at.x + size.x, at.y + size.y), colour_u32(with_alpha(theme.text, 0.08F)), theme.px(2));
  const auto along = [&](double share) { return size.x * float(std::clamp(share / double(most), 0.0, 1.0)); };
  if (std::isfinite(figures.achieved) && figures.achieved > 0) {
    const bool missed = std::isfinite(figures.desired) && figures.achieved < 0.5 * figures.desired;
    list.AddRectFilled(at, ImVec2(at.x + std::max(along(figures.achieved), 1.0F), at.y + size.y),
                       colour_u32(missed ? theme.attention : theme.accent), theme.px(2));
  }
  if (std::isfinite(figures.desired)) {
    const float x = at.x + along(figures.desired);
    list.AddRectFilled(ImVec2(x - theme.px(1), at.y - theme.px(2)), ImVec2(x + theme.px(1), at.y + size.y + theme.px(2)),
                       colour_u32(theme.text));
  }
}

std::string amount_text(const Species& species, const SpeciesFigures* figures) {
  if (figures == nullptr || !std::isfinite(figures->amount)) return "...";
  if (species.is_plant()) return format_percent(figures->amount);
  return format_count(std::round(figures->amount));
}

void row_tooltip(const UiContext& ui, const Species& species, const SpeciesFigures* figures) {
  std::string text = display_name(species) + " (" + species.scientific_name + ")";
  text += "\nCtrl+click: paint it together with the selected ones. Double-click: see it in 3D";
  if (figures != nullptr && std::isfinite(figures->amount)) {
    const bool plant = species.is_plant();
    const std::string unit = plant ? "kg/yr" : "animals/yr";
    text += plant ? "\nMean cover " + format_percent(figures->amount)
                  : "\n" + format_count(figures->amount) + " animals in " + std::to_string(figures->herds) +
                        (figures->herds == 1 ? " herd, " : " herds, ") + std::to_string(figures->regions) +
                        (figures->regions == 1 ? " region" : " regions");
    text += "\nShare of its level " + format_percent(figures->achieved);
    if (std::isfinite(figures->desired)) text += ", desired " + format_percent(figures->desired);
    if (std::isfinite(figures->growth)) {
      text += "\nGrows " + format_value(figures->growth, unit) + ", eaten " + format_value(figures->eaten, unit);
      text += "\nSurplus " + format_value(figures->surplus(), unit);
    }
  }
  tooltip(ui.theme, text);
}

/// A lock under the eye: while it is closed no brush changes the species.
void draw_lock(const UiContext& ui, const Species& species, ImVec2 at, bool is_locked) {
  const Theme& theme = ui.theme;
  ImGui::SetCursorScreenPos(at);
  const char* icon = theme.has_icons ? (is_locked ? icons::lock : icons::unlock) : (is_locked ? "x" : ".");
  const ImVec4 colour = is_locked ? theme.attention : with_alpha(theme.muted, 0.35F);
  if (!icon_button(theme, "lock", icon, colour,
                   is_locked ? "Locked: no brush changes it. Click to unlock" : "Lock against paint"))
    return;
  std::set<std::string>& locks = ui.state.locked_species;
  if (locks.erase(species.name) == 0) locks.insert(species.name);
}

/// What stands under the name: numbers of an animal, the family of a plant.
std::string second_line(const Species& species, const SpeciesFigures* figures) {
  if (species.is_plant() || figures == nullptr || !std::isfinite(figures->amount)) return species.scientific_name;
  std::string text = std::to_string(figures->herds) + (figures->herds == 1 ? " herd" : " herds");
  if (!std::isfinite(figures->achieved)) return text;
  text += "   " + format_percent(figures->achieved);
  if (std::isfinite(figures->desired)) text += " of " + format_percent(figures->desired);
  return text;
}

void draw_row(const UiContext& ui, const FoodWeb& web, int number, float most_share) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const Species& species = web.species[std::size_t(number)];
  const SpeciesFigures* figures = std::size_t(number) < state.figures.size() ? &state.figures[std::size_t(number)] : nullptr;
  const bool selected = state.selected_species == number || state.also_selected.contains(number);
  const bool is_locked = state.locked_species.contains(species.name);
  const bool shown = visible(state, number);
  const float height = theme.px(42);
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(number);
  if (ImGui::Selectable("##row", selected, ImGuiSelectableFlags_AllowItemOverlap, ImVec2(width, height))) {
    if (ImGui::GetIO().KeyCtrl) {
      toggle_species(state, number);
    } else {
      select_species(state, number);
    }
  }
  if (row_double_clicked()) show_species(state, number);
  row_tooltip(ui, species, figures);
  ImGui::SetItemAllowOverlap();
  ImGui::SetCursorScreenPos(ImVec2(at.x + theme.px(2), at.y + theme.px(3)));
  const char* eye = theme.has_icons ? (shown ? icons::eye : icons::eye_closed) : (shown ? "o" : "-");
  if (icon_button(theme, "eye", eye, shown ? theme.muted : with_alpha(theme.muted, 0.5F),
                  shown ? "Hide on the map and in 3D" : "Show again")) {
    set_visible(state, web, number, !shown);
  }
  draw_lock(ui, species, ImVec2(at.x + theme.px(3), at.y + theme.px(23)), is_locked);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float chip = theme.px(28);
  list.AddRectFilled(ImVec2(at.x + chip, at.y + theme.px(6)), ImVec2(at.x + chip + theme.px(6), at.y + height - theme.px(6)),
                     colour_u32(to_imgui(species.colour)), theme.px(3));
  const float left = at.x + theme.px(42);
  const std::string amount = amount_text(species, figures);
  const float amount_width = ImGui::CalcTextSize(amount.c_str()).x;
  const float right = at.x + width - theme.px(6);
  const float icon_room = selected || painted_on(state, species) ? theme.px(22) : 0;
  const std::string name = fitted_text(display_name(species), right - amount_width - theme.px(8) - icon_room - left);
  list.AddText(ImVec2(left, at.y + theme.px(3)), colour_u32(shown ? theme.text : theme.muted), name.c_str());
  if (icon_room > 0 && theme.has_icons) {
    list.AddText(ImVec2(left + ImGui::CalcTextSize(name.c_str()).x + theme.px(7), at.y + theme.px(3)),
                 colour_u32(painted_on(state, species) ? theme.attention : theme.accent), icons::brush);
  }
  list.AddText(ImVec2(right - amount_width, at.y + theme.px(3)), colour_u32(theme.text), amount.c_str());
  const float bar = std::min(theme.px(84), (right - left) * 0.4F);
  ImGui::PushFont(theme.small);
  const std::string latin = fitted_text(second_line(species, figures), right - bar - theme.px(8) - left);
  list.AddText(ImVec2(left, at.y + theme.px(22)), colour_u32(theme.muted), latin.c_str());
  ImGui::PopFont();
  if (figures != nullptr)
    draw_shares(theme, ImVec2(right - bar, at.y + theme.px(28)), ImVec2(bar, theme.px(5)), *figures, most_share);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height + theme.px(1)));
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::PopID();
}

float greatest_share(const EditorState& state, const std::vector<int>& species) {
  double most = 0.05;
  for (const int number : species) {
    if (std::size_t(number) >= state.figures.size()) continue;
    const SpeciesFigures& figures = state.figures[std::size_t(number)];
    if (std::isfinite(figures.achieved)) most = std::max(most, figures.achieved);
    if (std::isfinite(figures.desired)) most = std::max(most, figures.desired);
  }
  return float(most);
}

/// Animals and herds of all species of a level.
void draw_totals(const UiContext& ui, const std::vector<int>& species) {
  double animals = 0;
  int herds = 0;
  for (const int number : species) {
    if (std::size_t(number) >= ui.state.figures.size()) continue;
    const SpeciesFigures& figures = ui.state.figures[std::size_t(number)];
    if (!std::isfinite(figures.amount)) return;
    animals += figures.amount;
    herds += figures.herds;
  }
  readout(ui.theme, "All together", format_count(std::round(animals)) + " animals in " + format_count(herds) + " herds");
}

/// Sum of what a level's species ask for, as weights.
double asked_by_level(const FoodWeb& web, int level, const std::string& key) {
  double sum = 0;
  for (const int number : web.levels[std::size_t(level)]) {
    const auto& proportions = web.species[std::size_t(number)].proportions;
    const auto asked = proportions.find(key);
    if (asked != proportions.end()) sum += asked->second;
  }
  return sum;
}

/// Switch of the level and, for the selected species of it, its desired share.
void draw_proportions(const UiContext& ui, const FoodWeb& web, int level) {
  EditorState& state = ui.state;
  const auto found = state.document.use_proportions.find(level);
  bool use = found == state.document.use_proportions.end() || found->second;
  ImGui::PushID(level);
  if (ImGui::Checkbox("Aim at desired shares", &use)) {
    change_document(state, use ? "Aim at desired shares" : "Compete freely",
                    [&](Document& document) { document.use_proportions[level] = use; });
  }
  tooltip(ui.theme, "On: the level aims at its species' desired shares. Off: the fittest take what they can.");
  const int selected = state.selected_species;
  const bool of_level = selected >= 0 && selected < int(web.level.size()) && web.level[std::size_t(selected)] == level;
  // The row is there all the time: a list that moved under the pointer would take the second half of a double click.
  if (use && !of_level) {
    float none = 0;
    ImGui::BeginDisabled();
    labelled_slider(ui.theme, "Desired share", none, 0, 1, "choose a species");
    ImGui::EndDisabled();
  }
  if (use && of_level) {
    const Species& species = web.species[std::size_t(selected)];
    const std::string key = species.proportions.contains(state.document.climate.name) ? state.document.climate.name : "default";
    const auto asked = species.proportions.find(key);
    const double own = asked == species.proportions.end() ? 0 : asked->second;
    const double others = asked_by_level(web, level, key) - own;
    float share = state.dragged_value.value_or(float(own));
    const bool none = asked == species.proportions.end() && !state.dragged_value;
    const double of_all = others + double(share) > 0 ? double(share) / (others + double(share)) : 0;
    // Shares are weights that are compared after they have been brought to a sum of 1.
    const auto most = float(std::max(others + own, 1.0));
    labelled_slider(ui.theme, ("Desired share: " + display_name(species)).c_str(), share, 0, most,
                    none ? "none asked" : format_percent(of_all));
    if (ImGui::IsItemActive()) {
      state.dragged_value = share;
    } else if (state.dragged_value) {
      const double edited = *state.dragged_value;
      state.dragged_value.reset();
      change_document(state, "Desired share of " + display_name(species), [&](Document& document) {
        auto list = std::make_shared<std::vector<Species>>(*document.species);
        for (Species& each : *list) {
          if (each.name == species.name) each.proportions[key] = edited;
        }
        document.species = std::move(list);
      });
    }
  }
  ImGui::PopID();
}

}  // namespace

void draw_species_list(const UiContext& ui, int level) {
  const FoodWeb* web = ui.state.web();
  if (web == nullptr || level >= web->level_count()) return;
  const std::vector<int>& species = web->levels[std::size_t(level)];
  const float most = greatest_share(ui.state, species);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(8), 0));
  for (const int number : species) draw_row(ui, *web, number, most);
  ImGui::PopStyleVar();
}

void draw_plants_panel(const UiContext& ui) {
  const FoodWeb* web = ui.state.web();
  heading(ui.theme, "Plants");
  if (web == nullptr) {
    hint(ui.theme, "The species are being prepared");
    return;
  }
  draw_proportions(ui, *web, 0);
  draw_species_list(ui, 0);
}

void draw_animals_panel(const UiContext& ui) {
  const FoodWeb* web = ui.state.web();
  if (web == nullptr) {
    heading(ui.theme, "Animals");
    hint(ui.theme, "The species are being prepared");
    return;
  }
  for (int level = 1; level < web->level_count(); ++level) {
    heading(ui.theme, level == 1 ? "Level 1: plant eaters" : "Level " + std::to_string(level));
    draw_totals(ui, web->levels[std::size_t(level)]);
    draw_proportions(ui, *web, level);
    draw_species_list(ui, level);
  }
}

}  // namespace biotope
