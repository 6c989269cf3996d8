#include "ui/brush_ring.hpp"

#include "ui/editor_state.hpp"

namespace biotope {

std::optional<glm::vec3> ring_in_landscape(const EditorState& state) {
  if (!is_brush(state.tool) || !state.pointer.over_map) return std::nullopt;
  return glm::vec3(state.pointer.x, state.pointer.y, state.brush.radius);
}

std::optional<PathPoint> ring_on_map(const EditorState& state, bool hovered) {
  if (hovered || !is_brush(state.tool)) return std::nullopt;
  return state.exploring.pointer;
}

}  // namespace biotope
