#include "ui/tool_overlay.hpp"

#include <algorithm>
#include <cmath>

#include "ui/brush_marks.hpp"
#include "ui/editor_actions.hpp"
#include "ui/gesture_overlay.hpp"
#include "ui/paint_targets.hpp"

namespace biotope {
namespace {

constexpr double outline_pixels = 2;  // blocks of the outline and the film on the screen
constexpr double film_pixels = 4;
constexpr double locked_pixels = 6;
constexpr std::size_t most_dashed = 3000;  // pieces; more are drawn plain

constexpr ImU32 shadow = IM_COL32(0, 0, 0, 150);
constexpr ImU32 light = IM_COL32(255, 255, 255, 235);

/// From cells to the screen.
struct ToScreen {
  const MapView& view;
  PixelPoint canvas;
  ImVec2 origin;
  [[nodiscard]] ImVec2 operator()(double x, double y) const {
    const PixelPoint at = pixel_of(view, canvas, x, y);
    return {origin.x + float(at.x), origin.y + float(at.y)};
  }
};

void two_tone_line(ImDrawList& list, const Theme& theme, ImVec2 from, ImVec2 to) {
  list.AddLine(from, to, shadow, theme.px(3));
  list.AddLine(from, to, light, theme.px(1.5F));
}

/// Dashes of a line along an axis, in step with the screen so that pieces that meet go on.
void dashed_line(ImDrawList& list, ImVec2 from, ImVec2 to, float dash) {
  list.AddLine(from, to, IM_COL32(0, 0, 0, 220), 1.5F);
  const bool across = from.y == to.y;
  const float begin = across ? from.x : from.y;
  const float end = across ? to.x : to.y;
  const float first = std::floor(begin / (2 * dash)) * 2 * dash;
  for (float at = first; at < end; at += 2 * dash) {
    const float low = std::max(at, begin);
    const float high = std::min(at + dash, end);
    if (high <= low) continue;
    list.AddLine(across ? ImVec2(low, from.y) : ImVec2(from.x, low), across ? ImVec2(high, from.y) : ImVec2(from.x, high),
                 IM_COL32(255, 255, 255, 245), 1.5F);
  }
}

void draw_cross(ImDrawList& list, const Theme& theme, ImVec2 at) {
  const float arm = theme.px(7);
  two_tone_line(list, theme, ImVec2(at.x - arm, at.y), ImVec2(at.x + arm, at.y));
  two_tone_line(list, theme, ImVec2(at.x, at.y - arm), ImVec2(at.x, at.y + arm));
}

bool same_maps(const FilterMaps& a, const FilterMaps& b) {
  return a.slope == b.slope && a.altitude == b.altitude && a.aspect == b.aspect && a.water_distance == b.water_distance &&
         a.values == b.values;
}

}  // namespace

bool ToolOverlay::View::same(const MapView& now, PixelPoint size, const std::shared_ptr<const SelectionMask>& mask) const {
  return now.centre_x == view.centre_x && now.centre_y == view.centre_y && now.pixels_per_cell == view.pixels_per_cell &&
         size.x == canvas.x && size.y == canvas.y && mask == selection;
}

void ToolOverlay::draw_selection(const UiContext& ui, ImVec2 origin, PixelPoint canvas) {
  const EditorState& state = ui.state;
  const auto& mask = state.document.selection;
  if (!mask) return;
  const MapView& view = state.view.map;
  if (!outlined_.same(view, canvas, mask)) {
    outlined_ = {view, canvas, mask};
    outline_ = outline_of(*mask, visible_cells(view, canvas, mask->rect()), block_cells(view, outline_pixels));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ToScreen screen{view, canvas, origin};
  const float dash = std::round(ui.theme.px(4));
  for (const OutlinePiece& piece : outline_) {
    const ImVec2 from = screen(piece.x0, piece.y0);
    const ImVec2 to = screen(piece.x1, piece.y1);
    if (outline_.size() > most_dashed) {
      list.AddLine(from, to, IM_COL32(255, 255, 255, 200), 1);
    } else {
      dashed_line(list, from, to, dash);
    }
  }
}

void ToolOverlay::draw_film(const UiContext& ui, ImVec2 origin, PixelPoint canvas) {
  EditorState& state = ui.state;
  const BrushFilter& filter = state.brush.filter;
  if (!state.paint.show_filter || !state.shown || (filter.conditions.empty() && !state.document.selection)) return;
  const MapView& view = state.view.map;
  // Maps that are still being made, or change under the brush, are shown as they were last.
  const bool ready = !state.painting.stroking() && state.grounds.ready(*state.shown, state.document, filter);
  FilterMaps maps = ready ? state.grounds.filters(*state.shown, state.document, filter) : film_maps_;
  if (!filmed_.same(view, canvas, state.document.selection) ||
      (ready && (!(film_filter_ == filter) || !same_maps(film_maps_, maps)))) {
    filmed_ = {view, canvas, state.document.selection};
    if (ready) film_filter_ = filter;
    film_maps_ = std::move(maps);
    film_ = film_of(film_filter_, film_maps_, state.document.selection.get(),
                    visible_cells(view, canvas, state.document.terrain->height.rect()), block_cells(view, film_pixels));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ToScreen screen{view, canvas, origin};
  for (const FilmRun& run : film_) {
    list.AddRectFilled(screen(run.cells.x0 - 0.5, run.cells.y0 - 0.5), screen(run.cells.x1 - 0.5, run.cells.y1 - 0.5),
                       IM_COL32(196, 42, 60, 28 * run.level));
  }
}

void ToolOverlay::draw_locked(const UiContext& ui, ImVec2 origin, PixelPoint canvas) {
  const EditorState& state = ui.state;
  const auto& mask = state.document.locked_area;
  if (!mask) return;
  const MapView& view = state.view.map;
  if (!locked_.same(view, canvas, mask)) {
    locked_ = {view, canvas, mask};
    locked_film_ = runs_of(*mask, visible_cells(view, canvas, mask->rect()), block_cells(view, locked_pixels));
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ToScreen screen{view, canvas, origin};
  const float stripe = std::round(ui.theme.px(11));
  const float width = 0.25F * stripe;
  for (const FilmRun& run : locked_film_) {
    const ImVec2 from = screen(run.cells.x0 - 0.5, run.cells.y0 - 0.5);
    const ImVec2 to = screen(run.cells.x1 - 0.5, run.cells.y1 - 0.5);
    list.AddRectFilled(from, to, IM_COL32(70, 84, 110, 26 * run.level));
    // Slanted stripes, in step with the screen so that those of runs that meet go on.
    const auto inside = [&](float x, float y) { return ImVec2(std::clamp(x, from.x, to.x), y); };
    for (float at = std::floor((from.x + from.y) / stripe) * stripe; at < to.x + to.y; at += stripe) {
      const ImVec2 corners[] = {inside(at - from.y, from.y), inside(at + width - from.y, from.y), inside(at + width - to.y, to.y),
                                inside(at - to.y, to.y)};
      if (corners[1].x <= corners[3].x) continue;
      list.AddQuadFilled(corners[0], corners[1], corners[2], corners[3], IM_COL32(225, 232, 242, 26 * run.level));
    }
  }
}

void ToolOverlay::draw(const UiContext& ui, ImVec2 origin, PixelPoint canvas) {
  const EditorState& state = ui.state;
  if (!state.document.terrain) return;
  draw_locked(ui, origin, canvas);
  draw_film(ui, origin, canvas);
  draw_selection(ui, origin, canvas);
  const ToScreen screen{state.view.map, canvas, origin};
  if (state.gesture) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ScreenPlace place = [&](PathPoint cell) { return screen(double(cell.x), double(cell.y)); };
    draw_gesture(list, ui.theme, *state.gesture, flat_pen(list, ui.theme, place));
  }
}

void ToolOverlay::draw_cursor(const UiContext& ui, ImVec2 origin, PixelPoint canvas, PixelPoint pixel) const {
  const EditorState& state = ui.state;
  const Theme& theme = ui.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 centre(origin.x + float(pixel.x), origin.y + float(pixel.y));
  if (!is_brush(state.tool)) {
    if (state.tool != Tool::select) draw_cross(list, theme, centre);
    return;
  }
  const ToScreen screen{state.view.map, canvas, origin};
  const PathPoint cell = cell_at(state.view.map, canvas, pixel);
  const ScreenPlace place = [&](PathPoint at) { return screen(double(at.x), double(at.y)); };
  draw_brush_marks(list, theme, state, flat_pen(list, theme, place), cell);
  const float radius = float(state.brush.radius * state.view.map.pixels_per_cell);
  const bool able = paint_hindrance(state).empty();
  const ImU32 ring = able ? IM_COL32(255, 255, 255, 230) : IM_COL32(255, 180, 60, 230);
  list.AddCircle(centre, radius, IM_COL32(0, 0, 0, 130), 72, theme.px(3));
  list.AddCircle(centre, radius, ring, 72, theme.px(1.5F));
  const float core = radius * std::clamp(state.brush.hardness, 0.0F, 0.99F);
  if (core > theme.px(6) && core < radius - theme.px(3)) list.AddCircle(centre, core, IM_COL32(255, 255, 255, 80), 64, 1);
  list.AddCircleFilled(centre, theme.px(1.5F), ring);
}

}  // namespace biotope
