#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// A window over the views: the levels of the food chain with their species, what flows between them in a year, which are being
/// computed and what the last edit changed. A click selects a species.
void draw_food_chain(const UiContext& ui);

}  // namespace biotope
