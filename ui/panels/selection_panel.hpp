#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// What is selected and what one can do with it; shown with the tools that select.
void draw_selection_panel(const UiContext& ui);

}  // namespace biotope
