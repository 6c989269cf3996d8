#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// Says in the lower left corner of the 3D view what moves the camera, and which key ends it: on foot, following a herd, on the
/// path.
void draw_mode_badge(const UiContext& ui, ImVec2 origin, ImVec2 size);

}  // namespace biotope
