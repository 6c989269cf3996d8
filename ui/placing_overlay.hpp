#pragma once

#include <functional>
#include <optional>

#include "ui/widgets.hpp"

namespace biotope {

/// Where a place in cells is on the screen; nothing when it is out of sight.
using ProjectCell = std::function<std::optional<ImVec2>(PathPoint)>;

/// Draws rivers, lakes, trails, fords ... that a person placed, what is being drawn or moved, and the handles of the selected
/// thing. `pixels_per_metre` scales the radii of fords and the like; `pointer` is the place under the pointer.
void draw_placed(const UiContext& ui, const ProjectCell& project, double pixels_per_metre,
                 const std::optional<PathPoint>& pointer);

/// Handles the mouse for placing over a view; true while it belongs to placing. `hovered`: over the view; `at`: the place under
/// the pointer.
bool handle_placing(const UiContext& ui, const std::optional<PathPoint>& at, float reach, bool hovered);

}  // namespace biotope
