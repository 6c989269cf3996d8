#include "ui/placing_overlay.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/terrain/shaping.hpp"
#include "ui/editor_actions.hpp"
#include "ui/herd_day.hpp"
#include "ui/panels/herd_panel.hpp"
#include "ui/placing_actions.hpp"

namespace biotope {
namespace {

constexpr ImU32 casing = IM_COL32(20, 22, 24, 190);

/// Colour and width of a kind's line or mark.
struct Stroked {
  ImU32 colour = 0;
  float width = 2;
  bool dashed = false;
};

Stroked style_of(PlacedKind kind) {
  switch (kind) {
    case PlacedKind::inflow:
    case PlacedKind::river:
    case PlacedKind::lake:
      return {IM_COL32(86, 170, 235, 255), 2.5F, false};
    case PlacedKind::ford:
      return {IM_COL32(140, 220, 235, 255), 2, true};
    case PlacedKind::exit:
      return {IM_COL32(150, 215, 120, 255), 2, true};
    case PlacedKind::waypoint:
      return {IM_COL32(245, 200, 90, 255), 2, false};
    case PlacedKind::pinned_trail:
      return {IM_COL32(245, 200, 90, 255), 2.5F, false};
    case PlacedKind::forbidden_trail:
      return {IM_COL32(235, 95, 80, 255), 2, true};
  }
  return {};
}

/// Draws what is placed with the pen of a view.
class Painter {
 public:
  Painter(const UiContext& ui, const ViewPen& pen) : ui_(ui), pen_(pen), list_(*ImGui::GetWindowDrawList()) {}

  void line(std::vector<PathPoint> points, const Stroked& style, bool closed, float emphasis = 1) const {
    if (points.size() < 2) return;
    if (closed) points.push_back(points.front());
    pen_.line(points, {style.colour, style.width * emphasis, casing, 1, style.dashed});
  }

  void ring(PathPoint at, float radius, const Stroked& style) const {
    pen_.line(ring_around(at, radius), {style.colour, style.width, casing, 1, false});
  }

  /// A small mark that tells the kind: a drop for water, a diamond for ways, a square for fords.
  void mark(PathPoint at, PlacedKind kind, bool selected) const {
    const auto centre = pen_.place(at);
    if (!centre) return;
    const ImU32 colour = mark_colour(pen_, at, style_of(kind).colour);
    const ImU32 edge = mark_colour(pen_, at, casing);
    const float r = ui_.theme.px(selected ? 7 : 5.5F);
    const auto diamond = [&](float size, ImU32 ink) {
      list_.AddQuadFilled(ImVec2(centre->x, centre->y - size), ImVec2(centre->x + size, centre->y),
                          ImVec2(centre->x, centre->y + size), ImVec2(centre->x - size, centre->y), ink);
    };
    if (kind == PlacedKind::waypoint || kind == PlacedKind::exit) {
      diamond(r + ui_.theme.px(2.5F), edge);
      diamond(r, colour);
    } else {
      list_.AddCircleFilled(*centre, r + ui_.theme.px(1.5F), edge);
      list_.AddCircleFilled(*centre, r, colour);
    }
    if (selected) list_.AddCircle(*centre, r + ui_.theme.px(4), IM_COL32(255, 255, 255, 230), 32, ui_.theme.px(1.5F));
  }

  void handle(PathPoint at, bool held) const {
    const auto centre = pen_.place(at);
    if (!centre) return;
    const float r = ui_.theme.px(held ? 6 : 4.5F);
    list_.AddCircleFilled(*centre, r + ui_.theme.px(1.5F), mark_colour(pen_, at, casing));
    list_.AddCircleFilled(*centre, r, mark_colour(pen_, at, held ? colour_u32(ui_.theme.accent) : IM_COL32(255, 255, 255, 240)));
  }

