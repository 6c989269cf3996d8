#include "ui/landscape_canvas.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "ui/brush_marks.hpp"
#include "ui/brush_ring.hpp"
#include "ui/camera_motion.hpp"
#include "ui/camera_path.hpp"
#include "ui/canvas_menu.hpp"
#include "ui/editor_actions.hpp"
#include "ui/exploring.hpp"
#include "ui/landscape_click.hpp"
#include "ui/map_furniture.hpp"
#include "ui/mode_badge.hpp"
#include "ui/placing_overlay.hpp"
#include "ui/quality.hpp"
#include "ui/tool_gestures.hpp"
#include "ui/weather_control.hpp"

namespace biotope {
namespace {

constexpr double longest_seconds = 36000;  // after which what moves begins again: waves need exact times
constexpr std::size_t pictures_to_measure = 3;
constexpr double slice_seconds = 0.02;  // of a frame for pictures into files

}  // namespace

Result<std::unique_ptr<LandscapeCanvas>> LandscapeCanvas::create() {
  auto renderer = LandscapeRenderer::create();
  if (!renderer) return tl::unexpected(renderer.error());
  auto overlay = LandscapeOverlay::create();
  if (!overlay) return tl::unexpected(overlay.error());
  auto drape = LandscapeDrape::create();
  if (!drape) return tl::unexpected(drape.error());
  return std::unique_ptr<LandscapeCanvas>(new LandscapeCanvas(std::move(*renderer), std::move(*overlay), std::move(*drape)));
}

LandscapeCanvas::LandscapeCanvas(std::unique_ptr<LandscapeRenderer> renderer, LandscapeOverlay overlay, LandscapeDrape drape)
    : renderer_(std::move(renderer)),
      overlay_(std::move(overlay)),
      drape_(std::move(drape)),
      target_(std::make_unique<RenderTarget>(16, 16)),
      software_(drawn_by_processor()) {
  if (software_) resolution_ = 0.5;
}

void LandscapeCanvas::place_camera(EditorState& state) {
  if (!state.shown || !state.shown->document.terrain) return;
  if (state.view.camera_untouched && state.shown->hydrology) {
    if (placed_for_ == state.shown->revision && state.view.camera_placed) return;
    placed_for_ = state.shown->revision;
    state.view.camera = first_view(*state.shown);
    state.view.camera_untouched = !state.shown->complete;
    state.view.camera_placed = true;
  } else if (!state.view.camera_placed) {
    state.view.camera = overview(*state.shown);
    state.view.camera_placed = true;
  }
}

bool LandscapeCanvas::draws_shown_plans(const EditorState& state) const {
  return drawn_.snapshot && drawn_.snapshot->plans == state.shown->plans;
}

std::optional<glm::dvec3> LandscapeCanvas::followed_place(const EditorState& state) {
  const Exploring& exploring = state.exploring;
  const DailyPlan* plan = exploring.following ? chosen_plan(state) : nullptr;
  if (plan == nullptr) return std::nullopt;
  // Numbers of animals are of the plans in the picture.
  if (exploring.member >= 0 && draws_shown_plans(state)) {
    const auto animal = renderer_->animal(int(plan - state.shown->plans->data()), exploring.member, state.clock.hour);
    if (animal) return animal->place;
  }
  return chosen_herd_place(state);
}

void LandscapeCanvas::follow_quality(EditorState& state) {
  const QualityLevel level = state.settings.quality_level;
  measuring_ = false;
  if (level != QualityLevel::automatic) {
    measured_seconds_.clear();
    state.view.quality = quality_factor(level);
    return;
  }
  // What has been measured at low holds for the rest of the session.
  measuring_ = measured_seconds_.size() < pictures_to_measure;
  state.view.quality = quality_factor(measuring_ ? QualityLevel::low : measured_level(measured_seconds_, software_));
}

LandscapeCanvas::Picture LandscapeCanvas::wanted_picture(const EditorState& state, int width, int height) const {
  Picture wanted{state.view.camera, {}, state.pictured ? state.pictured : state.shown, width, height};
  wanted.options.hour = state.clock.hour;
  wanted.options.month = state.clock.month;
  wanted.options.plants = state.view.plants;
  wanted.options.animals = state.view.herds;
  wanted.options.trails = state.view.trails;
  wanted.options.water = state.view.water;
  wanted.options.quality = state.view.quality;
  wanted.options.visible_species = state.view.visible_species;
  wanted.options.weather = state.settings.weather;
  wanted.options.seconds = state.view.seconds;
  // The ring follows the pointer over the map too.
  wanted.options.brush = ring_in_landscape(state);
  return wanted;
}

void LandscapeCanvas::draw_picture(const EditorState& state, int width, int height) {
  Picture wanted = wanted_picture(state, width, height);
  await_answer(state, *wanted.snapshot);
  renderer_->set_snapshot(wanted.snapshot);
  const bool news = renderer_->bring_in(wanted.options);
  const auto resolution = resolution_now(state, wanted, news);
  if (!resolution) return;
  const int target_width = std::max(int(width * *resolution), 16);
  const int target_height = std::max(int(height * *resolution), 16);
  target_->resize(target_width, target_height);
  const auto begin = std::chrono::steady_clock::now();
  target_->bind();
  renderer_->draw(wanted.camera, wanted.options, target_width, target_height);
  if (software_ || measures_now_) glFinish();
  learn_from(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), *resolution);
  drawn_ = std::move(wanted);
  drawn_resolution_ = *resolution;
  waits_since_ = -1;
  drawn_at_ = ImGui::GetTime();
  has_picture_ = true;
}

