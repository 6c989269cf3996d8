#include "ui/map_canvas.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "ui/brush_ring.hpp"
#include "ui/canvas_menu.hpp"
#include "ui/editor_actions.hpp"
#include "ui/format.hpp"
#include "ui/icons.hpp"
#include "ui/map_furniture.hpp"
#include "ui/outdated_area.hpp"
#include "ui/placing_overlay.hpp"
#include "ui/tool_gestures.hpp"
#include "ui/view_transform.hpp"

namespace biotope {
namespace {

constexpr double most_zoomed_in = 64;  // pixels a cell

bool same_options(const MapOptions& a, const MapOptions& b) {
  const bool same_herds = a.herds == b.herds && (!a.herds || a.hour == b.hour) && a.visible_species == b.visible_species;
  return same_herds && same_ground(a, b);
}

double least_zoom(const Terrain& terrain, PixelPoint canvas) {
  return 0.4 * fitted(terrain.height.rect(), canvas, 0).pixels_per_cell;
}

bool space_held() { return ImGui::GetIO().KeysDown[GLFW_KEY_SPACE]; }

}  // namespace

Result<std::unique_ptr<MapCanvas>> MapCanvas::create() {
  auto renderer = MapRenderer::create();
  if (!renderer) return tl::unexpected(renderer.error());
  return std::unique_ptr<MapCanvas>(new MapCanvas(std::move(*renderer)));
}

MapCanvas::MapCanvas(std::unique_ptr<MapRenderer> renderer)
    : renderer_(std::move(renderer)), target_(std::make_unique<RenderTarget>(16, 16)) {}

MapOptions MapCanvas::options_for(const UiContext& ui) {
  EditorState& state = ui.state;
  MapOptions options;
  options.view = state.view.map;
  options.water = state.view.water;
  options.contours = state.view.contours;
  options.trails = state.view.trails;
  options.herds = state.view.herds;
  options.hour = state.clock.hour;
  options.visible_species = state.view.visible_species;
  options.dark = ui.theme.dark;
  options.pixel_scale = ui.theme.scale;
  const FoodWeb* web = state.web();
  follow_shown_map(state, map_);
  const MapId id = map_.id;
  options.overlay = overlay_of(state, map_);
  if (options.overlay && state.view.iso_lines) options.line_step = line_step({options.overlay->low, options.overlay->high});
  if (web != nullptr && state.view.hatch) {
    if (const auto layer = layer_of_map(id, *web)) {
      const auto found = state.document.layers.find(*layer);
      if (found != state.document.layers.end()) options.hatched = found->second;
      const auto shortage = state.shortages.find(id.item);
      const bool density = layer->kind == LayerKind::animal_density || layer->kind == LayerKind::plant_density;
      if (density && shortage != state.shortages.end()) options.beyond = shortage->second;
    }
  }
  return options;
}

void MapCanvas::draw_picture(const UiContext& ui, int width, int height) {
  EditorState& state = ui.state;
  Picture wanted{options_for(ui), state.shown, width, height};
  const Rect changed = state.painting.take_changed();
  const bool same_values = has_picture_ && wanted.options.overlay && drawn_.options.overlay &&
                           wanted.options.overlay->cells == drawn_.options.overlay->cells;
  if (same_values && !changed.empty()) renderer_->patch_overlay(*wanted.options.overlay->cells, changed);
  const bool same = has_picture_ && changed.empty() && renderer_->complete() && wanted.snapshot == drawn_.snapshot &&
                    wanted.width == drawn_.width && wanted.height == drawn_.height &&
                    same_options(wanted.options, drawn_.options);
  if (same) return;
  target_->resize(width, height);
  renderer_->set_snapshot(wanted.snapshot);
  target_->bind();
  renderer_->draw(wanted.options, width, height);
  drawn_ = std::move(wanted);
  has_picture_ = true;
}

void MapCanvas::handle_zoom(const UiContext& ui, PixelPoint canvas, PixelPoint pixel) const {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0) return;
  EditorView& view = ui.state.view;
  const double least = least_zoom(*ui.state.document.terrain, canvas);
  view.map = zoomed(view.map, canvas, pixel, std::pow(1.2, double(wheel)), least, most_zoomed_in);
}

void MapCanvas::follow_stroke(const UiContext& ui, PixelPoint canvas) {
  EditorState& state = ui.state;
  for (const auto& point : state.path.points) {
    const PathPoint cell = cell_at(state.view.map, canvas, {point[0] - origin_.x, point[1] - origin_.y});
    drag_tool(state, cell, point[2]);
  }
  state.path.points.clear();
  if (state.path.held) return;
  release_tool(state);
  paints_ = false;
}

