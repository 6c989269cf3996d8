#include "ui/canvas_menu.hpp"

#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/exploring.hpp"
#include "ui/format.hpp"

namespace biotope {
namespace {

void species_row(const UiContext& ui, const FoodWeb& web, const Presence& presence, int x, int y) {
  const Species& species = web.species[std::size_t(presence.species)];
  const std::string amount = species.is_plant() ? format_percent(presence.amount) : format_value(presence.amount, "/km²");
  ImGui::PushID(presence.species);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string label = "      " + display_name(species);
  if (ImGui::MenuItem(label.c_str(), amount.c_str())) {
    select_species(ui.state, presence.species);
    ask_why(ui.state, x, y);
  }
  const float side = ui.theme.px(10);
  const float top = at.y + (ImGui::GetFontSize() - side) / 2;
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x + ui.theme.px(4), top), ImVec2(at.x + ui.theme.px(4) + side, top + side),
                                            colour_u32(to_imgui(species.colour)), ui.theme.px(2));
  ImGui::PopID();
}

}  // namespace

std::vector<Presence> present_at(const MapsSnapshot& snapshot, int x, int y) {
  std::vector<Presence> plants;
  std::vector<Presence> animals;
  if (!snapshot.web || !snapshot.document.terrain || !snapshot.terrain().height.contains(x, y)) return plants;
  for (std::size_t i = 0; i < snapshot.cover.size(); ++i) {
    if (!snapshot.cover[i]) continue;
    const double cover = cover_fraction((*snapshot.cover[i])(x, y));
    if (cover > 0) plants.push_back({snapshot.web->levels[0][i], cover});
  }
  for (const auto& level : snapshot.animals) {
    if (!level) continue;
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      const ConfinementRegions& regions = *level->regions[i];
      const std::int32_t region = regions.label(x, y);
      if (region < 0 || std::size_t(region) >= level->population[i].size()) continue;
      const double area = regions.regions[std::size_t(region)].area / 1e6;
      const double density = area > 0 ? level->population[i][std::size_t(region)] / area : 0;
      if (density > 0) animals.push_back({level->species[i], density});
    }
  }
  const auto more = [](const Presence& a, const Presence& b) { return a.amount > b.amount; };
  std::stable_sort(plants.begin(), plants.end(), more);
  std::stable_sort(animals.begin(), animals.end(), more);
  plants.insert(plants.end(), animals.begin(), animals.end());
  return plants;
}

void draw_cell_menu(const UiContext& ui, int x, int y) {
  EditorState& state = ui.state;
  const FoodWeb* web = state.web();
  const bool chosen = web != nullptr && state.selected_species >= 0 && state.selected_species < int(web->species.size());
  const std::string name = chosen ? display_name(web->species[std::size_t(state.selected_species)]) : std::string();
  const std::string why = chosen ? "Why here, or why not: " + name + "   " : "What is here?";
  if (ImGui::MenuItem(why.c_str(), "Alt+click")) ask_why(state, x, y);
  if (ImGui::MenuItem(chosen ? ("Paint " + name).c_str() : "Paint", ui.commands.keys("tool.brush").c_str(), false, chosen)) {
    state.tool = Tool::add;
  }
  const PathPoint cell{float(x), float(y)};
  if (ImGui::MenuItem("Look at this place in 3D")) show_place(state, cell);
  if (ImGui::MenuItem("Walk here", ui.commands.keys("explore.walk").c_str())) walk_at(state, cell);
  ImGui::Separator();
  if (web == nullptr || !state.shown) {
    hint(ui.theme, "Still being computed");
    return;
  }
  const std::vector<Presence> present = present_at(*state.shown, x, y);
  if (present.empty()) hint(ui.theme, "Nothing lives here");
  for (const Presence& presence : present) species_row(ui, *web, presence, x, y);
}

}  // namespace biotope
