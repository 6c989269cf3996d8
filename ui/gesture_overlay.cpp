#include "ui/gesture_overlay.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {
namespace {

constexpr ImU32 shadow = IM_COL32(0, 0, 0, 150);
constexpr ImU32 light = IM_COL32(255, 255, 255, 235);
/// Squares that the longer side of a landscape is divided into for its outline.
constexpr int outline_blocks = 256;

void two_tone_line(ImDrawList& list, const Theme& theme, ImVec2 from, ImVec2 to) {
  list.AddLine(from, to, shadow, theme.px(3));
  list.AddLine(from, to, light, theme.px(1.5F));
}

void draw_line(ImDrawList& list, const Theme& theme, const ScreenPlace& screen, PathPoint from, PathPoint to, float step) {
  std::optional<ImVec2> last;
  for (const PathPoint& place : along_ground(from, to, step)) {
    const std::optional<ImVec2> at = screen(place);
    if (last && at) two_tone_line(list, theme, *last, *at);
    last = at;
  }
}

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

std::vector<PathPoint> along_ground(PathPoint from, PathPoint to, float step) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const int pieces = std::clamp(int(std::ceil(length / std::max(step, 1e-3F))), 1, 4096);
  std::vector<PathPoint> places;
  places.reserve(std::size_t(pieces) + 1);
  for (int i = 0; i <= pieces; ++i) {
    const float share = float(i) / float(pieces);
    places.push_back({from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share});
  }
  return places;
}

void draw_gesture(ImDrawList& list, const Theme& theme, const ToolGesture& gesture, const ScreenPlace& screen, float step) {
  const std::vector<PathPoint> corners = corners_of(gesture);
  for (std::size_t i = 1; i < corners.size(); ++i) draw_line(list, theme, screen, corners[i - 1], corners[i], step);
  if (gesture.tool != Tool::gradient) return;
  if (const auto from = screen(corners.front())) list.AddCircleFilled(*from, theme.px(4), light);
  if (const auto to = screen(corners.back())) list.AddCircle(*to, theme.px(4), light, 20, theme.px(1.5F));
}

void GroundOutline::draw(const UiContext& ui, const ScreenPlace& screen) {
  const auto& mask = ui.state.document.selection;
  if (!mask) {
    of_ = nullptr;
    return;
  }
  if (mask != of_) {
    const Rect all = mask->rect();
    const int block = std::max(1, std::max(all.width(), all.height()) / outline_blocks);
    of_ = mask;
    step_ = 4 * float(block);
    pieces_ = outline_of(*mask, all, block);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const OutlinePiece& piece : pieces_) {
    draw_line(list, ui.theme, screen, {piece.x0, piece.y0}, {piece.x1, piece.y1}, step_);
  }
}

}  // namespace biotope
