#pragma once

#include "ui/widgets.hpp"

namespace biotope {

/// The layers of paint: eye, lock, back to computed, and a menu to copy, paste, mix, import and export. Compact: one line that
/// opens.
void draw_layers_panel(const UiContext& ui, bool compact);
/// Pixels the compact list wants: its line, or the open list up to a few rows.
[[nodiscard]] float layers_height(const UiContext& ui);

}  // namespace biotope
