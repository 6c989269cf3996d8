#include <algorithm>
#include <array>
#include <utility>

#include "ui/editor_actions.hpp"
#include "ui/inspector_layout.hpp"
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

constexpr std::array<const char*, inspector_cards> card_names{"Why?", "Herd", "Brush"};

/// Whether a card is about something else than in the frame before.
std::array<bool, inspector_cards> renewed_cards(EditorState& state) {
  InspectorSubjects& before = state.inspector_subjects;
  InspectorSubjects now;
  if (state.question && !state.view.why_follows) now.asked = {state.question->x, state.question->y};
  if (state.herd_day.herd) now.herd = {state.herd_day.herd->species, state.herd_day.herd->home, state.herd_day.herd->number};
  now.tool = state.tool;
  const std::array<bool, inspector_cards> renewed{now.asked != before.asked, now.herd != before.herd, now.tool != before.tool};
  before = std::move(now);
  return renewed;
}

void draw_card(const UiContext& ui, InspectorCard card) {
  switch (card) {
    case InspectorCard::why:
      draw_why_panel(ui);
      break;
    case InspectorCard::herd:
      draw_herd_panel(ui);
      break;
    case InspectorCard::brush:
      draw_brush_panel(ui);
      break;
  }
}

/// Of a part that Dear ImGui puts its spacing after.
float inner_height(float height) { return std::max(height - ImGui::GetStyle().ItemSpacing.y, 1.0F); }

/// A line over the whole width.
void draw_edge(const Theme& theme) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x - theme.px(10), at.y),
                                      ImVec2(at.x + ImGui::GetContentRegionAvail().x + theme.px(10), at.y),
                                      colour_u32(theme.line));
}

/// The names of the cards that are there, to bring one to the front.
void draw_card_tabs(const UiContext& ui, InspectorState& inspector, float height) {
  const Theme& theme = ui.theme;
  bool first = true;
  for (std::size_t i = 0; i < inspector.present.size(); ++i) {
    if (!inspector.present[i]) continue;
    if (!first) ImGui::SameLine(0, theme.px(2));
    first = false;
    const bool front = inspector.front == InspectorCard(i);
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, front ? theme.text : theme.muted);
    if (ImGui::Button(card_names[i], ImVec2(0, inner_height(height) - theme.px(1)))) inspector.front = InspectorCard(i);
    ImGui::PopStyleColor(2);
    if (!front) continue;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(low.x + theme.px(4), high.y),
                                              ImVec2(high.x - theme.px(4), high.y + theme.px(2)), colour_u32(theme.accent), 1);
  }
}

void draw_cards(const UiContext& ui, InspectorState& inspector, const InspectorLayout& layout) {
  for (std::size_t i = 0; i < inspector.present.size(); ++i) {
    if (!inspector.present[i] || layout.card[i] <= 0) continue;
    if (!layout.tabs) draw_edge(ui.theme);
    ImGui::BeginChild(card_names[i], ImVec2(0, inner_height(layout.card[i])));
    draw_card(ui, InspectorCard(i));
    inspector.content[i] = ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y + ui.theme.px(2);
    ImGui::EndChild();
  }
}

}  // namespace

void draw_inspector(const UiContext& ui) {
  EditorState& state = ui.state;
  InspectorState& inspector = state.inspector;
  const bool open = state.has_document;
  follow_cards(inspector,
               {open && state.question.has_value(), open && state.herd_day.herd.has_value(),
                open && (is_painting(state.tool) || is_selecting(state.tool))},
               renewed_cards(state));
  const bool layers = open && state.view.tab != Tab::project;
  const float room = ImGui::GetContentRegionAvail().y - (layers ? layers_height(ui) : 0);
  const float tab_height = ui.theme.px(30);
  const InspectorLayout layout = lay_out_inspector(inspector, room, ui.theme.px(235), tab_height);
  ImGui::BeginChild("tab panel", ImVec2(0, inner_height(layout.list)));
  draw_tab_panel(ui);
  ImGui::EndChild();
  if (layout.tabs) {
    draw_edge(ui.theme);
    draw_card_tabs(ui, inspector, tab_height);
  }
  draw_cards(ui, inspector, layout);
  if (layers) {
    draw_edge(ui.theme);
    draw_layers_panel(ui, true);
  }
}

}  // namespace biotope
