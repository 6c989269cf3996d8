#include "ui/brush_marks.hpp"

#include <array>

#include "ui/editor_state.hpp"

namespace biotope {
namespace {

void draw_cross(ImDrawList& list, const Theme& theme, const ViewPen& pen, PathPoint at) {
  const auto centre = pen.place(at);
  if (!centre) return;
  const float arm = theme.px(7);
  const std::array<std::array<ImVec2, 2>, 2> arms{{{ImVec2(centre->x - arm, centre->y), ImVec2(centre->x + arm, centre->y)},
                                                   {ImVec2(centre->x, centre->y - arm), ImVec2(centre->x, centre->y + arm)}}};
  for (const auto& [from, to] : arms) list.AddLine(from, to, mark_colour(pen, at, IM_COL32(0, 0, 0, 150)), theme.px(3));
  for (const auto& [from, to] : arms) list.AddLine(from, to, mark_colour(pen, at, IM_COL32(255, 255, 255, 235)), theme.px(1.5F));
}

}  // namespace

std::optional<PathPoint> clone_source(const EditorState& state, PathPoint pointer) {
  if (state.tool != Tool::clone) return std::nullopt;
  if (state.paint.clone_at) return state.paint.clone_at;
  const PathPoint offset = state.paint.clone_offset;
  if (offset == PathPoint{}) return std::nullopt;
  return PathPoint{pointer.x + offset.x, pointer.y + offset.y};
}

void draw_brush_marks(ImDrawList& list, const Theme& theme, const EditorState& state, const ViewPen& pen, PathPoint pointer) {
  if (!is_brush(state.tool)) return;
  if (ImGui::GetIO().KeyShift && state.paint.last_point && !state.painting.stroking()) {
    const std::array<PathPoint, 2> ends{*state.paint.last_point, pointer};
    pen.line(ends, {});
  }
  if (const auto source = clone_source(state, pointer)) draw_cross(list, theme, pen, *source);
}

}  // namespace biotope
