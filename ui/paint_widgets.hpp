#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/document/brush.hpp"
#include "ui/widgets.hpp"

namespace biotope {

// Controls that panels about painting share.

/// A title that opens and closes what follows; true while it is open. `note` stands at the right in grey.
bool section(const Theme& theme, const char* title, const std::string& note, bool open_at_first);

/// A slider with two ends between `least` and `most`; true while it changes. With `wraps` low may lie above high: the range then
/// goes around. The ramps of `softness` are drawn.
bool range_slider(const Theme& theme, const char* id, float& low, float& high, float least, float most, float softness,
                  bool wraps);

/// The dab's weight from its middle to its rim as a little curve.
void draw_falloff(const Theme& theme, const Brush& brush, ImVec2 size);
/// A stamp as a little picture; null: a disk.
void draw_stamp(ImDrawList& list, ImVec2 at, float side, const Grid<float>* stamp, ImU32 colour);

/// Menu entries of every layer a map can be taken from, in submenus; the one that was clicked.
std::optional<LayerId> layer_menu(const EditorState& state);

}  // namespace biotope
