#include "ui/panels/views_window.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/panels/picture_size.hpp"

namespace biotope {
namespace {

const char* icon_or(const Theme& theme, const char* icon, const char* letter) { return theme.has_icons ? icon : letter; }

/// A row of the bookmarks: its name, which can be edited, and what can be done with it.
void draw_bookmark(const UiContext& ui, std::size_t index, int& deleted) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const Bookmark& bookmark = state.views.bookmarks[index];
  ImGui::PushID(int(index));
  const float buttons = theme.px(84);
  if (icon_button(theme, "go", icon_or(theme, icons::place, ">"), theme.accent,
                  "Fly there\n" + format_clock(bookmark.hour) + ", " + std::string(month_name(bookmark.month)))) {
    go_to_bookmark(state, index);
  }
  ImGui::SameLine(0, theme.px(4));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - buttons);
  std::string name = bookmark.name;
  ImGui::InputText("##name", &name);
  if (ImGui::IsItemEdited()) rename_bookmark(state, index, name);
  ImGui::SameLine(0, theme.px(6));
  if (icon_button(theme, "update", icon_or(theme, icons::refresh, "u"), theme.muted, "Take the view of now for it"))
    update_bookmark(state, index);
  ImGui::SameLine(0, theme.px(2));
  if (icon_button(theme, "delete", icon_or(theme, icons::trash, "x"), theme.muted, "Delete it")) deleted = int(index);
  ImGui::PopID();
}

void draw_bookmarks(const UiContext& ui) {
  EditorState& state = ui.state;
  heading(ui.theme, "Bookmarks");
  if (state.views.bookmarks.empty()) {
    hint(ui.theme, "Views to come back to, with their hour and month. They are saved with the scene.");
  }
  int deleted = -1;
  for (std::size_t i = 0; i < state.views.bookmarks.size(); ++i) draw_bookmark(ui, i, deleted);
  if (deleted >= 0) delete_bookmark(state, std::size_t(deleted));
  if (ImGui::Button("Bookmark this view", ImVec2(-1, 0))) add_bookmark(state);
  tooltip(ui.theme, "Where the camera is now, with hour and month", ui.commands.keys("explore.bookmark"));
}

void draw_key(const UiContext& ui, std::size_t index, int& deleted) {
  EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  const CameraKey& key = state.views.path.keys[index];
  ImGui::PushID(1000 + int(index));
  if (icon_button(theme, "go", icon_or(theme, icons::place, ">"), theme.accent, "Fly to this view")) fly_to(state, key.camera);
  ImGui::SameLine(0, theme.px(4));
  ImGui::AlignTextToFramePadding();
  ImGui::Text("View %d", int(index) + 1);
  ImGui::SameLine(theme.px(110));
  ImGui::SetNextItemWidth(theme.px(96));
  auto seconds = float(key.seconds);
  ImGui::BeginDisabled(index == 0);
  if (ImGui::DragFloat("##seconds", &seconds, 0.05F, 0, float(longest_path), "%.1f s")) {
    set_path_key_seconds(state, index, double(seconds));
  }
  ImGui::EndDisabled();
  tooltip(theme, "When the camera is here, from the beginning; drag, or double-click to type");
  ImGui::SameLine(ImGui::GetContentRegionMax().x - theme.px(56));
  if (icon_button(theme, "update", icon_or(theme, icons::refresh, "u"), theme.muted, "Take the view of now for it"))
    set_path_key_view(state, index);
  ImGui::SameLine(0, theme.px(2));
  if (icon_button(theme, "delete", icon_or(theme, icons::trash, "x"), theme.muted, "Take it out of the path"))
    deleted = int(index);
  ImGui::PopID();
}

/// Whether and from when to when the day passes along the path.
void draw_path_day(const UiContext& ui) {
  EditorState& state = ui.state;
  PictureSession& pictures = state.pictures;
  bool changed = ImGui::Checkbox("The day passes", &pictures.day_passes);
  tooltip(ui.theme, "Time-lapse: the clock runs from one hour to another along the path; herds walk, light moves");
  if (pictures.day_passes) {
    changed = labelled_slider(ui.theme, "From", pictures.hours[0], 0, 24, format_clock(double(pictures.hours[0]))) || changed;
    changed = labelled_slider(ui.theme, "To", pictures.hours[1], 0, 24, format_clock(double(pictures.hours[1]))) || changed;
  }
  if (changed) set_path_day(state);
}

