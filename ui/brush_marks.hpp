#pragma once

#include <optional>

#include "ui/view_pen.hpp"

namespace biotope {

struct EditorState;

/// Where 'clone' takes its values from while the pointer is at a cell; nothing with another tool.
[[nodiscard]] std::optional<PathPoint> clone_source(const EditorState& state, PathPoint pointer);

/// What goes with a brush besides its ring, over any view: the straight line that Shift draws and the place a clone comes from.
void draw_brush_marks(ImDrawList& list, const Theme& theme, const EditorState& state, const ViewPen& pen, PathPoint pointer);

}  // namespace biotope
