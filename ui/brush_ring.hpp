#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/base/path_point.hpp"

namespace biotope {

struct EditorState;

/// The ring that the 3D view draws on the ground where the brush is, over whichever view the pointer is: cell x, y and radius in
/// cells. Nothing with a tool that is no brush, or with the pointer over neither view.
[[nodiscard]] std::optional<glm::vec3> ring_in_landscape(const EditorState& state);

/// The cell around which the map draws the brush while the pointer is over the 3D view; `hovered`: it is over the map, which then
/// draws it where the pointer is.
[[nodiscard]] std::optional<PathPoint> ring_on_map(const EditorState& state, bool hovered);

}  // namespace biotope