void draw_path_output(const UiContext& ui) {
  EditorState& state = ui.state;
  PictureSession& pictures = state.pictures;
  draw_picture_size(ui);
  auto rate = float(pictures.frames_a_second);
  if (labelled_slider(ui.theme, "Pictures a second", rate, 1, 60, std::to_string(pictures.frames_a_second)))
    pictures.frames_a_second = std::clamp(int(std::lround(rate)), 1, 60);
  const int count = frame_count(state.views.path, pictures.frames_a_second);
  hint(ui.theme, format_value(path_seconds(state.views.path), "s") + ", " + format_count(count) + " pictures");
  const float half = (ImGui::GetContentRegionAvail().x - ui.theme.px(6)) / 2;
  ImGui::BeginDisabled(pictures.running);
  if (ImGui::Button("Pictures ...", ImVec2(half, 0))) ask_to_render_path(state);
  tooltip(ui.theme, "Draw the path into a folder, a PNG a picture");
  ImGui::SameLine(0, ui.theme.px(6));
  if (ImGui::Button("Video ...", ImVec2(half, 0))) ask_to_render_video(state);
  tooltip(ui.theme, "Draw the path into an MP4; needs ffmpeg");
  ImGui::EndDisabled();
}

void draw_path(const UiContext& ui) {
  EditorState& state = ui.state;
  heading(ui.theme, "Camera path");
  const bool whole = state.views.path.keys.size() >= 2;
  if (!whole) hint(ui.theme, "Add two or more views; the camera flies smoothly from one to the next.");
  int deleted = -1;
  for (std::size_t i = 0; i < state.views.path.keys.size(); ++i) draw_key(ui, i, deleted);
  if (deleted >= 0) delete_path_key(state, std::size_t(deleted));
  const float half = (ImGui::GetContentRegionAvail().x - ui.theme.px(6)) / 2;
  if (ImGui::Button("Add this view", ImVec2(half, 0))) add_path_key(state);
  tooltip(ui.theme, "The camera comes by here " + std::to_string(int(seconds_between_keys)) + " s after the last view",
          ui.commands.keys("explore.path_key"));
  ImGui::SameLine(0, ui.theme.px(6));
  ImGui::BeginDisabled(!whole);
  if (ImGui::Button(state.pictures.playing >= 0 ? "Stop" : "Play", ImVec2(half, 0))) play_path(state);
  ImGui::EndDisabled();
  tooltip(ui.theme, "Fly along the path", ui.commands.keys("explore.play_path"));
  if (whole) {
    draw_path_day(ui);
    draw_path_output(ui);
  }
  if (ImGui::SmallButton("Open ...")) ask_to_open_path(state);
  tooltip(ui.theme, "Read a path from a JSON file, in place of this one");
  ImGui::SameLine(0, ui.theme.px(6));
  ImGui::BeginDisabled(!whole);
  if (ImGui::SmallButton("Save ...")) ask_to_save_path(state);
  ImGui::EndDisabled();
  tooltip(ui.theme, "Write the path to a JSON file, for 'biotope render --path'");
  ImGui::SameLine(0, ui.theme.px(6));
  ImGui::BeginDisabled(state.views.path.keys.empty());
  if (ImGui::SmallButton("Clear")) clear_path(state);
  ImGui::EndDisabled();
}

}  // namespace

void draw_views_window(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.views || !state.has_document) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // As high as what is in it.
  ImGui::SetNextWindowSize(ImVec2(ui.theme.px(300), 0), ImGuiCond_Always);
  ImGui::SetNextWindowPos(ImVec2(ui.theme.px(60), screen.y * 0.12F), ImGuiCond_Appearing);
  ImGui::SetNextWindowSizeConstraints(ImVec2(ui.theme.px(280), ui.theme.px(160)), ImVec2(ui.theme.px(460), screen.y * 0.8F));
  ImGui::SetNextWindowBgAlpha(0.96F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(10), ui.theme.px(8)));
  if (ImGui::Begin("Bookmarks and path", &state.dialogs.views, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize)) {
    draw_bookmarks(ui);
    draw_path(ui);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void draw_export_card(const UiContext& ui) {
  PictureSession& pictures = ui.state.pictures;
  if (!pictures.running) return;
  const Theme& theme = ui.theme;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y - theme.px(120)), ImGuiCond_Always, ImVec2(0.5F, 1));
  ImGui::SetNextWindowSize(ImVec2(theme.px(340), 0));
  ImGui::SetNextWindowBgAlpha(0.94F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(12), theme.px(10)));
  ImGui::Begin("pictures", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  const float button = theme.px(64);
  readout(theme, pictures.stage, format_percent(pictures.fraction));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - button - theme.px(10);
  const float height = ImGui::GetFrameHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = at.y + height / 2 - theme.px(3);
  list.AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + width, top + theme.px(6)), colour_u32(theme.raised), theme.px(3));
  list.AddRectFilled(ImVec2(at.x, top), ImVec2(at.x + width * float(pictures.fraction), top + theme.px(6)),
                     colour_u32(theme.accent), theme.px(3));
  ImGui::SetCursorScreenPos(ImVec2(at.x + width + theme.px(10), at.y));
  if (ImGui::Button("Stop", ImVec2(button, 0))) pictures.wants_cancel = true;
  tooltip(theme, "Give up; pictures of a path that are whole stay");
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace biotope
