#pragma once

#include "ui/placing_overlay.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// The chosen herd's day: its stops with their hours on a bar of the day, to be dragged, reordered, added and removed.
void draw_herd_panel(const UiContext& ui);
/// Its way and numbered stops over a view.
void draw_herd_day(const UiContext& ui, const ViewPen& pen);

}  // namespace biotope