void LandscapeCanvas::follow_stroke(const UiContext& ui, PixelPoint canvas) {
  EditorState& state = ui.state;
  const Terrain& terrain = ground_of(state);
  for (const auto& point : state.path.points) {
    const glm::vec3 ray = ray_through(state.view.camera, canvas, {point[0] - origin_.x, point[1] - origin_.y});
    const auto ground = pick_ground(terrain, state.view.camera.position, ray);
    if (!ground) continue;
    const PathPoint cell = cell_of(terrain, *ground);
    drag_tool(state, cell, point[2]);
  }
  state.path.points.clear();
  if (state.path.held) return;
  release_tool(state);
  paints_ = false;
}

float LandscapeCanvas::reach_at_pointer(const UiContext& ui, PixelPoint canvas) const {
  if (!under_pointer_) return 0;
  const Camera& camera = ui.state.view.camera;
  const double away = glm::length(*under_pointer_ - camera.position);
  const double metres_a_pixel = 2 * away * std::tan(camera.vertical_field * 0.00872665) / canvas.y;
  return float(metres_a_pixel * double(ui.theme.px(9)) / ui.state.document.terrain->cell_size);
}

void LandscapeCanvas::draw_camera_path(const EditorState& state) {
  const CameraPath& path = state.views.path;
  if (!state.dialogs.views || path.keys.size() < 2 || state.pictures.playing >= 0) return;
  const int pieces = 12 * int(path.keys.size());
  std::vector<glm::dvec3> way;
  for (int i = 0; i <= pieces; ++i) way.push_back(camera_on_path(path, path_seconds(path) * i / pieces).position);
  overlay_.add_way(way, {IM_COL32(255, 255, 255, 230), 1.8F, IM_COL32(0, 0, 0, 150), 1});
}

void LandscapeCanvas::draw_things(const UiContext& ui, ImVec2 origin, ImVec2 size) {
  if (!has_picture_) return;
  const EditorState& state = ui.state;
  const Terrain& ground = state.shown->terrain();
  const glm::vec2 planes = renderer_->depth_planes();
  // As the camera saw them that took the picture: on a slow machine it may be an earlier one.
  const LandscapeOverlay::Picture picture{
      drawn_.camera, {target_->depth_texture(), planes.x, planes.y}, origin, size, ui.theme.scale};
  drape_.draw(ui, *ImGui::GetWindowDrawList(), picture, target_->texture());
  overlay_.begin(*ImGui::GetWindowDrawList(), picture);
  const ViewPen pen = overlay_.pen(ground);
  outline_.draw(ui, pen);
  if (state.gesture) draw_gesture(*ImGui::GetWindowDrawList(), ui.theme, *state.gesture, pen);
  if (under_pointer_) draw_brush_marks(*ImGui::GetWindowDrawList(), ui.theme, state, pen, cell_of(ground, *under_pointer_));
  // The ground's own ring is hidden by plants; this one shines through them.
  if (const auto ring = ring_in_landscape(state))
    pen.line(ring_around({ring->x, ring->y}, ring->z), {IM_COL32(255, 255, 255, 200), 1.2F, IM_COL32(0, 0, 0, 90), 0.6F});
  draw_camera_path(state);
  // Other lines over the picture are only wanted where one works on them.
  const bool works =
      state.view.tab == Tab::terrain || state.view.tab == Tab::trails || state.placing.busy() ||
      (state.herd_day.herd && !state.exploring.following && !state.exploring.walking && state.pictures.playing < 0);
  if (!works) return;
  const auto pointer = under_pointer_ ? std::optional(cell_of(ground, *under_pointer_)) : std::nullopt;
  draw_placed(ui, pen, pointer);
}

