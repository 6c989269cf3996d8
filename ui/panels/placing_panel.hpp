#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// Buttons that draw rivers, lakes and inflows, and the list of those there are.
void draw_water_things(const UiContext& ui);
/// Buttons that place fords, exits, waypoints and trails, and the list of those there are.
void draw_way_things(const UiContext& ui);

}  // namespace biotope
