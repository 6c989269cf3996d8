#include "ui/dialogs.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "core/terrain/synthetic.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/panels/views_window.hpp"
#include "ui/parts.hpp"
#include "ui/quality.hpp"

namespace biotope {
namespace {

constexpr float button_width = 110;

void draw_message(const UiContext& ui) {
  EditorState& state = ui.state;
  if (state.messages.empty()) return;
  bool open = true;
  const EditorMessage message = state.messages.front();
  if (!begin_modal(ui, (message.title + "###message").c_str(), open, 480)) return;
  wrapped(ui.theme.text, message.text);
  ImGui::Dummy(ImVec2(0, ui.theme.px(8)));
  align_buttons(ui.theme, 1, button_width);
  const bool closed = primary_button(ui.theme, "OK", ui.theme.px(button_width)) || take_key(state, DialogKey::enter) || !open;
  if (closed) {
    state.messages.erase(state.messages.begin());
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

/// Goes on with what waited for the answer.
void go_on(EditorState& state) {
  state.dialogs.unsaved = false;
  if (auto then = std::move(state.after_unsaved)) {
    state.after_unsaved = {};
    then(state);
  }
}

void draw_unsaved(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "Unsaved work", state.dialogs.unsaved, 440)) return;
  ImGui::TextWrapped("This landscape has changes that are not saved yet.");
  ImGui::Dummy(ImVec2(0, ui.theme.px(8)));
  align_buttons(ui.theme, 3, button_width);
  const float width = ui.theme.px(button_width);
  if (ImGui::Button("Cancel", ImVec2(width, 0))) {
    state.dialogs.unsaved = false;
    state.after_unsaved = {};
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.loss);
  if (ImGui::Button("Discard", ImVec2(width, 0))) {
    go_on(state);
    ImGui::CloseCurrentPopup();
  }
  ImGui::PopStyleColor();
  ImGui::SameLine();
  if (primary_button(ui.theme, "Save", width) || take_key(state, DialogKey::enter)) {
    if (state.scene_file.empty()) {
      // The file is named first; what waited runs after it has been written.
      state.dialogs.unsaved = false;
      state.dialogs.save_file = true;
    } else {
      // What waited goes on once the scene is on the disk.
      state.after_saved = std::exchange(state.after_unsaved, {});
      state.dialogs.unsaved = false;
      save(state);
    }
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void draw_recovery(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "Unsaved work was found", state.dialogs.recovery, 460)) return;
  ImGui::TextWrapped("The editor ended last time without saving. A copy of that work was kept. Open it?");
  ImGui::Dummy(ImVec2(0, ui.theme.px(8)));
  align_buttons(ui.theme, 2, button_width);
  const float width = ui.theme.px(button_width);
  if (ImGui::Button("Throw away", ImVec2(width, 0))) {
    std::error_code error;
    std::filesystem::remove(state.recovery_file, error);
    state.dialogs.recovery = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  if (primary_button(ui.theme, "Open it", width) || take_key(state, DialogKey::enter)) {
    open(state, state.recovery_file.string());
    state.dialogs.recovery = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void draw_about(const UiContext& ui) {
  if (!begin_modal(ui, "About Biotope", ui.state.dialogs.about, 460)) return;
  ImGui::PushFont(ui.theme.title);
  ImGui::TextUnformatted("Biotope");
  ImGui::PopFont();
  ImGui::TextWrapped(
      "An editor of living landscapes: from a terrain, a climate and a list of species it computes where every plant and animal "
      "settles, which trails they wear and where each herd is at every hour.");
  hint(ui.theme,
       "After 'Authoring Consistent Landscapes with Flora and Fauna' (Ecormier-Nocca, Cordonnier, Carrez, Moigne, Memari, Benes, "
       "Cani; ACM Transactions on Graphics, 2021). MIT licence.");
  ImGui::Dummy(ImVec2(0, ui.theme.px(6)));
  align_buttons(ui.theme, 1, button_width);
  if (primary_button(ui.theme, "Close", ui.theme.px(button_width))) {
    ui.state.dialogs.about = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

bool begin_modal(const UiContext& ui, const char* title, bool& open, float width, float height) {
  if (!open) return false;
  const Theme& theme = ui.theme;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float fitting_height = height > 0 ? std::min(theme.px(height), screen.y - theme.px(40)) : 0;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(std::min(theme.px(width), screen.x - theme.px(40)), fitting_height));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(16), theme.px(14)));
  ImGui::PushStyleColor(ImGuiCol_PopupBg, theme.panel);
  const bool shown = ImGui::BeginPopupModal(
      title, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (shown && take_key(ui.state, DialogKey::escape)) {
    open = false;
    ImGui::CloseCurrentPopup();
  }
  return shown;
}

bool draw_file_name(const UiContext& ui, std::string& name, bool typing) {
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##name", "File name", &name, ImGuiInputTextFlags_EnterReturnsTrue);
  return entered || (!typing && take_key(ui.state, DialogKey::enter));
}

void align_buttons(const Theme& theme, int count, float width) {
  const float all = float(count) * theme.px(width) + float(count - 1) * ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetCursorPosX(std::max(ImGui::GetContentRegionMax().x - all, ImGui::GetCursorPosX()));
}

void draw_sample_list(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "New from a sample", state.dialogs.samples, 520)) return;
  for (const SampleDescription& sample : sample_descriptions()) {
    ImGui::PushID(sample.name.c_str());
    const ImVec2 at = ImGui::GetCursorPos();
    const float height = ImGui::GetFontSize() * 2 + ui.theme.px(28);
    if (ImGui::Selectable("##sample", false, 0, ImVec2(0, height))) {
      state.dialogs.samples = false;
      open_asking(state, "sample:" + sample.name);
      ImGui::CloseCurrentPopup();
    }
    ImGui::SetCursorPos(ImVec2(at.x + ui.theme.px(8), at.y + ui.theme.px(4)));
    ImGui::BeginGroup();
    ImGui::PushFont(ui.theme.bold);
    ImGui::TextUnformatted(sample.title.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("%d x %d cells of %s", sample.cells, sample.cells, format_length(sample.cell_size).c_str());
    hint(ui.theme, sample.description);
    ImGui::EndGroup();
    ImGui::SetCursorPos(ImVec2(at.x, std::max(at.y + height + ui.theme.px(4), ImGui::GetCursorPosY())));
    ImGui::PopID();
  }
  ImGui::EndPopup();
}

void draw_settings_dialog(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "Settings", state.dialogs.settings, 420)) return;
  Settings& settings = state.settings;
  int theme = settings.dark ? 0 : 1;
  ImGui::TextDisabled("Theme");
  if (segmented(ui.theme, "theme", {"Dark", "Light"}, theme, ImGui::GetContentRegionAvail().x)) {
    settings.dark = theme == 0;
    state.theme_changed = true;
  }
  static constexpr float scales[] = {0, 1, 1.25F, 1.5F, 2};
  int chosen = 0;
  for (int i = 0; i < 5; ++i) {
    if (settings.scale == scales[i]) chosen = i;
  }
  ImGui::Dummy(ImVec2(0, ui.theme.px(4)));
  ImGui::TextDisabled("Size of text and controls");
  if (segmented(ui.theme, "scale", {"Screen's", "100 %", "125 %", "150 %", "200 %"}, chosen, ImGui::GetContentRegionAvail().x)) {
    settings.scale = scales[chosen];
    state.theme_changed = true;
  }
  ImGui::Dummy(ImVec2(0, ui.theme.px(4)));
  draw_quality_setting(ui);
  ImGui::Dummy(ImVec2(0, ui.theme.px(4)));
  auto undo_memory = float(settings.history_megabytes);
  if (labelled_slider(ui.theme, "Memory for undo", undo_memory, 128, 8192,
                      format_bytes(std::size_t(settings.history_megabytes) << 20))) {
    settings.history_megabytes = int(undo_memory);
  }
  hint(ui.theme,
       "Shortcuts can be changed in " + state.settings_file.string() + ", under \"shortcuts\": {\"tool.brush\": \"P\"}.");
  ImGui::Dummy(ImVec2(0, ui.theme.px(6)));
  align_buttons(ui.theme, 1, button_width);
  if (primary_button(ui.theme, "Close", ui.theme.px(button_width))) {
    state.dialogs.settings = false;
    if (const Status saved = save_settings(state.settings_file, settings); !saved) complain(state, "Settings", saved.error());
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void draw_dialogs(const UiContext& ui) {
  draw_first_steps(ui);
  // A message is read first; what else is open waits behind it.
  if (!ui.state.messages.empty()) {
    draw_message(ui);
    return;
  }
  draw_palette(ui);
  draw_file_dialogs(ui);
  draw_file_request(ui);
  draw_playing(ui);
  draw_unsaved_recording(ui);
  draw_select_range(ui);
  draw_image_import(ui);
  draw_shortcut_list(ui);
  draw_settings_dialog(ui);
  draw_picture_dialog(ui);
  draw_sample_list(ui);
  draw_about(ui);
  draw_recovery(ui);
  draw_unsaved(ui);
  // A question closed without an answer: what waited for it must not run after some later save.
  if (!ui.state.dialogs.unsaved && !ui.state.dialogs.save_file) ui.state.after_unsaved = {};
}

}  // namespace biotope
