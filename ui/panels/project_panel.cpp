#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/editor_actions.hpp"
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

void draw_warnings_panel(const UiContext& ui) {
  const EditorState& state = ui.state;
  if (!state.shown) return;
  const std::size_t count = state.shown->warnings.size();
  heading(ui.theme, count == 0 ? "Warnings: none" : "Warnings: " + std::to_string(count));
  for (const std::string& warning : state.shown->warnings) {
    if (ui.theme.has_icons) {
      ImGui::TextColored(ui.theme.attention, "%s", icons::warning);
      ImGui::SameLine();
    }
    ImGui::TextWrapped("%s", warning.c_str());
  }
  if (!state.shown->status) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.loss);
    ImGui::TextWrapped("%s", state.shown->status.error().message.c_str());
    ImGui::PopStyleColor();
  }
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
