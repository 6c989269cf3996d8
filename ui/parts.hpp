#pragma once

#include "ui/widgets.hpp"

namespace biotope {

// The parts of the window around the views; each draws into the current Dear ImGui window unless it says otherwise.

/// The menu bar of the main viewport; returns its height.
float draw_menu_bar(const UiContext& ui);
/// Tools as a column of icons.
void draw_toolbar(const UiContext& ui);
/// Tabs, the list of the tab's maps and what is shown over them, with the thin line of progress beneath.
void draw_tab_bar(const UiContext& ui, ImVec2 size);
/// Clock: play, the day's curve with the sun and the herds' activity, speed, month.
void draw_clock_bar(const UiContext& ui, ImVec2 size);
/// Coordinates and values under the pointer, what is computing, undo memory.
void draw_status_bar(const UiContext& ui, ImVec2 size);
/// The right side: what the tab and the selection are about.
void draw_inspector(const UiContext& ui);

/// Windows over the editor: palette, files, import, settings, messages, questions, first steps.
void draw_dialogs(const UiContext& ui);
/// Runs the command of a key press. `landscape_letters`: W A S D Q E fly the camera now.
void handle_shortcuts(const UiContext& ui, bool landscape_letters);

}  // namespace biotope