void MapCanvas::handle_tool(const UiContext& ui, PixelPoint canvas, const PathPoint& cell, bool hovered) {
  EditorState& state = ui.state;
  const ImGuiIO& io = ImGui::GetIO();
  if (paints_ && tool_active(state)) {
    follow_stroke(ui, canvas);
    return;
  }
  const float reach = ui.theme.px(9) / float(state.view.map.pixels_per_cell);
  if (handle_placing(ui, PlacingView::map, cell, reach, hovered && !space_held())) return;
  if (!hovered || space_held()) return;
  const int x = int(std::lround(cell.x));
  const int y = int(std::lround(cell.y));
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    if (io.KeyAlt) {
      ask_why(state, x, y);
    } else if (state.tool != Tool::select && !state.path.points.empty()) {
      const auto& first = state.path.points.front();
      const PathPoint begin = cell_at(state.view.map, canvas, {first[0] - origin_.x, first[1] - origin_.y});
      press_tool(state, begin, {io.KeyCtrl, io.KeyShift, first[2]});
      paints_ = tool_active(state);
      if (paints_) follow_stroke(ui, canvas);
      return;
    }
  }
  const bool clicked =
      ImGui::IsMouseReleased(ImGuiMouseButton_Left) && io.MouseDragMaxDistanceSqr[0] < 16 * io.MouseDragThreshold;
  if (state.tool == Tool::select && clicked && !io.KeyAlt && !choose_herd(state, cell, reach * 1.4F)) ask_why(state, x, y);
  const bool right_clicked =
      ImGui::IsMouseReleased(ImGuiMouseButton_Right) && io.MouseDragMaxDistanceSqr[1] < 16 * io.MouseDragThreshold;
  if (right_clicked) {
    asked_ = cell;
    ImGui::OpenPopup("map menu");
  }
}

void MapCanvas::handle_mouse(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered) {
  EditorState& state = ui.state;
  if (!state.document.terrain) return;
  const Terrain& terrain = *state.document.terrain;
  const bool active = ImGui::IsItemActive();
  if (hovered) handle_zoom(ui, canvas, pixel);
  if (camera_mark_.handle(ui, canvas, pixel, hovered)) return;
  const bool left_pans = space_held() || (state.tool == Tool::select && !state.placing.busy() && state.herd_day.held_stop < 0 &&
                                          !ImGui::GetIO().KeyAlt);
  const bool panning = active && (ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0) ||
                                  (left_pans && ImGui::IsMouseDragging(ImGuiMouseButton_Left, space_held() ? 0.0F : -1.0F)));
  if (panning) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    state.view.map = panned(state.view.map, {moved.x, moved.y});
  }
  state.view.map = kept_on_map(state.view.map, terrain.height.width(), terrain.height.height());
  const PathPoint cell = cell_at(state.view.map, canvas, pixel);
  if (hovered) state.pointer = {terrain.height.contains(int(std::lround(cell.x)), int(std::lround(cell.y))), cell.x, cell.y};
  handle_tool(ui, canvas, cell, hovered);
}

void MapCanvas::draw_pulse(const UiContext& ui, ImVec2 origin, PixelPoint canvas) const {
  const EditorState& state = ui.state;
  if (!state.worker || !state.worker->progress().busy || !state.shown || !state.document.terrain) return;
  Rect area = outdated_area(state.document, *state.shown);
  // Computed again without a change: all of it.
  if (area.empty()) area = state.document.terrain->height.rect();
  const PixelPoint low = pixel_of(state.view.map, canvas, area.x0 - 0.5, area.y0 - 0.5);
  const PixelPoint high = pixel_of(state.view.map, canvas, area.x1 - 0.5, area.y1 - 0.5);
  const auto wave = float(0.5 + 0.5 * std::sin(ImGui::GetTime() * 5));
  // An edge outside the view is drawn along the view's own.
  const double inset = ui.theme.px(2);
  const auto across = [&](double x) { return origin.x + float(std::clamp(x, inset, canvas.x - inset)); };
  const auto down = [&](double y) { return origin.y + float(std::clamp(y, inset, canvas.y - inset)); };
  const ImVec2 from(across(low.x), down(low.y));
  const ImVec2 to(across(high.x), down(high.y));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float round = ui.theme.px(4);
  list.AddRect(from, to, IM_COL32(0, 0, 0, 90), round, 0, ui.theme.px(4));
  list.AddRect(from, to, IM_COL32(255, 255, 255, int(90 + 160 * wave)), round, 0, ui.theme.px(1.5F));
}

void MapCanvas::draw_cursor(const UiContext& ui, ImVec2 origin, PixelPoint canvas, PixelPoint pixel, bool hovered) const {
  const EditorState& state = ui.state;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (state.question) {
    const PixelPoint at = pixel_of(state.view.map, canvas, state.question->x, state.question->y);
    const ImVec2 place(origin.x + float(at.x), origin.y + float(at.y));
    list.AddCircle(place, ui.theme.px(7), IM_COL32(0, 0, 0, 200), 24, ui.theme.px(4));
    list.AddCircle(place, ui.theme.px(7), colour_u32(ui.theme.attention), 24, ui.theme.px(2));
  }
  if (const auto cell = ring_on_map(state, hovered)) {
    overlay_.draw_cursor(ui, origin, canvas, pixel_of(state.view.map, canvas, double(cell->x), double(cell->y)));
    return;
  }
  if ((!hovered && !state.painting.stroking()) || space_held()) return;
  overlay_.draw_cursor(ui, origin, canvas, pixel);
}

