#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// Hardness, falloff, spacing and stamp: a section that opens.
void draw_shape_section(const UiContext& ui);

}  // namespace biotope
