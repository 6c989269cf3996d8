#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/panels/herd_panel.hpp"
#include "ui/panels/layers_panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts.hpp"

namespace biotope {
namespace {

void draw_tab_panel(const UiContext& ui) {
  if (!ui.state.has_document) {
    heading(ui.theme, ui.state.loading.running() ? "Opening ..." : "Nothing is open");
    hint(ui.theme, ui.state.loading.running()
                       ? ui.state.loading.stage()
                       : "Drop a terrain or a scene here, or press " + ui.commands.keys("file.open") + " to open one.");
    return;
  }
  switch (ui.state.view.tab) {
    case Tab::terrain:
      draw_terrain_panel(ui);
      break;
    case Tab::climate:
      draw_climate_panel(ui);
      break;
    case Tab::plants:
      draw_plants_panel(ui);
      break;
    case Tab::animals:
      draw_animals_panel(ui);
      break;
    case Tab::trails:
      draw_trails_panel(ui);
      break;
    case Tab::project:
      draw_project_panel(ui);
      break;
  }
}

}  // namespace

void draw_inspector(const UiContext& ui) {
  const EditorState& state = ui.state;
  const bool brush = state.has_document && (is_painting(state.tool) || is_selecting(state.tool));
  const bool why = state.has_document && state.question.has_value();
  const bool herd = state.has_document && state.herd_day.herd.has_value();
  const float available = ImGui::GetContentRegionAvail().y;
  const bool layers = state.has_document && state.view.tab != Tab::project;
  const float layers_room = layers ? layers_height(ui) : 0;
  // The brush takes what it needs, as it was drawn last, and leaves the list above room for a few lines.
  const float brush_height = !brush ? 0 : std::min(state.paint.brush_height + ui.theme.px(10), (available - layers_room) * 0.62F);
  // Together they leave the list room for a few lines; each is scrolled where it is short.
  const float most = why && herd ? 0.34F : 0.42F;
  const float why_height = why ? std::min(ui.theme.px(230), available * most * (brush ? 0.5F : 1)) : 0;
  const float herd_height = herd ? std::min(ui.theme.px(440), available * (why ? 0.4F : 0.56F) * (brush ? 0.5F : 1)) : 0;
  const float list_height = std::max(available - brush_height - why_height - herd_height - layers_room, ui.theme.px(80));
  ImGui::BeginChild("tab panel", ImVec2(0, list_height));
  draw_tab_panel(ui);
  ImGui::EndChild();
  const auto line = [&] {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x - ui.theme.px(10), at.y),
                                        ImVec2(at.x + ImGui::GetContentRegionAvail().x + ui.theme.px(10), at.y),
                                        colour_u32(ui.theme.line));
  };
  if (why) {
    line();
    ImGui::BeginChild("why", ImVec2(0, why_height - ui.theme.px(6)));
    draw_why_panel(ui);
    ImGui::EndChild();
  }
  if (herd) {
    line();
    ImGui::BeginChild("herd", ImVec2(0, herd_height - ui.theme.px(6)));
    draw_herd_panel(ui);
    ImGui::EndChild();
  }
  if (brush) {
    line();
    ImGui::BeginChild("brush", ImVec2(0, std::max(brush_height - ui.theme.px(6), ui.theme.px(40))));
    draw_brush_panel(ui);
    ui.state.paint.brush_height = ImGui::GetCursorPosY();
    ImGui::EndChild();
  }
  if (layers) {
    line();
    draw_layers_panel(ui, true);
  }
}

}  // namespace biotope
