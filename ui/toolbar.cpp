#include <algorithm>
#include <array>
#include <span>

#include "ui/editor_actions.hpp"
#include "ui/parts.hpp"

namespace biotope {
namespace {

/// Tools that share a place on the toolbar: the one used last stands there, the others fly out.
struct ToolGroup {
  const char* id;
  std::span<const char* const> commands;
};

constexpr const char* selecting[] = {"tool.select_rectangle", "tool.select_lasso", "select.range", "select.invert",
                                     "select.drop"};
constexpr const char* painting[] = {"tool.brush", "tool.set"};
constexpr const char* erasing[] = {"tool.erase", "tool.restore"};
constexpr const char* shaping[] = {"tool.smooth", "tool.sharpen", "tool.noise"};
constexpr const char* cloning[] = {"tool.clone"};
constexpr const char* ground[] = {"tool.raise", "tool.lower", "tool.flatten", "tool.carve"};
constexpr const char* filling[] = {"tool.fill", "tool.gradient"};
constexpr std::array<ToolGroup, 7> groups{{{"paint", painting},
                                           {"erase", erasing},
                                           {"shape", shaping},
                                           {"clone", cloning},
                                           {"ground", ground},
                                           {"fill", filling},
                                           {"select", selecting}}};

constexpr float hold_seconds = 0.35F;  // a button held this long flies out

void draw_line(const Theme& theme, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x + theme.px(4), at.y + theme.px(2)),
                                      ImVec2(at.x + side - theme.px(4), at.y + theme.px(2)), colour_u32(theme.line));
  ImGui::Dummy(ImVec2(side, theme.px(5)));
}

/// The command that stands for a group: the tool in the hand, else the one used last.
const char* front_of(EditorState& state, const CommandTable& commands, const ToolGroup& group) {
  std::string& last = state.paint.last_of_group[group.id];
  for (const char* id : group.commands) {
    const EditorCommand* command = commands.find(id);
    if (command != nullptr && checked(*command, state)) last = id;
  }
  for (const char* id : group.commands) {
    if (last == id) return id;
  }
  return group.commands.front();
}

void draw_flyout(const UiContext& ui, const ToolGroup& group) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(8), ui.theme.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(8), ui.theme.px(5)));
  if (ImGui::BeginPopup(group.id)) {
    for (const char* id : group.commands) {
      const EditorCommand* command = ui.commands.find(id);
      if (command == nullptr) continue;
      const std::string icon = ui.theme.has_icons ? std::string(command->icon) + "   " : std::string();
      const std::string keys = ui.commands.keys(id);
      if (ImGui::MenuItem((icon + command->name).c_str(), keys.c_str(), checked(*command, ui.state), enabled(*command, ui.state)))
        run(*command, ui.state);
      tooltip(ui.theme, command->tooltip);
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

void draw_group(const UiContext& ui, const ToolGroup& group, float side) {
  const char* front = front_of(ui.state, ui.commands, group);
  const EditorCommand* command = ui.commands.find(front);
  const bool was_on = command != nullptr && checked(*command, ui.state);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  command_button(ui, front, side);
  if (group.commands.size() == 1) return;
  const bool held = ImGui::IsItemActive() && ImGui::GetIO().MouseDownDuration[0] > hold_seconds;
  const bool right = ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Right);
  const bool again = ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && was_on;
  if (held || right || again) {
    ImGui::SetNextWindowPos(ImVec2(at.x + side + ui.theme.px(8), at.y));
    ImGui::OpenPopup(group.id);
  }
  // A corner says that there is more.
  const float corner = ui.theme.px(5);
  const ImVec2 low(at.x + side - ui.theme.px(3), at.y + side - ui.theme.px(3));
  ImGui::GetWindowDrawList()->AddTriangleFilled(low, ImVec2(low.x - corner, low.y), ImVec2(low.x, low.y - corner),
                                                colour_u32(was_on ? ui.theme.accent : ui.theme.muted));
  if (ImGui::IsPopupOpen(group.id)) ImGui::SetNextWindowPos(ImVec2(at.x + side + ui.theme.px(8), at.y));
  draw_flyout(ui, group);
}

}  // namespace

void draw_toolbar(const UiContext& ui) {
  const float side = ui.theme.px(32);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.theme.px(3)));
  const float bottom = ImGui::GetWindowHeight() - side;
  command_button(ui, "tool.select", side);
  draw_line(ui.theme, side);
  for (const ToolGroup& group : groups) draw_group(ui, group, side);
  draw_line(ui.theme, side);
  for (const char* id : {"edit.undo", "edit.redo"}) command_button(ui, id, side);
  draw_line(ui.theme, side);
  // What is in the menus too goes first where the window is low.
  for (const char* id : {"view.map", "view.landscape", "view.split", "view.frame", "help.palette", "file.screenshot"}) {
    if (ImGui::GetCursorPosY() < bottom) command_button(ui, id, side);
  }
  ImGui::PopStyleVar();
}

}  // namespace biotope
