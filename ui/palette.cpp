#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <string>

#include "ui/dialogs.hpp"
#include "ui/icons.hpp"

namespace biotope {
namespace {

struct Gesture {
  const char* what;
  const char* does;
};
constexpr std::array<Gesture, 17> gestures{
    {{"Left", "paint with a brush; with Select: ask on the map, orbit in 3D"},
     {"Shift + left with a brush", "straight line from where the last stroke ended"},
     {"Ctrl + left with a brush", "take the value under the pointer; with Clone: clone from here"},
     {"Shift, Ctrl with a selection", "add to it, take from it; both: keep what is in both"},
     {"Right", "menu of what is under the pointer; drag to look around in 3D"},
     {"Middle, or Space + left", "move the map"},
     {"Left with Select, dragged", "move the map"},
     {"Wheel", "zoom at the pointer, come closer in 3D"},
     {"Alt + left", "ask why on the map, orbit in 3D"},
     {"W A S D over the 3D view", "fly, or walk on foot; with Shift faster"},
     {"Click an animal in 3D", "follow it; its herd's day and needs are shown"},
     {"Click a plant in 3D", "choose its species and ask why it is here"},
     {"Double-click in a list", "see the species, place or route in 3D"},
     {"The camera on map and mini-map", "drag it to another place"},
     {"Q E over the 3D view", "fly down and up"},
     {"Space over the clock", "play and pause the day"},
     {"Drop a file on the window", "open a scene or look at a terrain"}}};

void draw_entry(const UiContext& ui, const EditorCommand& command, bool lit, bool scroll, bool& chosen) {
  const bool usable = enabled(command, ui.state);
  ImGui::PushStyleColor(ImGuiCol_Text, usable ? ui.theme.text : ui.theme.muted);
  ImGui::PushID(command.id.c_str());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::Selectable("##entry", lit) && usable) chosen = true;
  if (lit && scroll) ImGui::SetScrollHereY();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
  if (ui.theme.has_icons) list.AddText(ImVec2(at.x + ui.theme.px(4), at.y), colour_u32(ui.theme.muted), command.icon);
  list.AddText(ImVec2(at.x + ui.theme.px(30), at.y), colour, command.name.c_str());
  const std::string keys = ui.commands.keys(command.id);
  const std::string right = keys.empty() ? command.menu : keys;
  const float x = at.x + ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(right.c_str()).x - ui.theme.px(4);
  list.AddText(ImVec2(x, at.y), colour_u32(ui.theme.muted), right.c_str());
  ImGui::PopID();
  ImGui::PopStyleColor();
}

}  // namespace

namespace {

/// Opens the palette's window in the upper middle; false when it is closed. `opening`: it was not open before.
bool begin_palette(const UiContext& ui, bool& opening) {
  EditorState& state = ui.state;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  opening = !ImGui::IsPopupOpen("palette");
  if (opening) {
    ImGui::OpenPopup("palette");
    state.palette_text.clear();
    state.palette_choice = 0;
  }
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y * 0.14F), ImGuiCond_Always, ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(
      ImVec2(std::min(ui.theme.px(520), screen.x - ui.theme.px(40)), std::min(ui.theme.px(380), screen.y * 0.7F)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(10), ui.theme.px(10)));
  const bool shown = ImGui::BeginPopup("palette");
  ImGui::PopStyleVar();
  return shown;
}

/// The commands that were found; returns the one that was clicked, or chosen with the arrows and Enter.
const EditorCommand* draw_found(const UiContext& ui, const std::vector<const EditorCommand*>& found) {
  EditorState& state = ui.state;
  const bool down = take_key(state, DialogKey::down);
  const bool up = take_key(state, DialogKey::up);
  if (down) ++state.palette_choice;
  if (up) --state.palette_choice;
  state.palette_choice = found.empty() ? 0 : std::clamp(state.palette_choice, 0, int(found.size()) - 1);
  const EditorCommand* wanted = nullptr;
  const bool enter = take_key(state, DialogKey::enter);
  ImGui::BeginChild("found");
  if (found.empty()) hint(ui.theme, "No command has these letters");
  for (int i = 0; i < int(found.size()); ++i) {
    const EditorCommand& command = *found[std::size_t(i)];
    bool chosen = false;
    draw_entry(ui, command, i == state.palette_choice, up || down, chosen);
    if (chosen || (i == state.palette_choice && enter)) wanted = &command;
  }
  ImGui::EndChild();
  return wanted;
}

}  // namespace

