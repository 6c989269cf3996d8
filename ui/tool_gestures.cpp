#include "ui/tool_gestures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/pipeline/edit_grounds.hpp"
#include "ui/edit_actions.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/layer_values.hpp"
#include "ui/paint_targets.hpp"

namespace biotope {
namespace {

/// Cells between points of a lasso.
constexpr float lasso_step = 0.75F;

SelectionMode selection_mode(ToolKeys keys) {
  if (keys.shift && keys.control) return SelectionMode::intersect;
  if (keys.shift) return SelectionMode::add;
  return keys.control ? SelectionMode::subtract : SelectionMode::replace;
}

bool hindered(EditorState& state) {
  const std::string waiting = pending_edit(state);
  const std::string hindrance = waiting.empty() ? paint_hindrance(state) : waiting + " is still being done";
  if (!hindrance.empty()) announce(state, hindrance);
  return !hindrance.empty();
}

/// The final value of a layer at a cell; NaN where it is not known.
float final_at(EditorState& state, const LayerId& layer, PathPoint at) {
  const int x = int(std::lround(at.x));
  const int y = int(std::lround(at.y));
  if (!state.shown || !state.document.terrain->height.contains(x, y)) return NAN;
  const auto computed = state.grounds.computed(*state.shown, layer);
  if (!computed) return NAN;
  const auto paint = active_paint(state.document, layer);
  return final_value(layer.kind, (*computed)(x, y), paint ? (*paint)(x, y) : Paint{});
}

FillEdit fill_edit(const EditorState& state) {
  Brush brush = brush_of_tool(state);
  // A fill takes each cell's value from the same place.
  brush.clone_offset = {};
  std::optional<LayerId> from;
  if (brush.mode == BrushMode::clone) from = state.paint.clone_from ? state.paint.clone_from : paint_target(state);
  return {edit_targets(state, brush), brush, from, std::nullopt};
}

void fill(EditorState& state) {
  if (hindered(state)) return;
  const FillEdit edit = fill_edit(state);
  show_layer(state, edit.targets.front().layer);
  ++state.paint.strokes;
  perform_edit(state, edit);
}

void finish_gradient(EditorState& state, const ToolGesture& gesture) {
  const PathPoint from = gesture.points.front();
  const PathPoint to = gesture.points.back();
  if (std::hypot(to.x - from.x, to.y - from.y) < 1 || hindered(state)) return;
  FillEdit edit = fill_edit(state);
  const LayerId layer = edit.targets.front().layer;
  edit.gradient = FillEdit::Gradient{from, to, state.paint.gradient_end.value_or(limits_of(state, layer).low)};
  show_layer(state, layer);
  perform_edit(state, edit);
}

void finish_selection(EditorState& state, ToolGesture gesture) {
  const auto [left, right] =
      std::minmax_element(gesture.points.begin(), gesture.points.end(), [](PathPoint a, PathPoint b) { return a.x < b.x; });
  const auto [top, bottom] =
      std::minmax_element(gesture.points.begin(), gesture.points.end(), [](PathPoint a, PathPoint b) { return a.y < b.y; });
  const bool clicked = right->x - left->x < 1 && bottom->y - top->y < 1;
  if (clicked) {
    // A click beside what is selected takes the selection away.
    if (gesture.mode == SelectionMode::replace && state.document.selection) select_shape(state, SelectEdit::Shape::everything);
    return;
  }
  SelectEdit edit;
  edit.shape = gesture.tool == Tool::select_lasso ? SelectEdit::Shape::lasso : SelectEdit::Shape::rectangle;
  edit.mode = gesture.mode;
  edit.points = std::move(gesture.points);
  if (edit.shape == SelectEdit::Shape::rectangle) edit.points = {edit.points.front(), edit.points.back()};
  perform_edit(state, edit);
}

void press_brush(EditorState& state, PathPoint cell, ToolKeys keys) {
  if (keys.control) {
    if (state.tool == Tool::clone) {
      state.paint.clone_at = cell;
      announce(state, "The next stroke clones from here");
    } else {
      pick_value(state, cell);
    }
    return;
  }
  const std::optional<PathPoint> from = keys.shift ? state.paint.last_point : std::nullopt;
  const PathPoint start = from.value_or(cell);
  begin_stroke(state, start.x, start.y, keys.pressure);
  if (from) continue_stroke(state, cell.x, cell.y, keys.pressure);
}

}  // namespace

bool tool_active(const EditorState& state) { return state.painting.stroking() || state.gesture.has_value(); }

void press_tool(EditorState& state, PathPoint cell, ToolKeys keys) {
  if (is_brush(state.tool)) {
    press_brush(state, cell, keys);
  } else if (state.tool == Tool::fill) {
    if (keys.control) {
      pick_value(state, cell);
    } else {
      fill(state);
    }
  } else if (state.tool == Tool::gradient || is_selecting(state.tool)) {
    state.gesture = ToolGesture{state.tool, selection_mode(keys), {cell, cell}};
  }
}

void drag_tool(EditorState& state, PathPoint cell, float pressure) {
  if (state.painting.stroking()) {
    continue_stroke(state, cell.x, cell.y, pressure);
  } else if (state.gesture && state.gesture->tool == Tool::select_lasso) {
    const PathPoint last = state.gesture->points.back();
    if (std::hypot(cell.x - last.x, cell.y - last.y) >= lasso_step) state.gesture->points.push_back(cell);
  } else if (state.gesture) {
    state.gesture->points.back() = cell;
  }
}

void release_tool(EditorState& state) {
  if (state.painting.stroking()) {
    end_stroke(state);
    return;
  }
  if (!state.gesture) return;
  ToolGesture gesture = std::move(*state.gesture);
  state.gesture.reset();
  if (gesture.tool == Tool::gradient) {
    finish_gradient(state, gesture);
  } else {
    finish_selection(state, std::move(gesture));
  }
}

void cancel_tool(EditorState& state) {
  state.gesture.reset();
  if (!state.painting.stroking()) return;
  const FinishedStroke stroke = state.painting.finish(state.document);
  if (stroke.command) stroke.command->revert(state.document);
  state.painting.follow(state.document);
  state.must_post = true;
}

void pick_value(EditorState& state, PathPoint cell) {
  const std::optional<LayerId> layer = paint_target(state);
  if (!layer) return;
  const float value = final_at(state, *layer, cell);
  if (!std::isfinite(value)) {
    announce(state, "The value here is not known yet");
    return;
  }
  choose_value(state, *layer, ValueUse::reach, value);
  // Of a ground one takes the height to set it elsewhere.
  if (layer->kind == LayerKind::ground && state.tool != Tool::fill) state.tool = Tool::set;
  const std::string text = layer->kind == LayerKind::geology
                               ? geology_names()[std::size_t(std::clamp(int(value), 0, geology_classes - 1))]
                               : format_value(value, limits_of(state, *layer).unit);
  announce(state, "The brush now holds " + text);
}

void restore_here(EditorState& state) {
  const std::optional<LayerId> layer = paint_target(state);
  const Tool before = std::exchange(state.tool, Tool::fill);
  const BrushMode mode = std::exchange(state.paint.fill_mode, BrushMode::restore_computed);
  const float strength = std::exchange(state.paint.fill_strength, 1.0F);
  const std::uint64_t edits = state.edits;
  const std::uint64_t strokes = state.paint.strokes;
  fill(state);
  state.tool = before;
  state.paint.fill_mode = mode;
  state.paint.fill_strength = strength;
  const bool asked = state.paint.strokes != strokes;
  if (!asked || !layer || (state.edits == edits && state.pending.waiting.empty())) return;
  const bool everywhere = !state.document.selection && state.brush.filter.conditions.empty();
  announce(state, (everywhere ? "All paint of " : "The paint here of ") + layer_title(*layer, state.web()) +
                      " was taken off. Ctrl+Z takes it back");
}

void select_shape(EditorState& state, SelectEdit::Shape shape) {
  SelectEdit edit;
  edit.shape = shape;
  perform_edit(state, edit);
}

}  // namespace biotope
