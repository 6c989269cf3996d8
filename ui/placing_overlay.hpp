#pragma once

#include <optional>

#include "ui/placing_session.hpp"
#include "ui/view_pen.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Draws rivers, lakes, trails, fords ... that a person placed, what is being drawn or moved, and the handles of the selected
/// thing. `pointer` is the place under the pointer.
void draw_placed(const UiContext& ui, const ViewPen& pen, const std::optional<PathPoint>& pointer);

/// Handles the mouse for placing over a view; true while it belongs to placing. `hovered`: over the view; `at`: the place under
/// the pointer. A drag belongs to the view it began on, also where the pointer leaves it or the ground.
bool handle_placing(const UiContext& ui, PlacingView view, const std::optional<PathPoint>& at, float reach, bool hovered);

}  // namespace biotope
