#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// Size of pictures to be made: the usual ones up to 8K, or one's own.
void draw_picture_size(const UiContext& ui);

}  // namespace biotope
