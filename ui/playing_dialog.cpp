#include <imgui.h>

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

}  // namespace biotope
