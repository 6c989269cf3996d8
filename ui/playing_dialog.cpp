#include <imgui.h>

#include <utility>

#include "ui/dialogs.hpp"
#include "ui/edit_player.hpp"
#include "ui/editor_actions.hpp"

namespace biotope {

void draw_playing(const UiContext& ui) {
  EditPlayer& player = ui.state.player;
  constexpr const char* title = "Playing edits";
  bool open = player.running();
  if (!begin_modal(ui, title, open, 420)) return;
  const std::string progress = std::to_string(player.done) + " of " + std::to_string(player.count);
  ImGui::TextUnformatted(player.name.c_str());
  ImGui::ProgressBar(player.count > 0 ? float(player.done) / float(player.count) : 0.0F, ImVec2(-1, 0),
                     player.count > 0 ? progress.c_str() : "Reading");
  ImGui::TextDisabled("Each edit is a step of the history and can be undone.");
  constexpr float width = 110;
  align_buttons(ui.theme, 1, width);
  const bool stopped = ImGui::Button("Stop", ImVec2(ui.theme.px(width), 0)) || !open;
  if (stopped) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (stopped) cancel_playing(ui.state);
}

void draw_unsaved_recording(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!begin_modal(ui, "Recorded edits", state.dialogs.unsaved_recording, 440)) return;
  ImGui::TextWrapped("The recorded edits are not saved as a script yet.");
  ImGui::Dummy(ImVec2(0, ui.theme.px(8)));
  constexpr float button = 110;
  const ImVec2 size(ui.theme.px(button), 0);
  align_buttons(ui.theme, 3, button);
  const bool cancelled = ImGui::Button("Cancel", size);
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.loss);
  const bool dropped = ImGui::Button("Drop them", size);
  ImGui::PopStyleColor();
  ImGui::SameLine();
  const bool saves = primary_button(ui.theme, "Save ...", size.x);
  if (cancelled || dropped || saves) {
    state.dialogs.unsaved_recording = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  const auto then = cancelled || dropped || saves ? std::exchange(state.player.after_recording, {}) : nullptr;
  if (dropped) {
    drop_recording(state);
    then(state);
  }
  if (saves) stop_and_save_recording(state);
}

}  // namespace biotope