void draw_palette(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.palette) return;
  bool opening = false;
  if (!begin_palette(ui, opening)) {
    state.dialogs.palette = false;
    return;
  }
  if (opening) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##find", "Type what you want to do", &state.palette_text)) state.palette_choice = 0;
  const EditorCommand* const run_now = draw_found(ui, ui.commands.search(state.palette_text));
  if (run_now != nullptr || take_key(state, DialogKey::escape)) {
    state.dialogs.palette = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (run_now != nullptr) run(*run_now, state);
}

void draw_shortcut_list(const UiContext& ui) {
  if (!begin_modal(ui, "Keys and gestures", ui.state.dialogs.shortcuts, 640, 560)) return;
  ImGui::BeginChild("keys");
  if (ImGui::BeginTable("gestures", 2)) {
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthFixed, ui.theme.px(210));
    for (const Gesture& gesture : gestures) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(gesture.what);
      ImGui::TableNextColumn();
      ImGui::TextColored(ui.theme.muted, "%s", gesture.does);
    }
    ImGui::EndTable();
  }
  for (const std::string& menu : ui.commands.menus()) {
    heading(ui.theme, menu);
    if (!ImGui::BeginTable(menu.c_str(), 2)) continue;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, ui.theme.px(210));
    for (const EditorCommand& command : ui.commands.all()) {
      const std::string keys = ui.commands.keys(command.id);
      if (command.menu != menu || keys.empty()) continue;
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(keys.c_str());
      ImGui::TableNextColumn();
      ImGui::TextColored(ui.theme.muted, "%s", command.name.c_str());
    }
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::EndPopup();
}

namespace {

void close_first_steps(EditorState& state) {
  state.dialogs.first_steps = false;
  state.settings.first_steps_closed = true;
  // Written at once, so that it never comes back.
  if (const Status saved = save_settings(state.settings_file, state.settings); !saved) state.notice = saved.error().message;
}

}  // namespace

void draw_first_steps(const UiContext& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.first_steps) return;
  const Theme& theme = ui.theme;
  // In the corner of the views that holds neither legend nor north arrow.
  ImGui::SetNextWindowPos(ImVec2(theme.px(52), ImGui::GetFrameHeight() + theme.px(50)), ImGuiCond_Always);
  ImGui::SetNextWindowSize(ImVec2(theme.px(264), 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(12), theme.px(9)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(6), theme.px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, with_alpha(theme.panel, 0.92F));
  ImGui::Begin("first steps", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushFont(theme.bold);
  ImGui::TextUnformatted("Paint here, look there");
  ImGui::PopFont();
  ImGui::PushFont(theme.small);
  const std::array<std::string, 3> steps{
      "Choose a species on the right: its map shows where it lives.",
      "Press " + ui.commands.keys("tool.brush") + " and paint on the map: what eats it answers.",
      "Press play below: herds walk their day, here and in 3D."};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    ImGui::TextColored(theme.accent, "%d", int(i) + 1);
    ImGui::SameLine(theme.px(28));
    ImGui::TextWrapped("%s", steps[i].c_str());
  }
  align_buttons(theme, 1, 70);
  const bool closed = primary_button(theme, "Got it", theme.px(70));
  ImGui::PopFont();
  // Who has made some edits needs it no more, unless it was asked for.
  if (closed || (!state.settings.first_steps_closed && state.history.size() >= 3)) close_first_steps(state);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace biotope
