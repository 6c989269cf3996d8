#include "ui/panels/food_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"

namespace biotope {
namespace {

/// A species' place in the picture.
struct Chip {
  int species = 0;
  int level = 0;
  ImVec2 at;
  ImVec2 size;
  [[nodiscard]] ImVec2 top() const { return {at.x + size.x / 2, at.y}; }
  [[nodiscard]] ImVec2 bottom() const { return {at.x + size.x / 2, at.y + size.y}; }
};

struct Picture {
  std::vector<Chip> chips;
  /// Upper and lower edge of each level's band.
  std::vector<std::array<float, 2>> bands;
  float height = 0;
};

std::string short_name(const Species& species) { return display_name(species); }

/// Rows of chips, the top of the chain first; a level takes as many rows as it needs.
Picture arrange(const UiContext& ui, const FoodWeb& web, ImVec2 origin, float width) {
  const Theme& theme = ui.theme;
  const float gap = theme.px(6);
  const float chip_height = theme.px(34);
  const float between = theme.px(34);
  Picture picture;
  picture.bands.resize(web.levels.size());
  float y = origin.y;
  for (std::size_t i = web.levels.size(); i-- > 0;) {
    picture.bands[i][0] = y;
    y += theme.px(20);
    float x = origin.x;
    for (const int species : web.levels[i]) {
      const std::string name = short_name(web.species[std::size_t(species)]);
      const float chip_width = std::clamp(ImGui::CalcTextSize(name.c_str()).x + theme.px(24), theme.px(84), width);
      if (x > origin.x && x + chip_width > origin.x + width) {
        x = origin.x;
        y += chip_height + gap;
      }
      picture.chips.push_back({species, int(i), ImVec2(x, y), ImVec2(chip_width, chip_height)});
      x += chip_width + gap;
    }
    y += chip_height + theme.px(8);
    picture.bands[i][1] = y;
    y += between;
  }
  picture.height = y - between - origin.y;
  return picture;
}

/// Kilograms a year that a level eats of a species.
double eaten_by_level(const MapsSnapshot& maps, std::size_t level, int species) {
  if (level == 0 || level > maps.animals.size() || !maps.animals[level - 1]) return 0;
  const auto& eaten = maps.animals[level - 1]->eaten;
  if (std::size_t(species) >= eaten.size()) return 0;
  double sum = 0;
  for (const double kilograms : eaten[std::size_t(species)]) sum += kilograms;
  return sum;
}

/// Curves from what is eaten up to the level that eats it, as wide as the root of the yearly mass.
void draw_flows(const UiContext& ui, const MapsSnapshot& maps, const Picture& picture, int lit) {
  struct Flow {
    ImVec2 from;
    ImVec2 to;
    double kilograms = 0;
    int species = 0;
  };
  std::vector<Flow> flows;
  double most = 0;
  for (const Chip& chip : picture.chips) {
    for (std::size_t level = std::size_t(chip.level) + 1; level < picture.bands.size(); ++level) {
      const double kilograms = eaten_by_level(maps, level, chip.species);
      if (kilograms <= 0) continue;
      flows.push_back({chip.top(), ImVec2(chip.top().x, picture.bands[level][1]), kilograms, chip.species});
      most = std::max(most, kilograms);
    }
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Flow& flow : flows) {
    const float width = std::max(ui.theme.px(1), ui.theme.px(16) * float(std::sqrt(flow.kilograms / most)));
    const auto& colour = maps.web->species[std::size_t(flow.species)].colour;
    const float alpha = lit < 0 || lit == flow.species ? 0.75F : 0.2F;
    list.AddLine(flow.from, flow.to, colour_u32(to_imgui(colour, alpha)), width);
  }
}

/// What the worker has still to do; nothing when it rests.
StaleStages stale_now(const EditorState& state) {
  const WorkerProgress progress = state.worker ? state.worker->progress() : WorkerProgress{};
  return progress.busy ? progress.stale : StaleStages{};
}

/// Of an edge that breathes while something is being computed.
ImVec4 pulse(const Theme& theme) {
  const auto wave = float(0.5 + 0.5 * std::sin(ImGui::GetTime() * 6));
  return with_alpha(theme.accent, 0.3F + 0.6F * wave);
}

/// What lies below and above the levels: lit while it is being computed.
void draw_stages(const UiContext& ui, const StaleStages& stale) {
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(theme.small);
  const std::array<std::pair<const char*, bool>, 4> stages{
      {{"Water", stale.water}, {"Light and soil", stale.environment}, {"Trails", stale.trails}, {"Daily plans", stale.days}}};
  for (const auto& [name, updating] : stages) {
    const ImVec2 text = ImGui::CalcTextSize(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 end(at.x + text.x + theme.px(14), at.y + text.y + theme.px(6));
    list.AddRectFilled(at, end, colour_u32(with_alpha(theme.text, 0.05F)), theme.px(4));
    if (updating) list.AddRect(at, end, colour_u32(pulse(theme)), theme.px(4), 0, theme.px(1.5F));
    list.AddText(ImVec2(at.x + theme.px(7), at.y + theme.px(3)), colour_u32(updating ? theme.text : theme.muted), name);
    ImGui::Dummy(ImVec2(end.x - at.x, end.y - at.y));
    ImGui::SameLine(0, theme.px(6));
  }
  ImGui::NewLine();
  ImGui::PopFont();
}

void chip_tooltip(const UiContext& ui, const Species& species, const SpeciesFigures* figures) {
  if (!ImGui::IsItemHovered()) return;
  std::string text = display_name(species);
  if (figures != nullptr && std::isfinite(figures->growth)) {
    const std::string unit = species.is_plant() ? "kg/yr" : "animals/yr";
    text += "\nGrows " + format_value(figures->growth, unit);
    text += "\nEaten " + format_value(figures->eaten, unit);
    text += "\nSurplus " + format_value(figures->surplus(), unit);
  }
  tooltip(ui.theme, text);
}

void draw_chip(const UiContext& ui, const FoodWeb& web, const Chip& chip, const std::map<int, SpeciesChange>& changes) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const Species& species = web.species[std::size_t(chip.species)];
  const auto number = std::size_t(chip.species);
  const SpeciesFigures* figures = number < state.figures.size() ? &state.figures[number] : nullptr;
  ImGui::PushID(chip.species);
  ImGui::SetCursorScreenPos(chip.at);
  if (ImGui::InvisibleButton("chip", chip.size)) select_species(state, chip.species);
  chip_tooltip(ui, species, figures);
  const bool selected = state.selected_species == chip.species;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(chip.at.x + chip.size.x, chip.at.y + chip.size.y);
  list.AddRectFilled(chip.at, end, colour_u32(theme.raised), theme.px(4));
  list.AddRectFilled(chip.at, ImVec2(chip.at.x + theme.px(4), end.y), colour_u32(to_imgui(species.colour)), theme.px(2));
  if (selected || ImGui::IsItemHovered()) list.AddRect(chip.at, end, colour_u32(theme.accent), theme.px(4), 0, theme.px(1.5F));
  const float left = chip.at.x + theme.px(10);
  list.AddText(ImVec2(left, chip.at.y + theme.px(1)), colour_u32(theme.text),
               fitted_text(short_name(species), chip.size.x - theme.px(14)).c_str());
  ImGui::PushFont(theme.small);
  const float second = chip.at.y + theme.px(18);
  if (figures != nullptr && std::isfinite(figures->amount)) {
    const std::string amount = species.is_plant() ? format_percent(figures->amount) : format_count(std::round(figures->amount));
    list.AddText(ImVec2(left, second), colour_u32(theme.muted), amount.c_str());
  }
  if (const auto found = changes.find(chip.species); found != changes.end() && !(std::abs(found->second.amount) < 0.002)) {
    const std::string change = format_change(found->second.amount);
    const ImVec4& colour = found->second.amount < 0 ? theme.attention : theme.accent;
    list.AddText(ImVec2(end.x - ImGui::CalcTextSize(change.c_str()).x - theme.px(6), second), colour_u32(colour), change.c_str());
  }
  ImGui::PopFont();
  ImGui::PopID();
}

void draw_bands(const UiContext& ui, const Picture& picture, float left, float width) {
  const Theme& theme = ui.theme;
  const StaleStages stale = stale_now(ui.state);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < picture.bands.size(); ++i) {
    const auto [top, bottom] = picture.bands[i];
    const ImVec2 from(left - theme.px(6), top);
    const ImVec2 to(left + width + theme.px(6), bottom);
    list.AddRectFilled(from, to, colour_u32(with_alpha(theme.text, 0.04F)), theme.px(5));
    const bool updating = stale.level(int(i));
    if (updating) list.AddRect(from, to, colour_u32(pulse(theme)), theme.px(5), 0, theme.px(1.5F));
    ImGui::PushFont(theme.small);
    const std::string title =
        (i == 0 ? std::string("Plants") : "Level " + std::to_string(i)) + (updating ? ", being computed" : "");
    list.AddText(ImVec2(left, top + theme.px(3)), colour_u32(theme.muted), title.c_str());
    ImGui::PopFont();
  }
}

void draw_picture(const UiContext& ui, const MapsSnapshot& maps) {
  const FoodWeb& web = *maps.web;
  const float width = ImGui::GetContentRegionAvail().x - ui.theme.px(8);
  ImVec2 origin = ImGui::GetCursorScreenPos();
  origin.x += ui.theme.px(6);
  const Picture picture = arrange(ui, web, origin, width - ui.theme.px(6));
  draw_bands(ui, picture, origin.x, width - ui.theme.px(6));
  draw_flows(ui, maps, picture, ui.state.selected_species);
  std::map<int, SpeciesChange> changes;
  for (const SpeciesChange& change : ui.state.changes.changes()) changes[change.species] = change;
  for (const Chip& chip : picture.chips) draw_chip(ui, web, chip, changes);
  ImGui::SetCursorScreenPos(ImVec2(origin.x, origin.y + picture.height + ui.theme.px(6)));
}

}  // namespace

void draw_food_chain(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!state.view.food_chain || !state.shown || !state.shown->web) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSize(ImVec2(ui.theme.px(560), 0), ImGuiCond_Appearing);
  ImGui::SetNextWindowPos(ImVec2(ui.theme.px(60), screen.y * 0.14F), ImGuiCond_Appearing);
  ImGui::SetNextWindowSizeConstraints(ImVec2(ui.theme.px(320), ui.theme.px(200)), ImVec2(ui.theme.px(900), screen.y * 0.82F));
  ImGui::SetNextWindowBgAlpha(0.96F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(10), ui.theme.px(8)));
  if (ImGui::Begin("Food chain", &state.view.food_chain, ImGuiWindowFlags_NoSavedSettings)) {
    const std::string text = changes_text(*state.shown->web, state.changes.changes(), 5);
    const std::string& edit = state.changes.answered_edit();
    if (!edit.empty()) hint(ui.theme, "After '" + edit + "': " + text);
    draw_stages(ui, stale_now(state));
    draw_picture(ui, *state.shown);
    hint(ui.theme, "Bands: kilograms eaten in a year. Click a species to see its map.");
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace biotope
