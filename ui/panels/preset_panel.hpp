#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// The list of named brushes and a place to keep the one in the hand.
void draw_preset_choice(const UiContext& ui);

}  // namespace biotope
