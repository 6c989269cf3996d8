#include <algorithm>

#include "ui/commands.hpp"
#include "ui/editor_actions.hpp"
#include "ui/exploring_commands.hpp"
#include "ui/icons.hpp"
#include "ui/painting_commands.hpp"
#include "ui/recording_commands.hpp"

namespace biotope {
namespace {

EditorCommand& with_line(EditorCommand& command) {
  command.line_before = true;
  return command;
}

void add_file(std::vector<EditorCommand>& list) {
  list.push_back(editor_command("file.samples", "File", "New from a sample ...", "Ctrl+N",
                                "Start from one of the built-in landscapes", icons::file,
                                [](EditorState& s) { s.dialogs.samples = true; }));
  list.push_back(editor_command("file.open", "File", "Open ...", "Ctrl+O", "Open a scene or a terrain", icons::open,
                                [](EditorState& s) { s.dialogs.open_file = true; }));
  list.push_back(editor_command("file.import", "File", "Import DEM ...", "Ctrl+I",
                                "Look at a terrain file before it replaces the landscape", icons::import_,
                                [](EditorState& s) { s.dialogs.open_file = true; }));
  list.push_back(editor_command("file.save", "File", "Save", "Ctrl+S", "Save the scene", icons::save, save));
  with_line(list.back()).enabled = has_document;
  list.push_back(editor_command("file.save_as", "File", "Save as ...", "Ctrl+Shift+S", "Save the scene under another name",
                                icons::save, [](EditorState& s) { s.dialogs.save_file = true; }));
  list.back().enabled = has_document;
  add_recording_commands(list);
  list.push_back(editor_command("file.screenshot", "File", "Screenshot", "F12",
                                "Write the window to a PNG in your pictures folder", icons::camera,
                                [](EditorState& s) { s.wants_screenshot = true; }));
  with_line(list.back());
  add_picture_commands(list);
  list.push_back(editor_command("file.quit", "File", "Quit", "Ctrl+Q", "Close the editor", icons::close,
                                [](EditorState& s) { s.wants_close = true; }));
  with_line(list.back());
}

void add_edit(std::vector<EditorCommand>& list) {
  list.push_back(editor_command("edit.undo", "Edit", "Undo", "Ctrl+Z", "Take back the last step", icons::undo, undo));
  list.back().enabled = [](const EditorState& s) { return s.history.can_undo(); };
  list.back().repeats = true;
  list.push_back(editor_command("edit.redo", "Edit", "Redo", "Ctrl+Shift+Z", "Do again what was taken back", icons::redo, redo));
  list.back().enabled = [](const EditorState& s) { return s.history.can_redo(); };
  list.back().repeats = true;
}

void add_brush(std::vector<EditorCommand>& list) {
  struct BrushRow {
    const char* id;
    const char* name;
    const char* keys;
    const char* tooltip;
    float Brush::*value;
    float factor, least, most;
  };
  for (const BrushRow& row :
       {BrushRow{"brush.smaller", "Smaller brush", "[", "Shrink the brush", &Brush::radius, 1 / 1.15F, 1, 1000},
        BrushRow{"brush.larger", "Larger brush", "]", "Grow the brush", &Brush::radius, 1.15F, 1, 1000},
        BrushRow{"brush.weaker", "Weaker brush", "Shift+[", "Paint more gently", &Brush::strength, 1 / 1.2F, 0.01F, 1},
        BrushRow{"brush.stronger", "Stronger brush", "Shift+]", "Paint more strongly", &Brush::strength, 1.2F, 0.01F, 1}}) {
    list.push_back(editor_command(row.id, "Edit", row.name, row.keys, row.tooltip, "", [row](EditorState& s) {
      s.brush.*row.value = std::clamp(s.brush.*row.value * row.factor, row.least, row.most);
    }));
    list.back().repeats = true;
    list.back().line_before = row.value == &Brush::radius && row.factor < 1;
  }
}

void add_switch(std::vector<EditorCommand>& list, const char* id, const char* name, const char* keys, const char* tooltip,
                bool EditorView::*member) {
  list.push_back(
      editor_command(id, "View", name, keys, tooltip, "", [member](EditorState& s) { s.view.*member = !(s.view.*member); }));
  list.back().checked = [member](const EditorState& s) { return s.view.*member; };
}

void add_view(std::vector<EditorCommand>& list) {
  struct ModeRow {
    const char* id;
    const char* name;
    const char* icon;
    ViewMode mode;
  };
  list.push_back(editor_command("view.next", "View", "Swap map / 3D / both", "Tab", "Go to the next arrangement of the two views",
                                icons::columns, [](EditorState& s) { s.view.mode = ViewMode((int(s.view.mode) + 1) % 3); }));
  for (const ModeRow& row : {ModeRow{"view.map", "Map", icons::map, ViewMode::map},
                             ModeRow{"view.landscape", "3D view", icons::cube, ViewMode::landscape},
                             ModeRow{"view.split", "Map and 3D view", icons::columns, ViewMode::split}}) {
    list.push_back(editor_command(row.id, "View", row.name, "", std::string("Show: ") + row.name, row.icon,
                                  [mode = row.mode](EditorState& s) { s.view.mode = mode; }));
    list.back().checked = [mode = row.mode](const EditorState& s) { return s.view.mode == mode; };
  }
  list.push_back(editor_command("view.frame", "View", "Frame the landscape", "F",
                                "Fit the whole map, and look at all of it in 3D", icons::frame, [](EditorState& s) {
                                  s.view.framed = false;
                                  s.view.camera_placed = false;
                                  s.exploring = {};
                                  s.view.camera_untouched = false;
                                }));
  with_line(list.back()).enabled = has_document;
  add_switch(list, "view.water", "Water", "", "Show rivers and lakes", &EditorView::water);
  with_line(list.back());
  add_switch(list, "view.contours", "Contour lines", "", "Show lines of equal height on the map", &EditorView::contours);
  add_switch(list, "view.trails", "Trails", "", "Show worn trails", &EditorView::trails);
  add_switch(list, "view.herds", "Herds", "", "Show herds where they are at this hour", &EditorView::herds);
  add_switch(list, "view.plants", "Plants in 3D", "", "Show plants in the 3D view", &EditorView::plants);
  add_switch(list, "view.hatch", "Hatch what is painted", "", "Mark where the map has been painted", &EditorView::hatch);
  add_switch(list, "view.iso_lines", "Iso-lines of the map", "I", "Draw lines of equal value of the map over the terrain",
             &EditorView::iso_lines);
  add_switch(list, "view.drape", "Map over the 3D view", "Shift+O", "Lay the map that you look at over the 3D view",
             &EditorView::drape);
  add_switch(list, "view.drape_painting", "Map over the 3D view while painting", "",
             "Lay the map that you paint over the 3D view as long as a brush is in the hand", &EditorView::drape_while_painting);
  add_switch(list, "view.food_chain", "Food chain", "F4",
             "Levels, species, what flows between them, and what the last edit changed", &EditorView::food_chain);
  for (int tab = 0; tab < tab_count; ++tab) {
    list.push_back(editor_command("tab." + std::to_string(tab + 1), "View", std::string(tab_title(Tab(tab))),
                                  std::to_string(tab + 1), std::string("Go to the tab ") + std::string(tab_title(Tab(tab))), "",
                                  [tab](EditorState& s) { s.view.tab = Tab(tab); }));
    list.back().checked = [tab](const EditorState& s) { return int(s.view.tab) == tab; };
    list.back().line_before = tab == 0;
  }
}

void add_simulation(std::vector<EditorCommand>& list) {
  list.push_back(editor_command("simulation.play", "Simulation", "Play / pause the day", "",
                                "Let the clock run: herds walk, light moves", icons::play,
                                [](EditorState& s) { s.clock.playing = !s.clock.playing; }));
  list.back().checked = [](const EditorState& s) { return s.clock.playing; };
  list.push_back(editor_command("simulation.scratch", "Simulation", "Compute everything again", "F5",
                                "Forget what was computed and start over", icons::refresh, recompute_from_scratch));
  with_line(list.back()).enabled = has_document;
  list.push_back(editor_command("simulation.cancel", "Simulation", "Stop computing", "Esc", "Stop; the last maps stay",
                                icons::close, cancel_work));
  list.back().enabled = [](const EditorState& s) { return s.loading.running() || (s.worker && s.worker->progress().busy); };
}

void add_window(std::vector<EditorCommand>& list) {
  list.push_back(editor_command("window.full_screen", "Window", "Full screen", "F11", "Fill the screen, or give it back",
                                icons::expand, [](EditorState& s) { s.wants_full_screen = true; }));
  list.push_back(editor_command("window.theme", "Window", "Light theme", "", "Swap the dark and the light theme", icons::theme,
                                [](EditorState& s) {
                                  s.settings.dark = !s.settings.dark;
                                  s.theme_changed = true;
                                }));
  list.back().checked = [](const EditorState& s) { return !s.settings.dark; };
  list.push_back(editor_command("window.settings", "Window", "Settings ...", "Ctrl+,", "Theme, scale and quality",
                                icons::settings, [](EditorState& s) { s.dialogs.settings = true; }));
  list.push_back(editor_command("help.palette", "Help", "Find a command ...", "Ctrl+K",
                                "Type a few letters of what you want to do", icons::search,
                                [](EditorState& s) { s.dialogs.palette = true; }));
  list.push_back(editor_command("help.shortcuts", "Help", "Keys and gestures", "F1", "Every shortcut, and what the mouse does",
                                icons::keyboard, [](EditorState& s) { s.dialogs.shortcuts = true; }));
  list.push_back(editor_command("help.first_steps", "Help", "First steps", "", "Show the card with the first three steps",
                                icons::info, [](EditorState& s) { s.dialogs.first_steps = true; }));
  list.push_back(editor_command("help.about", "Help", "About Biotope", "", "What this is and which version", icons::question,
                                [](EditorState& s) { s.dialogs.about = true; }));
}

}  // namespace

std::vector<EditorCommand> editor_commands() {
  std::vector<EditorCommand> list;
  add_file(list);
  add_edit(list);
  add_painting_commands(list);
  add_brush(list);
  add_view(list);
  add_exploring_commands(list);
  add_simulation(list);
  add_window(list);
  return list;
}

}  // namespace biotope
