#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/exploring.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/panels/layers_panel.hpp"
#include "ui/panels/panels.hpp"

namespace biotope {
namespace {

void draw_identity(const UiContext& ui) {
  EditorState& state = ui.state;
  ImGui::TextDisabled("Title");
  std::string title = state.document.title;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##title", &title, ImGuiInputTextFlags_EnterReturnsTrue) && title != state.document.title) {
    change_document(state, "Title", [&](Document& document) { document.title = title; });
  }
  ImGui::TextDisabled("Seed");
  auto seed = state.document.seed;
  ImGui::SetNextItemWidth(-1);
  const std::uint64_t step = 1;
  ImGui::InputScalar("##seed", ImGuiDataType_U64, &seed, &step, nullptr, "%llu");
  if (ImGui::IsItemDeactivatedAfterEdit() && seed != state.document.seed) {
    change_document(state, "Seed", [&](Document& document) { document.seed = seed; });
  }
  tooltip(ui.theme, "The same inputs and seed always give the same landscape");
}

void draw_timings(const UiContext& ui) {
  const EditorState& state = ui.state;
  if (!state.shown || state.shown->timings.empty()) return;
  if (!ImGui::TreeNodeEx("How long the last computation took", ImGuiTreeNodeFlags_SpanAvailWidth)) return;
  for (const auto& [stage, milliseconds] : state.shown->timings) readout(ui.theme, stage, format_value(milliseconds, "ms"));
  ImGui::TreePop();
}

}  // namespace

void draw_history_panel(const UiContext& ui) {
  EditorState& state = ui.state;
  heading(ui.theme, "History");
  const std::size_t position = state.history.position();
  std::optional<std::size_t> wanted;
  const std::size_t dropped = state.history.dropped();
  const std::string first = dropped == 0 ? "As opened" : std::to_string(dropped) + " older steps are forgotten";
  if (ImGui::Selectable(first.c_str(), position == 0)) wanted = 0;
  ImGuiListClipper rows;
  rows.Begin(int(state.history.size()));
  while (rows.Step()) {
    for (int row = rows.DisplayStart; row < rows.DisplayEnd; ++row) {
      const auto step = std::size_t(row);
      ImGui::PushID(row);
      ImGui::PushStyleColor(ImGuiCol_Text, step < position ? ui.theme.text : ui.theme.muted);
      if (ImGui::Selectable(state.history.name(step).c_str(), step + 1 == position)) wanted = step + 1;
      ImGui::PopStyleColor();
      ImGui::PopID();
    }
  }
  if (wanted) go_to_step(state, *wanted);
  hint(ui.theme, "Undo holds " + format_bytes(state.history.bytes()) + " of " + format_bytes(state.history.budget()));
}

namespace {

/// One warning; a click goes to its place and species.
void draw_warning(const UiContext& ui, const Warning& warning) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const float left = theme.has_icons ? ImGui::GetCursorPosX() + theme.px(22) : ImGui::GetCursorPosX();
  if (theme.has_icons) {
    ImGui::TextColored(theme.attention, "%s", icons::warning);
    ImGui::SameLine(left);
  }
  ImGui::BeginGroup();
  wrapped(theme.text, warning.text);
  ImGui::EndGroup();
  if (!warning.place && warning.species < 0) return;
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  tooltip(theme, warning.place ? "Click: go there" : "Click: choose the species");
  if (!ImGui::IsItemHovered() || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
  if (warning.species >= 0) select_species(state, warning.species);
  if (warning.place) show_place(state, *warning.place);
}

}  // namespace

void draw_warnings_panel(const UiContext& ui) {
  const EditorState& state = ui.state;
  if (!state.shown) return;
  const std::size_t count = state.shown->warnings.size();
  heading(ui.theme, count == 0 ? "Warnings: none" : "Warnings: " + std::to_string(count));
  // A click may open another view of them: they are read from what was shown.
  const std::shared_ptr<const MapsSnapshot> shown = state.shown;
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::PushID(int(i));
    draw_warning(ui, shown->warnings[i]);
    ImGui::PopID();
  }
  if (!state.shown->status) wrapped(ui.theme.loss, state.shown->status.error().message);
}

void draw_project_panel(const UiContext& ui) {
  heading(ui.theme, "Project");
  draw_identity(ui);
  draw_warnings_panel(ui);
  draw_layers_panel(ui, false);
  draw_history_panel(ui);
  draw_timings(ui);
}

}  // namespace biotope
