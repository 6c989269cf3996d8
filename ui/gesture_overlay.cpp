#include "ui/gesture_overlay.hpp"

#include <algorithm>

namespace biotope {
namespace {

constexpr ImU32 light = IM_COL32(255, 255, 255, 235);
/// Squares that the longer side of a landscape is divided into for its outline.
constexpr int outline_blocks = 256;

/// The corners that a gesture's line runs through, back to the first where it is closed.
std::vector<PathPoint> corners_of(const ToolGesture& gesture) {
  const PathPoint a = gesture.points.front();
  const PathPoint b = gesture.points.back();
  if (gesture.tool == Tool::gradient) return {a, b};
  if (gesture.tool == Tool::select_rectangle) return {a, {b.x, a.y}, b, {a.x, b.y}, a};
  std::vector<PathPoint> corners = gesture.points;
  corners.push_back(a);
  return corners;
}

}  // namespace

void draw_gesture(ImDrawList& list, const Theme& theme, const ToolGesture& gesture, const ViewPen& pen) {
  const std::vector<PathPoint> corners = corners_of(gesture);
  pen.line(corners, {});
  if (gesture.tool != Tool::gradient) return;
  if (const auto from = pen.place(corners.front())) list.AddCircleFilled(*from, theme.px(4), light);
  if (const auto to = pen.place(corners.back())) list.AddCircle(*to, theme.px(4), light, 20, theme.px(1.5F));
}

void GroundOutline::draw(const UiContext& ui, const ViewPen& pen) {
  const auto& mask = ui.state.document.selection;
  if (!mask) {
    of_ = nullptr;
    return;
  }
  if (mask != of_) {
    const Rect all = mask->rect();
    const int block = std::max(1, std::max(all.width(), all.height()) / outline_blocks);
    of_ = mask;
    pieces_ = outline_of(*mask, all, block);
  }
  for (const OutlinePiece& piece : pieces_) {
    const PathPoint ends[] = {{piece.x0, piece.y0}, {piece.x1, piece.y1}};
    pen.line(ends, {});
  }
}

}  // namespace biotope
