#include <imgui.h>
#include <imgui_stdlib.h>

#include <cstdlib>

#include "ui/dialogs.hpp"
#include "ui/file_request.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

constexpr float button_width = 110;

void draw_folder_row(const UiContext& ui, FileBrowser& browser) {
  if (ImGui::Button(ui.theme.has_icons ? icons::up : "Up")) browser.go_to(browser.folder.parent_path());
  tooltip(ui.theme, "The folder above");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::InputText("##path", &browser.path_text, ImGuiInputTextFlags_EnterReturnsTrue)) return;
  std::error_code error;
  const std::filesystem::path typed = browser.path_text;
  const bool file = std::filesystem::is_regular_file(typed, error);
  browser.go_to(file ? typed.parent_path() : typed);
  if (file) browser.name = typed.filename().string();
}

/// The folder's files; true when one was double-clicked.
bool draw_files(const UiContext& ui, FileBrowser& browser, float height) {
  bool opened = false;
  std::filesystem::path next;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.window);
  ImGui::BeginChild("files", ImVec2(0, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  if (!browser.problem.empty()) hint(ui.theme, browser.problem);
  if (browser.problem.empty() && browser.entries.empty()) hint(ui.theme, "Nothing here that fits");
  for (const FileEntry& entry : browser.entries) {
    const std::string icon = ui.theme.has_icons ? std::string(entry.folder ? icons::folder : icons::file) + "  " : std::string();
    ImGui::PushID(entry.name.c_str());
    if (ImGui::Selectable((icon + entry.name).c_str(), browser.name == entry.name && !entry.folder,
                          ImGuiSelectableFlags_AllowDoubleClick)) {
      const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      if (entry.folder && twice) next = browser.folder / entry.name;
      if (!entry.folder) {
        browser.name = entry.name;
        browser.confirm_overwrite = false;
        opened = opened || twice;
      }
    }
    if (!entry.folder) {
      const std::string size = format_bytes(entry.bytes);
      ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(size.c_str()).x);
      ImGui::TextDisabled("%s", size.c_str());
    }
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (!next.empty()) browser.go_to(next);
  return opened;
}

std::filesystem::path first_folder(const EditorState& state) {
  std::error_code error;
  if (!state.settings.last_folder.empty() && std::filesystem::is_directory(state.settings.last_folder, error)) {
    return state.settings.last_folder;
  }
  const char* home = std::getenv("HOME");
  return home != nullptr ? home : "/";
}

/// The file that is chosen, with an ending that fits.
std::filesystem::path chosen_file(const FileBrowser& browser, bool saving) {
  std::filesystem::path file = browser.folder / browser.name;
  if (saving && !file.has_extension() && !browser.endings.empty()) file += browser.endings.front();
  return file;
}

}  // namespace

void ask_for_file(EditorState& state, FileRequest request) {
  request.browser.go_to(first_folder(state));
  state.file_request = std::move(request);
}

void draw_file_request(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!state.file_request) return;
  FileRequest& request = *state.file_request;
  bool open = true;
  const bool shown = begin_modal(ui, (request.title + "###file request").c_str(), open, 600, 460);
  bool accepted = false;
  bool cancelled = !open;
  if (shown) {
    FileBrowser& browser = request.browser;
    const bool typing = ImGui::IsAnyItemActive();
    draw_folder_row(ui, browser);
    accepted = draw_files(ui, browser, ImGui::GetContentRegionAvail().y - ui.theme.px(100));
    accepted = draw_file_name(ui, browser.name, typing) || accepted;
    if (browser.confirm_overwrite) {
      ImGui::TextColored(ui.theme.attention, "This file is there already. %s again to replace it.", request.action.c_str());
    } else {
      ImGui::TextDisabled("%s", request.saving && browser.endings.size() > 1 ? "The ending says which kind of file" : " ");
    }
    align_buttons(ui.theme, 2, button_width);
    cancelled = ImGui::Button("Cancel", ImVec2(ui.theme.px(button_width), 0)) || cancelled;
    ImGui::SameLine();
    ImGui::BeginDisabled(browser.name.empty());
    accepted = primary_button(ui.theme, request.action.c_str(), ui.theme.px(button_width)) || accepted;
    ImGui::EndDisabled();
    accepted = accepted && !browser.name.empty();
    std::error_code error;
    if (accepted && request.saving && !browser.confirm_overwrite && std::filesystem::exists(chosen_file(browser, true), error)) {
      browser.confirm_overwrite = true;
      accepted = false;
    }
    if (accepted || cancelled) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  if (!accepted && !cancelled) return;
  const FileRequest done = std::move(*state.file_request);
  state.file_request.reset();
  if (!accepted) return;
  state.settings.last_folder = done.browser.folder.string();
  done.then(state, chosen_file(done.browser, done.saving));
}

}  // namespace biotope
