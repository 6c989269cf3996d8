#include "ui/camera_mark.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/landscape_renderer.hpp"
#include "ui/camera_motion.hpp"
#include "ui/exploring.hpp"
#include "ui/walking.hpp"

namespace biotope {
namespace {

constexpr float mark_length = 54;  // at scale 1
constexpr float grip_reach = 9;

ImVec2 toward(ImVec2 from, float degrees, float length) {
  const float angle = degrees * 0.01745329F;
  return {from.x + std::sin(angle) * length, from.y - std::cos(angle) * length};
}

/// Half of what the view is wide, degrees.
float half_width(const EditorState& state) {
  const float tangent = std::tan(state.view.camera.vertical_field * 0.00872665F) * state.exploring.aspect;
  return std::atan(tangent) * 57.29578F;
}

bool near(PixelPoint a, PixelPoint b, float reach) { return std::hypot(a.x - b.x, a.y - b.y) < double(reach); }

/// The camera's path while somebody works on it.
void draw_path(const UiContext& ui, ImVec2 origin, PixelPoint canvas) {
  const EditorState& state = ui.state;
  const CameraPath& path = state.views.path;
  if (!state.dialogs.views || path.keys.size() < 2) return;
  const auto on_screen = [&](const Camera& camera) {
    const PathPoint cell = cell_of(ground_of(state), camera.position);
    const PixelPoint at = pixel_of(state.view.map, canvas, double(cell.x), double(cell.y));
    return ImVec2(origin.x + float(at.x), origin.y + float(at.y));
  };
  const int pieces = 12 * int(path.keys.size());
  std::vector<ImVec2> line;
  for (int i = 0; i <= pieces; ++i) line.push_back(on_screen(camera_on_path(path, path_seconds(path) * i / pieces)));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddPolyline(line.data(), int(line.size()), IM_COL32(0, 0, 0, 150), 0, ui.theme.px(4));
  list.AddPolyline(line.data(), int(line.size()), IM_COL32(255, 255, 255, 230), 0, ui.theme.px(1.8F));
  for (const CameraKey& key : path.keys) {
    list.AddCircleFilled(on_screen(key.camera), ui.theme.px(4.5F), IM_COL32(0, 0, 0, 170), 16);
    list.AddCircleFilled(on_screen(key.camera), ui.theme.px(3), IM_COL32(255, 255, 255, 255), 16);
  }
}

bool shown(const EditorState& state) { return state.view.mode == ViewMode::split && state.view.camera_placed; }

}  // namespace

void draw_camera_mark(const UiContext& ui, ImDrawList& list, ImVec2 eye, float length) {
  const EditorState& state = ui.state;
  const float heading = state.view.camera.heading;
  const float half = half_width(state);
  constexpr int pieces = 10;
  for (int i = 0; i < pieces; ++i) {
    const ImVec2 a = toward(eye, heading - half + 2 * half * float(i) / pieces, length);
    const ImVec2 b = toward(eye, heading - half + 2 * half * float(i + 1) / pieces, length);
    list.AddTriangleFilled(eye, a, b, IM_COL32(255, 255, 255, 60));
  }
  const float dot = ui.theme.px(4.5F);
  for (const float side : {-half, half}) {
    const ImVec2 end = toward(eye, heading + side, length);
    list.AddLine(eye, end, IM_COL32(0, 0, 0, 120), ui.theme.px(2.5F));
    list.AddLine(eye, end, IM_COL32(255, 255, 255, 210), ui.theme.px(1));
  }
  list.AddCircleFilled(eye, dot + ui.theme.px(1.5F), IM_COL32(0, 0, 0, 150), 24);
  list.AddCircleFilled(eye, dot, colour_u32(ui.theme.accent), 24);
}

PathPoint camera_cell(const EditorState& state) { return cell_of(ground_of(state), state.view.camera.position); }

void move_camera_to(EditorState& state, PathPoint cell) {
  const Terrain& terrain = ground_of(state);
  Camera& camera = state.view.camera;
  const double above =
      camera.position.z - double(ground_height(terrain, std::clamp(camera.position.x, 0.0, terrain.width_metres()),
                                               std::clamp(camera.position.y, 0.0, terrain.height_metres())));
  glm::dvec3 place = place_of(terrain, cell);
  place.x = std::clamp(place.x, 0.0, terrain.width_metres());
  place.y = std::clamp(place.y, 0.0, terrain.height_metres());
  state.view.camera_untouched = false;
  take_camera(state);
  if (state.exploring.walking) {
    const WalkingGround ground{terrain, state.shown ? state.shown->hydrology.get() : nullptr};
    const glm::dvec2 at = standing_place(ground, {place.x, place.y});
    camera.position = {at.x, at.y, eye_level(ground, at)};
    return;
  }
  camera.position = {place.x, place.y, double(ground_height(terrain, place.x, place.y)) + std::max(above, 1.5)};
}

void aim_camera_at(EditorState& state, PathPoint cell) {
  const glm::dvec3 arm = place_of(ground_of(state), cell) - state.view.camera.position;
  if (std::hypot(arm.x, arm.y) < 1) return;
  take_camera(state);
  state.view.camera_untouched = false;
  Camera& camera = state.view.camera;
  camera = turned(camera, float(std::atan2(arm.x, arm.y) * 57.29577951) - camera.heading, 0);
}

bool CameraMark::handle(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered) {
  EditorState& state = ui.state;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) grip_ = Grip::none;
  if (!shown(state) || !state.document.terrain) return false;
  const PathPoint eye_cell = camera_cell(state);
  const PixelPoint eye = pixel_of(state.view.map, canvas, double(eye_cell.x), double(eye_cell.y));
  const ImVec2 tip = toward(ImVec2(float(eye.x), float(eye.y)), state.view.camera.heading, ui.theme.px(mark_length));
  const float reach = ui.theme.px(grip_reach);
  const bool free = state.tool == Tool::select && !state.placing.busy() && !ImGui::GetIO().KeyAlt;
  const Grip under = near(eye, pixel, reach)                              ? Grip::eye
                     : near({double(tip.x), double(tip.y)}, pixel, reach) ? Grip::aim
                                                                          : Grip::none;
  if (hovered && free && under != Grip::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (hovered && free && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) grip_ = under;
  if (grip_ == Grip::none) return false;
  if (ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    const PathPoint cell = cell_at(state.view.map, canvas, pixel);
    if (grip_ == Grip::eye) {
      move_camera_to(state, cell);
    } else {
      aim_camera_at(state, cell);
    }
  }
  return true;
}

void CameraMark::draw(const UiContext& ui, ImVec2 origin, PixelPoint canvas) const {
  const EditorState& state = ui.state;
  if (!state.document.terrain) return;
  draw_path(ui, origin, canvas);
  if (!shown(state)) return;
  const PathPoint cell = camera_cell(state);
  const PixelPoint at = pixel_of(state.view.map, canvas, double(cell.x), double(cell.y));
  draw_camera_mark(ui, *ImGui::GetWindowDrawList(), ImVec2(origin.x + float(at.x), origin.y + float(at.y)),
                   ui.theme.px(mark_length));
}

}  // namespace biotope
