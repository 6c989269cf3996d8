#pragma once

#include <optional>

#include "render/map_renderer.hpp"
#include "ui/map_builder.hpp"

namespace biotope {

struct EditorState;

/// The values of the map that is looked at, as a view has them: under a brush those that are being painted.
struct ShownMap {
  MapId id;
  MapValues values;
  /// True when they are of the newest landscape.
  bool current = false;
};

/// Brings the values up to date; asks for those that are not made yet. Once a frame and view.
void follow_shown_map(EditorState& state, ShownMap& map);
/// The map with its colours; nothing where none is shown or its values are not known.
[[nodiscard]] std::optional<MapOverlay> overlay_of(const EditorState& state, const ShownMap& map);

}  // namespace biotope
