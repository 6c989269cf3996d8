#include "ui/panels/preset_panel.hpp"

#include <imgui_stdlib.h>

#include <cmath>
#include <utility>

#include "ui/brush_stamps.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/paint_widgets.hpp"

namespace biotope {
namespace {

/// One brush of the list; true when it was chosen.
bool draw_entry(const UiContext& ui, const BrushPreset& preset) {
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = theme.px(28);
  const bool chosen = ImGui::Selectable("##preset", ui.state.paint.preset == preset.name, ImGuiSelectableFlags_AllowItemOverlap,
                                        ImVec2(theme.px(270), height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Grid<float>* stamp = nullptr;
  for (const BrushStamp& each : built_in_stamps()) {
    if (each.name == preset.stamp) stamp = each.weights.get();
  }
  const float side = height - theme.px(6);
  const ImU32 colour = colour_u32(with_alpha(theme.accent, 0.35F + 0.6F * preset.brush.strength));
  draw_stamp(list, ImVec2(at.x + theme.px(3), at.y + theme.px(3)), side, stamp, colour);
  const float top = at.y + (height - ImGui::GetFontSize()) / 2;
  list.AddText(ImVec2(at.x + height + theme.px(6), top), colour_u32(theme.text), preset.name.c_str());
  const std::string size = format_round_length(std::round(double(preset.size)));
  list.AddText(ImVec2(at.x + theme.px(240) - ImGui::CalcTextSize(size.c_str()).x, top), colour_u32(theme.muted), size.c_str());
  return chosen;
}

void draw_own(const UiContext& ui, std::optional<BrushPreset>& chosen) {
  const std::vector<BrushPreset>& own = own_presets(ui.state);
  if (own.empty() && !ui.state.thrown_preset) return;
  ImGui::Separator();
  ImGui::TextDisabled("Your own");
  std::string removed;
  for (const BrushPreset& preset : own) {
    ImGui::PushID(preset.name.c_str());
    if (draw_entry(ui, preset)) chosen = preset;
    ImGui::SameLine(ui.theme.px(256));
    if (icon_button(ui.theme, "remove", ui.theme.has_icons ? icons::trash : "x", ui.theme.muted,
                    "Throw this brush away; it can be taken back"))
      removed = preset.name;
    ImGui::PopID();
  }
  if (!removed.empty()) remove_preset(ui.state, removed);
  if (!ui.state.thrown_preset) return;
  const std::string back = "Take back " + ui.state.thrown_preset->second.name;
  if (ImGui::Button(back.c_str(), ImVec2(ui.theme.px(270), 0))) take_back_preset(ui.state);
}

void draw_keep(const UiContext& ui) {
  EditorState& state = ui.state;
  ImGui::Separator();
  ImGui::TextDisabled("Keep the brush in the hand");
  ImGui::SetNextItemWidth(ui.theme.px(190));
  const bool entered = ImGui::InputTextWithHint("##name", "Name", &state.paint.new_preset, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  ImGui::BeginDisabled(state.paint.new_preset.empty());
  if ((ImGui::Button("Keep", ImVec2(ui.theme.px(72), 0)) || entered) && !state.paint.new_preset.empty()) {
    keep_preset(state, state.paint.new_preset);
    announce(state, "Kept the brush " + state.paint.new_preset);
    state.paint.new_preset.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndDisabled();
}

}  // namespace

void draw_preset_choice(const UiContext& ui) {
  EditorState& state = ui.state;
  const std::string label = state.paint.preset.empty() ? "Brushes ..." : state.paint.preset;
  const bool asked = std::exchange(state.paint.wants_presets, false);
  if (ImGui::Button((label + "##presets").c_str(), ImVec2(-1, 0)) || asked) ImGui::OpenPopup("presets");
  tooltip(ui.theme, "Brushes to start from, and your own", ui.commands.keys("brush.presets"));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(10), ui.theme.px(10)));
  if (ImGui::BeginPopup("presets")) {
    std::optional<BrushPreset> chosen;
    for (const BrushPreset& preset : built_in_presets()) {
      ImGui::PushID(preset.name.c_str());
      if (draw_entry(ui, preset)) chosen = preset;
      ImGui::PopID();
    }
    draw_own(ui, chosen);
    draw_keep(ui);
    if (chosen) {
      use_preset(state, *chosen);
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace biotope
