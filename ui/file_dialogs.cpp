#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "ui/dialogs.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

constexpr float button_width = 110;
constexpr std::size_t most_shown_recent = 4;

std::filesystem::path home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr ? home : "/";
}

void start_browsing(EditorState& state, bool saving) {
  FileBrowser& browser = state.browser;
  browser.scenes_only = saving;
  browser.confirm_overwrite = false;
  browser.name.clear();
  if (saving) {
    const std::string title = state.document.title.empty() ? state.document.terrain->name : state.document.title;
    browser.name =
        state.scene_file.empty() ? (title.empty() ? "landscape" : title) + ".biotope" : state.scene_file.filename().string();
  }
  std::error_code error;
  const std::filesystem::path last = state.settings.last_folder;
  browser.go_to(!last.empty() && std::filesystem::is_directory(last, error) ? last : home_folder());
}

void draw_path_row(const UiContext& ui) {
  FileBrowser& browser = ui.state.browser;
  if (ImGui::Button(ui.theme.has_icons ? icons::up : "Up")) browser.go_to(browser.folder.parent_path());
  tooltip(ui.theme, "The folder above");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##path", &browser.path_text, ImGuiInputTextFlags_EnterReturnsTrue)) {
    std::error_code error;
    const std::filesystem::path typed = browser.path_text;
    if (std::filesystem::is_regular_file(typed, error)) {
      browser.go_to(typed.parent_path());
      browser.name = typed.filename().string();
    } else {
      browser.go_to(typed);
    }
  }
}

/// The folder's listing; true when a file was double-clicked.
bool draw_listing(const UiContext& ui, float height) {
  FileBrowser& browser = ui.state.browser;
  bool opened = false;
  std::filesystem::path next;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.window);
  ImGui::BeginChild("listing", ImVec2(0, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  if (!browser.problem.empty()) hint(ui.theme, browser.problem);
  if (browser.problem.empty() && browser.entries.empty()) hint(ui.theme, "Nothing here that can be opened");
  for (const FileEntry& entry : browser.entries) {
    ImGui::PushID(entry.name.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##file", browser.name == entry.name && !entry.folder, ImGuiSelectableFlags_AllowDoubleClick)) {
      if (entry.folder) {
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) next = browser.folder / entry.name;
      } else {
        browser.name = entry.name;
        browser.confirm_overwrite = false;
        opened = opened || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      }
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const char* icon = entry.folder ? icons::folder : icons::file;
    if (ui.theme.has_icons) list.AddText(at, colour_u32(entry.folder ? ui.theme.accent : ui.theme.muted), icon);
    list.AddText(ImVec2(at.x + ui.theme.px(24), at.y), colour_u32(ui.theme.text), entry.name.c_str());
    const std::string size = entry.folder ? "" : format_bytes(entry.bytes);
    const float right = at.x + ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(size.c_str()).x;
    list.AddText(ImVec2(right, at.y), colour_u32(ui.theme.muted), size.c_str());
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (!next.empty()) browser.go_to(next);
  return opened;
}

/// Files opened lately, one click away.
std::string draw_recent(const UiContext& ui) {
  std::string chosen;
  if (ui.state.settings.recent.empty()) return chosen;
  ImGui::TextDisabled("Recent");
  std::size_t shown = 0;
  for (const std::string& file : ui.state.settings.recent) {
    if (++shown > most_shown_recent) break;
    ImGui::PushID(file.c_str());
    if (ImGui::Selectable(fitted_text(file, ImGui::GetContentRegionAvail().x).c_str())) chosen = file;
    ImGui::PopID();
  }
  return chosen;
}

void draw_open(const UiContext& ui) {
  EditorState& state = ui.state;
  const bool opening = state.dialogs.open_file && !ImGui::IsPopupOpen("Open a scene or a terrain");
  if (opening) start_browsing(state, false);
  if (!begin_modal(ui, "Open a scene or a terrain", state.dialogs.open_file, 640, 520)) return;
  const bool typing = ImGui::IsAnyItemActive();
  draw_path_row(ui);
  const auto rows = float(std::min<std::size_t>(state.settings.recent.size(), most_shown_recent) + 1);
  const float recent = rows > 1 ? rows * ImGui::GetTextLineHeightWithSpacing() + ui.theme.px(4) : 0;
  bool accepted = draw_listing(ui, ImGui::GetContentRegionAvail().y - recent - ui.theme.px(76));
  const std::string picked = draw_recent(ui);
  accepted = draw_file_name(ui, state.browser.name, typing) || accepted;
  align_buttons(ui.theme, 2, button_width);
  const bool cancelled = ImGui::Button("Cancel", ImVec2(ui.theme.px(button_width), 0));
  ImGui::SameLine();
  ImGui::BeginDisabled(state.browser.name.empty());
  accepted = primary_button(ui.theme, "Open", ui.theme.px(button_width)) || accepted;
  ImGui::EndDisabled();
  accepted = accepted && !state.browser.name.empty();
  if (accepted || cancelled || !picked.empty()) {
    state.dialogs.open_file = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (!picked.empty()) {
    open_or_import(state, picked);
  } else if (accepted) {
    state.settings.last_folder = state.browser.folder.string();
    open_or_import(state, (state.browser.folder / state.browser.name).string());
  }
}

void draw_save(const UiContext& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.save_file && !state.has_document) state.dialogs.save_file = false;
  const bool opening = state.dialogs.save_file && !ImGui::IsPopupOpen("Save the scene");
  if (opening) start_browsing(state, true);
  if (!begin_modal(ui, "Save the scene", state.dialogs.save_file, 600, 440)) {
    return;
  }
  const bool typing = ImGui::IsAnyItemActive();
  draw_path_row(ui);
  bool accepted = draw_listing(ui, ImGui::GetContentRegionAvail().y - ui.theme.px(100));
  accepted = draw_file_name(ui, state.browser.name, typing) || accepted;
  std::filesystem::path file = state.browser.folder / state.browser.name;
  if (file.extension() != ".biotope") file += ".biotope";
  if (state.browser.confirm_overwrite) {
    ImGui::TextColored(ui.theme.attention, "%s is there already. Save again to replace it.", file.filename().string().c_str());
  } else {
    ImGui::TextDisabled("Saved as %s", file.filename().string().c_str());
  }
  align_buttons(ui.theme, 2, button_width);
  const bool cancelled = ImGui::Button("Cancel", ImVec2(ui.theme.px(button_width), 0));
  ImGui::SameLine();
  ImGui::BeginDisabled(state.browser.name.empty());
  accepted = primary_button(ui.theme, "Save", ui.theme.px(button_width)) || accepted;
  ImGui::EndDisabled();
  accepted = accepted && !state.browser.name.empty();
  std::error_code error;
  if (accepted && !state.browser.confirm_overwrite && file != state.scene_file && std::filesystem::exists(file, error)) {
    state.browser.confirm_overwrite = true;
    accepted = false;
  }
  if (accepted || cancelled) {
    state.dialogs.save_file = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (cancelled) state.after_unsaved = {};
  if (!accepted) return;
  // What waited for the answer goes on once the scene is on the disk.
  state.after_saved = std::exchange(state.after_unsaved, {});
  save_as(state, file);
}

}  // namespace

void draw_file_dialogs(const UiContext& ui) {
  draw_open(ui);
  draw_save(ui);
}

}  // namespace biotope
