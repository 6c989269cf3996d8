#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/panels/panels.hpp"

namespace biotope {
namespace {

std::string target_title(const UiContext& ui) {
  const std::optional<LayerId> target = paint_target(ui.state);
  if (!target) return "nothing chosen";
  if (target->kind == LayerKind::resource) return target->name;
  const FoodWeb* web = ui.state.web();
  const int species = web == nullptr ? -1 : web->find(target->name);
  const std::string name = species < 0 ? target->name : display_name(web->species[std::size_t(species)]);
  const std::size_t others = ui.state.also_selected.size();
  return others == 0 || target->kind == LayerKind::resource ? name : name + " and " + std::to_string(others) + " more";
}

const char* verb(Tool tool) {
  switch (tool) {
    case Tool::erase:
      return "Erase";
    case Tool::smooth:
      return "Smooth";
    case Tool::restore:
      return "Restore";
    default:
      return "Paint";
  }
}

}  // namespace

void draw_brush_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  ImGui::Dummy(ImVec2(0, theme.px(2)));
  ImGui::PushFont(theme.bold);
  ImGui::TextUnformatted((std::string(verb(state.tool)) + ": ").c_str());
  ImGui::SameLine(0, 0);
  ImGui::TextColored(theme.accent, "%s", fitted_text(target_title(ui), ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopFont();
  const std::string hindrance = paint_hindrance(state);
  if (!hindrance.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme.attention);
    ImGui::TextWrapped("%s", hindrance.c_str());
    ImGui::PopStyleColor();
  }
  Brush& brush = state.brush;
  const double metres = state.document.terrain ? state.document.terrain->cell_size * double(brush.radius) : 0;
  labelled_slider(theme, "Size", brush.radius, 1, 400, format_length(metres), true);
  tooltip(theme, "Radius of the brush", ui.commands.keys("brush.smaller") + "  " + ui.commands.keys("brush.larger"));
  labelled_slider(theme, "Strength", brush.strength, 0.01F, 1, format_percent(brush.strength));
  tooltip(theme, "How much one dab does", ui.commands.keys("brush.weaker") + "  " + ui.commands.keys("brush.stronger"));
  labelled_slider(theme, "Hardness", brush.hardness, 0, 1, format_percent(brush.hardness));
  tooltip(theme, "Soft edge or flat disk");
  const std::optional<LayerId> target = paint_target(state);
  ImGui::BeginDisabled(!target || !state.document.layers.contains(*target));
  if (ImGui::Button("Take all paint off", ImVec2(-1, 0)) && target) clear_paint(state, *target);
  ImGui::EndDisabled();
  tooltip(theme, "Give the computed map back everywhere; can be undone");
}

}  // namespace biotope