void LandscapeCanvas::handle_tool(const UiContext& ui, PixelPoint canvas, bool hovered) {
  EditorState& state = ui.state;
  const ImGuiIO& io = ImGui::GetIO();
  const bool released = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  const bool pressed_here = released ? std::exchange(pressed_here_, false) : pressed_here_;
  if (paints_ && tool_active(state)) {
    follow_stroke(ui, canvas);
    return;
  }
  const auto place = under_pointer_ ? std::optional(cell_of(ground_of(state), *under_pointer_)) : std::nullopt;
  if (handle_placing(ui, PlacingView::landscape, place, reach_at_pointer(ui, canvas), hovered)) return;
  const float still = 16 * io.MouseDragThreshold;
  const bool clicked = hovered && pressed_here && released && io.MouseDragMaxDistanceSqr[0] < still;
  if (state.tool == Tool::select && clicked) {
    const float herd_reach = std::max(reach_at_pointer(ui, canvas) * 1.4F, float(20 / ground_of(state).cell_size));
    const PixelPoint pixel{double(io.MousePos.x - origin_.x), double(io.MousePos.y - origin_.y)};
    const auto animals = draws_shown_plans(state) ? renderer_->animals() : std::span<const AnimalAt>();
    const Camera& camera = has_picture_ ? drawn_.camera : state.view.camera;
    click_landscape(
        state, {camera.position, ray_through(camera, canvas, pixel), under_pointer_, herd_reach, animals, &renderer_->plants()});
    return;
  }
  if (!hovered || !under_pointer_) return;
  const PathPoint cell = cell_of(ground_of(state), *under_pointer_);
  if (state.tool != Tool::select && !io.KeyAlt && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    press_tool(state, cell, {io.KeyCtrl, io.KeyShift, state.path.points.empty() ? 1.0F : state.path.points.front()[2]});
    paints_ = tool_active(state);
    if (paints_) follow_stroke(ui, canvas);
    return;
  }
  if (ImGui::IsMouseReleased(ImGuiMouseButton_Right) && io.MouseDragMaxDistanceSqr[1] < still) {
    asked_ = cell;
    ImGui::OpenPopup("landscape menu");
  }
}

void LandscapeCanvas::handle_mouse(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered, bool active) {
  EditorState& state = ui.state;
  const Terrain& terrain = ground_of(state);
  const bool moving = CameraGestures::dragging({canvas, pixel, under_pointer_, hovered, active});
  if ((hovered || active) && !moving) {
    under_pointer_ = pick_ground(terrain, state.view.camera.position, ray_through(state.view.camera, canvas, pixel));
  } else if (!moving) {
    under_pointer_.reset();
  }
  state.exploring.pointer.reset();
  if (hovered && under_pointer_) {
    const PathPoint cell = cell_of(terrain, *under_pointer_);
    state.pointer = {true, cell.x, cell.y};
    state.exploring.pointer = cell;
    state.exploring.ring_out_of_sight =
        is_brush(state.tool) &&
        !ring_in_picture(terrain, state.view.camera, {float(canvas.x), float(canvas.y)}, cell, state.brush.radius);
  }
  takes_letters_ = hovered || active;
  gestures_.handle(ui, {canvas, pixel, under_pointer_, hovered, active});
  moving_ = moving_ || gestures_.moved_by_gamepad();
  handle_tool(ui, canvas, hovered);
}

