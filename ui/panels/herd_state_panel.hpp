#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// What the chosen herd does at this hour, whether its needs are met, and the ways to it.
void draw_herd_state(const UiContext& ui, const DailyPlan& plan);

}  // namespace biotope
