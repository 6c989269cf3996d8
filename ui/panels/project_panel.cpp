#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
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

void draw_paint_list(const UiContext& ui) {
  EditorState& state = ui.state;
  if (state.document.layers.empty()) return;
  heading(ui.theme, "Paint");
  std::optional<LayerId> removed;
  for (const auto& [layer, paint] : state.document.layers) {
    ImGui::PushID(layer.name.c_str());
    ImGui::PushID(int(layer.kind));
    const int species = state.web() == nullptr ? -1 : state.web()->find(layer.name);
    const std::string name = species < 0 ? layer.name : display_name(state.web()->species[std::size_t(species)]);
    ImGui::TextUnformatted(fitted_text(name, ImGui::GetContentRegionAvail().x - ui.theme.px(30)).c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - ui.theme.px(22));
    if (icon_button(ui.theme, "off", ui.theme.has_icons ? icons::close : "x", ui.theme.muted,
                    "Take this paint off; can be undone"))
      removed = layer;
    ImGui::PopID();
    ImGui::PopID();
  }
  if (removed) clear_paint(state, *removed);
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
  const std::vector<std::string> names = state.history.names();
  const std::size_t position = state.history.position();
  std::optional<std::size_t> wanted;
  if (ImGui::Selectable("As opened", position == 0)) wanted = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool done = i < position;
    ImGui::PushID(int(i));
    ImGui::PushStyleColor(ImGuiCol_Text, done ? ui.theme.text : ui.theme.muted);
    if (ImGui::Selectable(names[i].c_str(), i + 1 == position)) wanted = i + 1;
    ImGui::PopStyleColor();
    ImGui::PopID();
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
  draw_paint_list(ui);
  draw_history_panel(ui);
  draw_timings(ui);
}

}  // namespace biotope