void LandscapeCanvas::make_pictures(EditorState& state) {
  PictureSession& pictures = state.pictures;
  if (const auto wanted = std::exchange(pictures.order, nullptr)) exporter_.start(*wanted);
  if (std::exchange(pictures.wants_cancel, false) && exporter_.running()) {
    exporter_.cancel();
    announce(state, "Stopped");
  }
  exporter_.advance(slice_seconds);
  if (const auto result = exporter_.take_result()) {
    if (*result) {
      announce(state, "Saved " + exporter_.out().string());
    } else {
      complain(state, "The picture could not be made", result->error());
    }
  }
  pictures.running = exporter_.running();
  pictures.fraction = exporter_.fraction();
  pictures.stage = exporter_.stage();
}

void LandscapeCanvas::advance(EditorState& state) {
  state.view.software = software_;
  follow_quality(state);
  const auto passed = double(ImGui::GetIO().DeltaTime);
  state.exploring.plants = state.view.plants ? renderer_->plants() : PlantPlacement();
  state.exploring.followed = followed_place(state);
  moving_ = advance_path(state, passed) || advance_exploring(state, passed);
  if (!moves_by_itself(state)) return;
  state.view.seconds = std::fmod(state.view.seconds + std::min(passed, 0.25), longest_seconds);
  moving_ = true;
}

void LandscapeCanvas::draw_over(const UiContext& ui, ImVec2 origin, ImVec2 size) {
  draw_things(ui, origin, size);
  draw_north_arrow(ui.theme, origin, size, ui.state.view.camera.heading);
  mini_map_.draw(ui);
  draw_mode_badge(ui, origin, size);
  if (!ui.state.view.statistics) return;
  const LandscapeStatistics& drawn = renderer_->statistics();
  draw_figures(ui, ImVec2(origin.x + ui.theme.px(10), origin.y + ui.theme.px(10)),
               {drawn.plants, drawn.animals, drawn.triangles, drawn.draw_calls, drawn.instance_bytes, drawn.most_instance_bytes,
                target_->width(), target_->height(), drawn_seconds_});
}

void LandscapeCanvas::draw_menu(const UiContext& ui) const {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(8), ui.theme.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(10), ui.theme.px(6)));
  if (ImGui::BeginPopup("landscape menu")) {
    draw_cell_menu(ui, int(std::lround(asked_.x)), int(std::lround(asked_.y)));
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

void LandscapeCanvas::draw(const UiContext& ui, ImVec2 size) {
  EditorState& state = ui.state;
  const int width = std::max(int(size.x), 16);
  const int height = std::max(int(size.y), 16);
  const PixelPoint canvas{double(width), double(height)};
  takes_letters_ = false;
  state.exploring.ring_out_of_sight = false;
  place_camera(state);
  origin_ = ImGui::GetCursorScreenPos();
  state.exploring.aspect = float(width) / float(height);
  mini_map_.handle(ui, origin_, size);
  ImGui::InvisibleButton(
      "landscape canvas", ImVec2(float(width), float(height)),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  if (ImGui::IsItemActivated()) pressed_here_ = true;
  const bool hovered = ImGui::IsItemHovered();
  const bool active = ImGui::IsItemActive();
  const ImVec2 end(origin_.x + float(width), origin_.y + float(height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!state.document.terrain || !state.shown) {
    list.AddRectFilled(origin_, end, colour_u32(ui.theme.window));
    return;
  }
  advance(state);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  handle_mouse(ui, canvas, {mouse.x - origin_.x, mouse.y - origin_.y}, hovered, active);
  // What was painted is computed while the picture is drawn.
  post_edits(state);
  draw_picture(state, width, height);
  list.PushClipRect(origin_, end, true);
  const auto texture = reinterpret_cast<ImTextureID>(std::uintptr_t(target_->texture()));
  list.AddImage(texture, origin_, end, ImVec2(0, 1), ImVec2(1, 0));
  draw_over(ui, origin_, size);
  list.PopClipRect();
  draw_menu(ui);
}

}  // namespace biotope
