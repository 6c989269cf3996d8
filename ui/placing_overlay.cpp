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

/// Draws a line piece by piece, so that one whose ends are out of sight still shows its middle.
class Painter {
 public:
  Painter(const UiContext& ui, const ProjectCell& project) : ui_(ui), project_(project), list_(*ImGui::GetWindowDrawList()) {}

  void line(const std::vector<PathPoint>& points, const Stroked& style, bool closed, float emphasis = 1) const {
    const std::size_t pieces = points.size() < 2 ? 0 : closed ? points.size() : points.size() - 1;
    for (const bool under : {true, false}) {
      float carried = 0;
      for (std::size_t i = 0; i < pieces; ++i) {
        const auto a = project_(points[i]);
        const auto b = project_(points[(i + 1) % points.size()]);
        if (!a || !b) continue;
        const float width = ui_.theme.px(style.width * emphasis);
        if (under) {
          list_.AddLine(*a, *b, casing, width + ui_.theme.px(2));
        } else if (style.dashed) {
          carried = dashes(*a, *b, style.colour, width, carried);
        } else {
          list_.AddLine(*a, *b, style.colour, width);
        }
      }
    }
  }

  void circle(PathPoint at, float radius, const Stroked& style) const {
    const auto centre = project_(at);
    if (!centre || radius < ui_.theme.px(3)) return;
    list_.AddCircle(*centre, radius, casing, 48, ui_.theme.px(style.width + 2));
    list_.AddCircle(*centre, radius, style.colour, 48, ui_.theme.px(style.width));
  }

  /// A small mark that tells the kind: a drop for water, a diamond for ways, a square for fords.
  void mark(PathPoint at, PlacedKind kind, bool selected) const {
    const auto centre = project_(at);
    if (!centre) return;
    const Stroked style = style_of(kind);
    const float r = ui_.theme.px(selected ? 7 : 5.5F);
    const auto diamond = [&](float size, ImU32 colour) {
      list_.AddQuadFilled(ImVec2(centre->x, centre->y - size), ImVec2(centre->x + size, centre->y),
                          ImVec2(centre->x, centre->y + size), ImVec2(centre->x - size, centre->y), colour);
    };
    if (kind == PlacedKind::waypoint || kind == PlacedKind::exit) {
      diamond(r + ui_.theme.px(2.5F), casing);
      diamond(r, style.colour);
    } else {
      list_.AddCircleFilled(*centre, r + ui_.theme.px(1.5F), casing);
      list_.AddCircleFilled(*centre, r, style.colour);
    }
    if (selected) list_.AddCircle(*centre, r + ui_.theme.px(4), IM_COL32(255, 255, 255, 230), 32, ui_.theme.px(1.5F));
  }

  void handle(PathPoint at, bool held) const {
    const auto centre = project_(at);
    if (!centre) return;
    const float r = ui_.theme.px(held ? 6 : 4.5F);
    list_.AddCircleFilled(*centre, r + ui_.theme.px(1.5F), casing);
    list_.AddCircleFilled(*centre, r, held ? colour_u32(ui_.theme.accent) : IM_COL32(255, 255, 255, 240));
  }

 private:
  float dashes(ImVec2 a, ImVec2 b, ImU32 colour, float width, float carried) const {
    const float dash = ui_.theme.px(7);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (length <= 0) return carried;
    const ImVec2 step((b.x - a.x) / length, (b.y - a.y) / length);
    for (float at = -carried; at < length; at += 2 * dash) {
      const float from = std::max(at, 0.0F);
      const float to = std::min(at + dash, length);
      if (to <= from) continue;
      list_.AddLine(ImVec2(a.x + step.x * from, a.y + step.y * from), ImVec2(a.x + step.x * to, a.y + step.y * to), colour,
                    width);
    }
    return std::fmod(carried + length, 2 * dash);
  }

  const UiContext& ui_;
  const ProjectCell& project_;
  ImDrawList& list_;
};

void draw_things(const UiContext& ui, const Painter& painter, double pixels_per_metre) {
  const PlacingSession& placing = ui.state.placing;
  const PlacedThings things = shown_things(ui.state);
  for (int k = 0; k < placed_kinds; ++k) {
    const auto kind = PlacedKind(k);
    for (std::size_t i = 0; i < count_of(things, kind); ++i) {
      const PlacedItem item{kind, i};
      const bool selected = placing.selected == item;
      const std::vector<PathPoint> points = points_of(things, item);
      if (!is_line(kind)) {
        painter.circle(points[0], float(double(radius_of(things, item)) * pixels_per_metre), style_of(kind));
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
  if (placing.selected && placing.line.empty() && (take(state, GLFW_KEY_DELETE) || take(state, GLFW_KEY_BACKSPACE)))
    remove_selected(state);
  if ((placing.busy() || placing.selected) && take(state, GLFW_KEY_ESCAPE)) cancel_placing(state);
}

}  // namespace

void draw_placed(const UiContext& ui, const ProjectCell& project, double pixels_per_metre,
                 const std::optional<PathPoint>& pointer) {
  if (!ui.state.has_document) return;
  const Painter painter(ui, project);
  draw_herd_day(ui, project);
  draw_things(ui, painter, pixels_per_metre);
  draw_in_progress(ui, painter, pointer);
}

bool handle_placing(const UiContext& ui, const std::optional<PathPoint>& at, float reach, bool hovered) {
  EditorState& state = ui.state;
  follow_document(state);
  if (!state.has_document) return false;
  PlacingSession& placing = state.placing;
  if (hovered) handle_keys(state);
  if (state.herd_day.held_stop >= 0 && state.herd_day.grip == DayGrip::none && at) {
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) drag_day(state, *at);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) release_day(state);
    return true;
  }
  if ((placing.held || placing.bend) && at) {
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) drag_placing(state, *at);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) release_placing(state);
    return true;
  }
  if (placing.took_press && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    placing.took_press = false;
    return true;
  }
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
    return true;
  }
  if (placing.tool == PlacingTool::none && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && placing.selected &&
      is_line(placing.selected->kind) && item_near(placed_things(state.document), *at, reach) == placing.selected) {
    split_selected(state, *at);
    return true;
  }
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && press_placing(state, *at, reach)) {
    placing.took_press = true;
    return true;
  }
  return placing.tool != PlacingTool::none;
}

}  // namespace biotope