void MapCanvas::draw_things(const UiContext& ui, ImVec2 origin, PixelPoint canvas, PixelPoint pixel, bool hovered) const {
  const EditorState& state = ui.state;
  if (!state.document.terrain) return;
  const ScreenPlace place = [&](PathPoint cell) -> std::optional<ImVec2> {
    const PixelPoint at = pixel_of(state.view.map, canvas, double(cell.x), double(cell.y));
    return ImVec2(origin.x + float(at.x), origin.y + float(at.y));
  };
  const auto pointer = hovered ? std::optional(cell_at(state.view.map, canvas, pixel)) : std::nullopt;
  draw_placed(ui, flat_pen(*ImGui::GetWindowDrawList(), ui.theme, place), pointer);
}

void MapCanvas::draw_herd_tooltip(const UiContext& ui, PixelPoint canvas, PixelPoint pixel) const {
  const EditorState& state = ui.state;
  if (!state.view.herds || !state.shown || !state.shown->web) return;
  const MapsSnapshot& snapshot = *state.shown;
  const float reach = ui.theme.px(14) / float(state.view.map.pixels_per_cell);
  const int nearest =
      herd_near(snapshot, state.view.visible_species, state.clock.hour, cell_at(state.view.map, canvas, pixel), reach);
  if (nearest < 0) return;
  const DailyPlan& plan = (*snapshot.plans)[std::size_t(nearest)];
  const HerdState its =
      herd_state(plan, snapshot.graph->levels[std::size_t(plan.level)], state.clock.hour, snapshot.terrain().cell_size);
  const Species& species = snapshot.web->species[std::size_t(plan.species)];
  ImGui::BeginTooltip();
  ImGui::PushFont(ui.theme.bold);
  ImGui::TextUnformatted(display_name(species).c_str());
  ImGui::PopFont();
  std::string line = std::to_string(plan.size) + (plan.size == 1 ? " animal, " : " animals, ") + activity_word(its.activity);
  if (its.activity == HerdActivity::walking) line += " at " + format_value(its.speed * 3.6, "km/h");
  ImGui::TextColored(ui.theme.muted, "%s", line.c_str());
  ImGui::EndTooltip();
}

void MapCanvas::draw_context_menu(const UiContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(8), ui.theme.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(10), ui.theme.px(6)));
  if (ImGui::BeginPopup("map menu")) {
    draw_cell_menu(ui, int(std::lround(asked_.x)), int(std::lround(asked_.y)));
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

void MapCanvas::draw_furniture(const UiContext& ui, ImVec2 origin, ImVec2 size) const {
  const EditorState& state = ui.state;
  if (!state.document.terrain) return;
  const MapEntry entry = describe_map(visible_map(state), state.web());
  ImVec2 legend;
  if (map_.values.cells) {
    const ScaleRange range = scale_range(entry, map_.values.low, map_.values.high);
    legend = draw_legend(ui.theme, origin, size, entry, range.low, range.high, !map_.current);
  }
  draw_scale_bar(ui.theme, origin, size, state.document.terrain->cell_size / state.view.map.pixels_per_cell, legend);
  draw_north_arrow(ui.theme, origin, size, 0);
}

void MapCanvas::draw(const UiContext& ui, ImVec2 size) {
  EditorState& state = ui.state;
  const int width = std::max(int(size.x), 16);
  const int height = std::max(int(size.y), 16);
  const PixelPoint canvas{double(width), double(height)};
  // A view nobody has moved stays fitted when the window changes its size.
  const MapView& view = state.view.map;
  const bool untouched =
      view.centre_x == fitted_.centre_x && view.centre_y == fitted_.centre_y && view.pixels_per_cell == fitted_.pixels_per_cell;
  if (state.document.terrain && (!state.view.framed || untouched)) {
    fitted_ = fitted(state.document.terrain->height.rect(), canvas, ui.theme.px(20));
    state.view.map = fitted_;
    state.view.framed = true;
  }
  draw_picture(ui, width, height);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  origin_ = origin;
  ImGui::InvisibleButton(
      "map canvas", ImVec2(float(width), float(height)),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const PixelPoint pixel{mouse.x - origin.x, mouse.y - origin.y};
  handle_mouse(ui, canvas, pixel, hovered);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end(origin.x + float(width), origin.y + float(height));
  list.PushClipRect(origin, end, true);
  const auto texture = reinterpret_cast<ImTextureID>(std::uintptr_t(target_->texture()));
  list.AddImage(texture, origin, end, ImVec2(0, 1), ImVec2(1, 0));
  draw_pulse(ui, origin, canvas);
  overlay_.draw(ui, origin, canvas);
  draw_things(ui, origin, canvas, pixel, hovered);
  camera_mark_.draw(ui, origin, canvas);
  draw_cursor(ui, origin, canvas, pixel, hovered);
  draw_furniture(ui, origin, size);
  list.PopClipRect();
  if (hovered && !tool_active(state) && !ImGui::IsMouseDown(0)) draw_herd_tooltip(ui, canvas, pixel);
  draw_context_menu(ui);
}

}  // namespace biotope
