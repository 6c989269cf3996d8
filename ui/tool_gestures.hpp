#pragma once

#include "ui/editor_state.hpp"

namespace biotope {

// What the left button does with the tool in the hand, alike on the map and in 3D: canvases tell where it went in cells.

/// Keys held when the button went down.
struct ToolKeys {
  bool control = false;
  bool shift = false;
  /// Of a tablet's pen, 0..1.
  float pressure = 1;
};

/// The button went down on a cell. Brushes begin a stroke (Shift: a straight line from the last point; Ctrl: pick the value, or
/// where 'clone' takes from), Fill fills, gradients and selections begin (Shift adds, Ctrl takes away, both intersect).
void press_tool(EditorState& state, PathPoint cell, ToolKeys keys);
/// It moved.
void drag_tool(EditorState& state, PathPoint cell, float pressure = 1);
/// It was let go.
void release_tool(EditorState& state);
/// Stops what is going on and leaves no trace of it.
void cancel_tool(EditorState& state);
/// True from press to release of a stroke or a gesture.
[[nodiscard]] bool tool_active(const EditorState& state);

/// Takes the value under the pointer for the brush.
void pick_value(EditorState& state, PathPoint cell);
/// Takes the paint off the layer that is looked at, where selection and filter let it, and says so.
void restore_here(EditorState& state);
/// Selects everything, nothing, or the inverse.
void select_shape(EditorState& state, SelectEdit::Shape shape);

}  // namespace biotope
