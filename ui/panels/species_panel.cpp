#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/layer_actions.hpp"
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
  set_species_locked(ui.state, species, !is_locked);
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

/// A row of the list: what it is about and where it lies.
struct SpeciesRow {
  const Species& species;
  const SpeciesFigures* figures;  ///< null while they are not known
  int number;
  bool selected;
  bool shown;
  ImVec2 at;
  ImVec2 size;
};

/// The whole row as a button: a click selects, with Ctrl together with others.
void handle_row(const UiContext& ui, const SpeciesRow& row) {
  EditorState& state = ui.state;
  if (ImGui::Selectable("##row", row.selected, ImGuiSelectableFlags_AllowItemOverlap, row.size)) {
    if (ImGui::GetIO().KeyCtrl) {
      toggle_species(state, row.number);
    } else {
      select_species(state, row.number);
    }
  }
  if (row_double_clicked()) show_species(state, row.number);
  row_tooltip(ui, row.species, row.figures);
  ImGui::SetItemAllowOverlap();
}

void draw_row_buttons(const UiContext& ui, const FoodWeb& web, const SpeciesRow& row) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  ImGui::SetCursorScreenPos(ImVec2(row.at.x + theme.px(2), row.at.y + theme.px(3)));
  const char* eye = theme.has_icons ? (row.shown ? icons::eye : icons::eye_closed) : (row.shown ? "o" : "-");
  if (icon_button(theme, "eye", eye, row.shown ? theme.muted : with_alpha(theme.muted, 0.5F),
                  row.shown ? "Hide on the map and in 3D" : "Show again")) {
    set_visible(state, web, row.number, !row.shown);
  }
  draw_lock(ui, row.species, ImVec2(row.at.x + theme.px(3), row.at.y + theme.px(23)),
            species_locked(state.document, row.species));
}

/// Name, amount, family or herds, and shares.
void draw_row_texts(const UiContext& ui, const SpeciesRow& row, float most_share) {
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float chip = row.at.x + theme.px(28);
  list.AddRectFilled(ImVec2(chip, row.at.y + theme.px(6)), ImVec2(chip + theme.px(6), row.at.y + row.size.y - theme.px(6)),
                     colour_u32(to_imgui(row.species.colour)), theme.px(3));
  const float left = row.at.x + theme.px(42);
  const float right = row.at.x + row.size.x - theme.px(6);
  const float top = row.at.y + theme.px(3);
  const std::string amount = amount_text(row.species, row.figures);
  const float amount_width = ImGui::CalcTextSize(amount.c_str()).x;
  const bool painted = painted_on(ui.state, row.species);
  const float icon_room = row.selected || painted ? theme.px(22) : 0;
  const std::string name = fitted_text(display_name(row.species), right - amount_width - theme.px(8) - icon_room - left);
  list.AddText(ImVec2(left, top), colour_u32(row.shown ? theme.text : theme.muted), name.c_str());
  if (icon_room > 0 && theme.has_icons) {
    list.AddText(ImVec2(left + ImGui::CalcTextSize(name.c_str()).x + theme.px(7), top),
                 colour_u32(painted ? theme.attention : theme.accent), icons::brush);
  }
  list.AddText(ImVec2(right - amount_width, top), colour_u32(theme.text), amount.c_str());
  const float bar = std::min(theme.px(84), (right - left) * 0.4F);
  ImGui::PushFont(theme.small);
  const std::string latin = fitted_text(second_line(row.species, row.figures), right - bar - theme.px(8) - left);
  list.AddText(ImVec2(left, row.at.y + theme.px(22)), colour_u32(theme.muted), latin.c_str());
  ImGui::PopFont();
  if (row.figures == nullptr) return;
  draw_shares(theme, ImVec2(right - bar, row.at.y + theme.px(28)), ImVec2(bar, theme.px(5)), *row.figures, most_share);
}

void draw_row(const UiContext& ui, const FoodWeb& web, int number, float most_share) {
  const EditorState& state = ui.state;
  const auto index = std::size_t(number);
  const bool selected = state.selected_species == number || state.also_selected.contains(number);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, ui.theme.px(42));
  const SpeciesRow row{web.species[index],
                       index < state.figures.size() ? &state.figures[index] : nullptr,
                       number,
                       selected,
                       visible(state, number),
                       ImGui::GetCursorScreenPos(),
                       size};
  ImGui::PushID(number);
  handle_row(ui, row);
  draw_row_buttons(ui, web, row);
  draw_row_texts(ui, row, most_share);
  ImGui::SetCursorScreenPos(ImVec2(row.at.x, row.at.y + size.y + ui.theme.px(1)));
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
  draw_desired_shares(ui, *web, 0);
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
    draw_desired_shares(ui, *web, level);
    draw_species_list(ui, level);
  }
}

}  // namespace biotope
