#include "ui/placing_commands.hpp"

#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/icons.hpp"
#include "ui/layer_actions.hpp"
#include "ui/placing_actions.hpp"

namespace biotope {
namespace {

struct PlacingRow {
  const char* id;
  const char* name;
  const char* tooltip;
  PlacingTool tool;
  Tab tab;
};

constexpr PlacingRow placing_rows[] = {
    {"place.river", "Draw a river", "Click along its course, from its head downstream", PlacingTool::river, Tab::terrain},
    {"place.lake", "Draw a lake", "Click around its shore", PlacingTool::lake, Tab::terrain},
    {"place.inflow", "Place an inflow", "Click where a river enters the map", PlacingTool::inflow, Tab::terrain},
    {"place.bend", "Bend a trail", "Press on a trail and pull it where it should go", PlacingTool::bend_trail, Tab::trails},
    {"place.pin", "Pin a trail", "Click along a trail that must be there", PlacingTool::pin_trail, Tab::trails},
    {"place.forbid", "Forbid a trail", "Click along ground where no trail may be", PlacingTool::forbid_trail, Tab::trails},
    {"place.ford", "Place a ford", "Click where animals may cross deep water", PlacingTool::ford, Tab::trails},
    {"place.exit", "Place an exit", "Click where animals come in and leave", PlacingTool::exit, Tab::trails},
    {"place.waypoint", "Place a waypoint", "Click a place that herds come by", PlacingTool::waypoint, Tab::trails}};

bool target_is_painted(const EditorState& state) {
  const auto target = paint_target(state);
  return state.has_document && target && state.document.layers.contains(*target);
}

void select_paint(EditorState& state) {
  const auto target = paint_target(state);
  if (!target) return;
  SelectEdit edit;
  edit.shape = SelectEdit::Shape::painted;
  edit.range.map = *target;
  perform_edit(state, edit);
}

}  // namespace

void add_placing_commands(std::vector<EditorCommand>& list) {
  for (const PlacingRow& row : placing_rows) {
    list.push_back(landscape_command(row.id, "", row.name, "", row.tooltip, "", [row](EditorState& state) {
      state.view.tab = row.tab;
      if (state.placing.tool != row.tool) choose_placing(state, row.tool);
    }));
    list.back().checked = [row](const EditorState& state) { return state.placing.tool == row.tool; };
  }
}

void add_paint_copy_commands(std::vector<EditorCommand>& list) {
  list.push_back(landscape_command("paint.copy", "Edit", "Copy the paint", "Ctrl+C",
                                   "Copy the paint of the map that you look at; it survives opening another scene", icons::copy,
                                   [](EditorState& state) {
                                     if (const auto target = paint_target(state)) copy_layer(state, *target);
                                   }));
  list.back().enabled = target_is_painted;
  list.back().line_before = true;
  list.push_back(landscape_command("paint.paste", "Edit", "Paste the paint", "Ctrl+V",
                                   "Lay the copied paint over the paint of the map that you look at", icons::paste,
                                   [](EditorState& state) {
                                     if (const auto target = paint_target(state)) paste_layer(state, *target, LayerMix::over);
                                   }));
  list.back().enabled = [](const EditorState& state) { return state.has_document && state.copied && paint_target(state); };
  list.push_back(landscape_command("select.painted", "Edit", "Select what is painted", "",
                                   "Select where the map that you look at is painted, as far as the paint covers", icons::brush,
                                   select_paint));
  list.back().enabled = target_is_painted;
}

void add_preset_commands(std::vector<EditorCommand>& list) {
  list.push_back(landscape_command("brush.presets", "Edit", "Brushes ...", "Shift+B", "Brushes to start from, and your own",
                                   icons::brush, [](EditorState& state) {
                                     if (!is_brush(state.tool)) state.tool = Tool::add;
                                     state.paint.wants_presets = true;
                                   }));
  const auto& built_in = built_in_presets();
  for (std::size_t i = 0; i < built_in.size(); ++i) {
    list.push_back(landscape_command("brush.preset." + std::to_string(i + 1), "", "Brush: " + built_in[i].name, "",
                                     "Take this brush into the hand", icons::brush,
                                     [i](EditorState& state) { use_preset(state, built_in_presets()[i]); }));
  }
}

}  // namespace biotope