 private:
  const UiContext& ui_;
  const ViewPen& pen_;
  ImDrawList& list_;
};

void draw_things(const UiContext& ui, const Painter& painter) {
  const PlacingSession& placing = ui.state.placing;
  const PlacedThings things = shown_things(ui.state);
  for (int k = 0; k < placed_kinds; ++k) {
    const auto kind = PlacedKind(k);
    for (std::size_t i = 0; i < count_of(things, kind); ++i) {
      const PlacedItem item{kind, i};
      const bool selected = placing.selected == item;
      const std::vector<PathPoint> points = points_of(things, item);
      if (!is_line(kind)) {
        painter.ring(points[0], float(double(radius_of(things, item)) / ui.state.document.terrain->cell_size), style_of(kind));
        painter.mark(points[0], kind, selected);
        continue;
      }
      // As they will be on the ground: smooth through their points.
      painter.line(smooth_line(points, kind == PlacedKind::lake, 2), style_of(kind), kind == PlacedKind::lake,
                   selected ? 1.5F : 1);
      if (!selected) continue;
      for (std::size_t p = 0; p < points.size(); ++p) {
        painter.handle(points[p], placing.held && placing.held->point == p);
      }
    }
  }
}

void draw_in_progress(const UiContext& ui, const Painter& painter, const std::optional<PathPoint>& pointer) {
  const PlacingSession& placing = ui.state.placing;
  if (placing.bend && placing.bend->after.size() > 1) {
    painter.line(placing.bend->before, style_of(PlacedKind::forbidden_trail), false);
    painter.line(placing.bend->after, style_of(PlacedKind::pinned_trail), false, 1.4F);
  }
  if (placing.line.empty()) return;
  const bool lake = placing.tool == PlacingTool::lake;
  const Stroked style = style_of(placing.tool == PlacingTool::pin_trail      ? PlacedKind::pinned_trail
                                 : placing.tool == PlacingTool::forbid_trail ? PlacedKind::forbidden_trail
                                                                             : PlacedKind::river);
  std::vector<PathPoint> line = placing.line;
  if (pointer) line.push_back(*pointer);
  painter.line(line, style, lake && line.size() > 2);
  for (const PathPoint& point : placing.line) painter.handle(point, false);
}

/// Takes a key that went down since the last frame.
bool take(EditorState& state, int key) {
  const auto found = std::find_if(state.key_presses.begin(), state.key_presses.end(),
                                  [&](const KeyPress& press) { return press.keys.key == key && !press.keys.control; });
  if (found == state.key_presses.end()) return false;
  state.key_presses.erase(found);
  return true;
}

void handle_keys(EditorState& state) {
  PlacingSession& placing = state.placing;
  if (ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    return;
  if (!placing.line.empty() && (take(state, GLFW_KEY_ENTER) || take(state, GLFW_KEY_KP_ENTER))) finish_line(state);
  if (!placing.line.empty() && take(state, GLFW_KEY_BACKSPACE)) shorten_line(state);
  if (removes_thing(state) && (take(state, GLFW_KEY_DELETE) || take(state, GLFW_KEY_BACKSPACE))) remove_selected(state);
  if ((placing.busy() || placing.selected) && take(state, GLFW_KEY_ESCAPE)) cancel_placing(state);
}

}  // namespace

void draw_placed(const UiContext& ui, const ViewPen& pen, const std::optional<PathPoint>& pointer) {
  if (!ui.state.has_document) return;
  const Painter painter(ui, pen);
  draw_herd_day(ui, pen);
  draw_things(ui, painter);
  draw_in_progress(ui, painter, pointer);
}

bool handle_placing(const UiContext& ui, PlacingView view, const std::optional<PathPoint>& at, float reach, bool hovered) {
  EditorState& state = ui.state;
  follow_document(state);
  if (!state.has_document) return false;
  PlacingSession& placing = state.placing;
  if (hovered) handle_keys(state);
  const PointerButton left{ImGui::IsMouseDown(ImGuiMouseButton_Left), ImGui::IsMouseReleased(ImGuiMouseButton_Left),
                           ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)};
  if (follow_press(state, view, at, left)) return true;
  if (!hovered || !at || ImGui::GetIO().KeyAlt) return false;
  if (!placing.line.empty() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    finish_line(state);
    return true;
  }
  if (!placing.line.empty() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    finish_line(state);
    return true;
  }
  if (state.tool == Tool::select && placing.tool == PlacingTool::none && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
      press_day(state, *at, reach)) {
    placing.took_press = true;
    placing.pressed_on = view;
    return true;
  }
  if (placing.tool == PlacingTool::none && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && placing.selected &&
      is_line(placing.selected->kind) && item_near(placed_things(state.document), *at, reach) == placing.selected) {
    split_selected(state, *at);
    return true;
  }
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && press_placing(state, *at, reach)) {
    placing.took_press = true;
    placing.pressed_on = view;
    return true;
  }
  return placing.tool != PlacingTool::none;
}

}  // namespace biotope
