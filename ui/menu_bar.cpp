#include <imgui_internal.h>

#include <filesystem>
#include <utility>

#include "ui/editor_actions.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tool_gestures.hpp"

namespace biotope {
namespace {

/// Files opened lately, below File > Open.
void draw_recent_menu(const UiContext& ui) {
  if (!ImGui::BeginMenu("Open recent", !ui.state.settings.recent.empty())) return;
  const std::vector<std::string> recent = ui.state.settings.recent;
  for (const std::string& file : recent) {
    const bool sample = file.starts_with("sample:");
    const std::string name = sample ? "Sample: " + file.substr(7) : std::filesystem::path(file).filename().string();
    ImGui::PushID(file.c_str());
    if (ImGui::MenuItem(name.c_str())) open_or_import(ui.state, file);
    tooltip(ui.theme, file);
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

void draw_menu(const UiContext& ui, const std::string& menu) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(8), ui.theme.px(6)));
  if (ImGui::BeginMenu(menu.c_str())) {
    for (const EditorCommand& command : ui.commands.all()) {
      if (command.menu != menu) continue;
      command_menu_item(ui, command.id);
      if (command.id == "file.open") draw_recent_menu(ui);
    }
    ImGui::EndMenu();
  }
  ImGui::PopStyleVar();
}

void draw_title(const UiContext& ui) {
  const EditorState& state = ui.state;
  const std::string title = document_name(state);
  const std::string saved = !state.has_document ? "" : state.dirty() ? "not saved" : state.scene_file.empty() ? "" : "saved";
  const float gap = ui.theme.px(10);
  const float width = ImGui::CalcTextSize(title.c_str()).x + gap + ImGui::CalcTextSize(saved.c_str()).x + ui.theme.px(26);
  ImGui::SameLine(ImGui::GetWindowWidth() - width);
  ImGui::TextUnformatted(title.c_str());
  ImGui::SameLine(0, gap);
  ImGui::TextColored(state.dirty() ? ui.theme.attention : ui.theme.muted, "%s", saved.c_str());
}

}  // namespace

float draw_menu_bar(const UiContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.theme.px(8), ui.theme.px(5)));
  float height = 0;
  if (ImGui::BeginMainMenuBar()) {
    height = ImGui::GetWindowHeight();
    for (const std::string& menu : ui.commands.menus()) draw_menu(ui, menu);
    draw_title(ui);
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar();
  return height;
}

void handle_shortcuts(const UiContext& ui, bool landscape_letters) {
  EditorState& state = ui.state;
  const bool popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (popup && take_key(state, DialogKey::escape)) {
    // Menus and lists close one level; dialogs have taken the key already.
    ImGui::ClosePopupToLevel(GImGui->OpenPopupStack.Size - 1, true);
  }
  const std::vector<KeyPress> presses = std::exchange(state.key_presses, {});
  if (tool_active(state)) {
    // Nothing else happens in the middle of a stroke; Esc takes it back.
    for (const KeyPress& press : presses) {
      if (press.keys.key == int(DialogKey::escape)) cancel_tool(state);
    }
    return;
  }
  if (popup || ImGui::GetIO().WantTextInput) return;
  constexpr std::string_view fly_letters = "WASDQE";
  for (const KeyPress& press : presses) {
    const int key = press.keys.key;
    const bool flies =
        landscape_letters && !press.keys.control && key > 0 && key < 128 && fly_letters.find(char(key)) != std::string_view::npos;
    if (flies) continue;
    const EditorCommand* command = ui.commands.of_keys(press.keys);
    if (command == nullptr || (press.repeat && !command->repeats)) continue;
    run(*command, state);
  }
}

}  // namespace biotope
