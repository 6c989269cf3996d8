#include "ui/painting_commands.hpp"

#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/icons.hpp"
#include "ui/locking_commands.hpp"
#include "ui/paint_targets.hpp"
#include "ui/placing_actions.hpp"
#include "ui/placing_commands.hpp"
#include "ui/tool_gestures.hpp"

namespace biotope {
namespace {

struct ToolRow {
  const char* id;
  const char* name;
  const char* keys;
  const char* tooltip;
  const char* icon;
  Tool tool;
};

constexpr ToolRow tools[] = {
    {"tool.select", "Select", "V", "Click to ask why the selected species is, or is not, here; drag to move the map",
     icons::pointer, Tool::select},
    {"tool.brush", "Paint", "B", "Paint more of what you look at; raise the ground in the Terrain tab", icons::brush, Tool::add},
    {"tool.set", "Paint a value", "T", "Paint one value, from above and from below", icons::set_value, Tool::set},
    {"tool.erase", "Erase", "E", "Paint less of what you look at; lower the ground in the Terrain tab", icons::eraser,
     Tool::erase},
    {"tool.restore", "Restore computed", "R", "Give the computed map back under the brush", icons::restore, Tool::restore},
    {"tool.smooth", "Smooth", "S", "Even out what is under the brush", icons::smooth, Tool::smooth},
    {"tool.sharpen", "Sharpen edges", "Shift+S", "Push values away from their surroundings", icons::sharpen, Tool::sharpen},
    {"tool.noise", "Noise", "N", "Roughen with patches of the size you choose", icons::noise, Tool::noise},
    {"tool.clone", "Clone", "C", "Copy from elsewhere or from another map; Ctrl+click says where from", icons::clone,
     Tool::clone},
    {"tool.raise", "Raise the ground", "U", "Heap the ground up", icons::raise, Tool::raise},
    {"tool.lower", "Lower the ground", "J", "Dig the ground down", icons::lower, Tool::lower},
    {"tool.flatten", "Flatten the ground", "H", "Bring the ground to the height where the stroke begins", icons::flatten,
     Tool::flatten},
    {"tool.carve", "Carve a trench", "Shift+J", "Cut a trench of one depth along the stroke", icons::carve, Tool::carve},
    {"tool.fill", "Fill", "G", "Click to fill what is selected, or what the filter lets through, or everything", icons::bucket,
     Tool::fill},
    {"tool.gradient", "Gradient", "Shift+G", "Drag a line: values change along it", icons::gradient, Tool::gradient},
    {"tool.select_rectangle", "Select a rectangle", "M", "Drag; Shift adds, Ctrl takes away, both keep what is in both",
     icons::rectangle, Tool::select_rectangle},
    {"tool.select_lasso", "Select with a lasso", "L", "Draw around; Shift adds, Ctrl takes away, both keep what is in both",
     icons::lasso, Tool::select_lasso},
};

void add_tools(std::vector<EditorCommand>& list) {
  for (const ToolRow& row : tools) {
    EditorCommand made =
        editor_command(row.id, "Tools", row.name, row.keys, row.tooltip, row.icon, [tool = row.tool](EditorState& state) {
          cancel_tool(state);
          state.tool = tool;
        });
    made.checked = [tool = row.tool](const EditorState& state) { return state.tool == tool; };
    made.line_before =
        row.tool == Tool::add || row.tool == Tool::raise || row.tool == Tool::fill || row.tool == Tool::select_rectangle;
    list.push_back(std::move(made));
  }
}

void add_selection(std::vector<EditorCommand>& list) {
  list.push_back(landscape_command("select.all", "Edit", "Select everything", "Ctrl+A", "Edits act everywhere", icons::rectangle,
                                   [](EditorState& state) { select_shape(state, SelectEdit::Shape::everything); }));
  list.back().line_before = true;
  list.push_back(landscape_command("select.drop", "Edit", "Deselect", "Ctrl+Shift+A",
                                   "Drop the selection: edits act everywhere again", icons::close,
                                   [](EditorState& state) { select_shape(state, SelectEdit::Shape::everything); }));
  list.back().enabled = [](const EditorState& state) { return state.document.selection != nullptr; };
  list.push_back(landscape_command("select.none", "Edit", "Select nothing", "", "Start an empty selection to add to",
                                   icons::close, [](EditorState& state) { select_shape(state, SelectEdit::Shape::nothing); }));
  list.push_back(landscape_command("select.invert", "Edit", "Invert the selection", "Ctrl+Shift+I", "Select what is not selected",
                                   icons::invert, [](EditorState& state) { select_shape(state, SelectEdit::Shape::inverse); }));
  list.push_back(landscape_command("select.range", "Edit", "Select by value ...", "",
                                   "Select where a map, the slope or the height lies between two values", icons::filter,
                                   [](EditorState& state) { state.dialogs.select_range = true; }));
}

/// Delete: the placed thing that is selected, else the paint within selection and filter.
void remove_here(EditorState& state) {
  if (removes_thing(state)) {
    remove_selected(state);
  } else {
    restore_here(state);
  }
}

void add_layer_commands(std::vector<EditorCommand>& list) {
  list.push_back(landscape_command("paint.fill", "Edit", "Fill now", "Shift+Enter",
                                   "Fill what is selected with the brush's value", icons::bucket, [](EditorState& state) {
                                     const Tool before = std::exchange(state.tool, Tool::fill);
                                     press_tool(state, {}, {});
                                     state.tool = before;
                                   }));
  list.back().line_before = true;
  list.push_back(landscape_command("paint.restore", "Edit", "Take the paint off here", "Delete",
                                   "Give the computed map back where something is selected, or everywhere; with a placed thing "
                                   "selected, remove that",
                                   icons::restore, remove_here));
  list.push_back(landscape_command("brush.show_filter", "Edit", "Show where the brush may act", "Shift+F",
                                   "Red film where the filter or the selection keep it away", icons::filter,
                                   [](EditorState& state) { state.paint.show_filter = !state.paint.show_filter; }));
  list.back().checked = [](const EditorState& state) { return state.paint.show_filter; };
}

}  // namespace

void add_painting_commands(std::vector<EditorCommand>& list) {
  add_selection(list);
  add_locking_commands(list);
  add_layer_commands(list);
  add_paint_copy_commands(list);
  add_preset_commands(list);
  add_tools(list);
  add_placing_commands(list);
}

}  // namespace biotope
