#include "ui/landscape_canvas.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "ui/camera_motion.hpp"
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

constexpr double wanted_seconds = 1.0 / 24;  // of a moving picture; map and window take their share of the frame too
constexpr double coarsest = 0.4;             // share of the resolution below which one no longer sees what is there
constexpr double longest_seconds = 36000;    // after which what moves begins again: waves need exact times
constexpr std::size_t pictures_to_measure = 3;
constexpr double slice_seconds = 0.02;  // of a frame for pictures into files
constexpr double rest_seconds = 0.25;   // after which the picture is drawn sharp

bool same_camera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.heading == b.heading && a.pitch == b.pitch && a.vertical_field == b.vertical_field;
}

bool same_options(const LandscapeOptions& a, const LandscapeOptions& b) {
  return a.hour == b.hour && a.month == b.month && a.plants == b.plants && a.animals == b.animals && a.trails == b.trails &&
         a.water == b.water && a.quality == b.quality && a.weather == b.weather && a.seconds == b.seconds &&
         a.visible_species == b.visible_species && a.brush == b.brush;
}

}  // namespace

Result<std::unique_ptr<LandscapeCanvas>> LandscapeCanvas::create() {
  auto renderer = LandscapeRenderer::create();
  if (!renderer) return tl::unexpected(renderer.error());
  return std::unique_ptr<LandscapeCanvas>(new LandscapeCanvas(std::move(*renderer)));
}

LandscapeCanvas::LandscapeCanvas(std::unique_ptr<LandscapeRenderer> renderer)
    : renderer_(std::move(renderer)), target_(std::make_unique<RenderTarget>(16, 16)), software_(drawn_by_processor()) {
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
  measuring_ = !software_ && measured_seconds_.size() < pictures_to_measure;
  state.view.quality = quality_factor(measuring_ ? QualityLevel::low : measured_level(measured_seconds_, software_));
}

void LandscapeCanvas::draw_picture(const UiContext& ui, int width, int height) {
  EditorState& state = ui.state;
  // A new ground is shown at once and what lives on it when all of it is known: a picture of each snapshot in between would only
  // keep the processor from the next.
  const bool takes =
      state.shown->complete || !drawn_.snapshot || drawn_.snapshot->document.terrain != state.shown->document.terrain;
  Picture wanted{state.view.camera, {}, takes ? state.shown : drawn_.snapshot, width, height};
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
  if (is_brush(state.tool) && state.pointer.over_map) {
    wanted.options.brush = glm::vec3(state.pointer.x, state.pointer.y, state.brush.radius);
  }
  const double now = ImGui::GetTime();
  renderer_->set_snapshot(wanted.snapshot);
  const bool news = renderer_->bring_in(wanted.options);
  const bool same = has_picture_ && !news && same_camera(wanted.camera, drawn_.camera) &&
                    same_options(wanted.options, drawn_.options) && wanted.snapshot == drawn_.snapshot && width == drawn_.width &&
                    height == drawn_.height;
  if (!same) last_change_ = now;
  // Plants that are still being built come in quickly on a coarse picture; the sharp one follows.
  const bool complete = has_picture_ && renderer_->complete();
  const bool resting = now - last_change_ > rest_seconds && complete;
  const double resolution = software_ && !resting ? resolution_ : 1.0;
  refining_ = (software_ && !resting && resolution < 1) || !complete;
  const bool measures = measuring_ && complete && state.shown->complete;
  if (same && drawn_resolution_ >= resolution && !measures) return;
  // A picture that takes long even when it is coarse is drawn less often, so that the rest of the window keeps its pace.
  const bool moves_slowly = software_ && has_picture_ && width == drawn_.width && height == drawn_.height && !resting;
  if (moves_slowly && now - drawn_at_ < 1.5 * drawn_seconds_) {
    refining_ = true;
    return;
  }
  const int target_width = std::max(int(width * resolution), 16);
  const int target_height = std::max(int(height * resolution), 16);
  target_->resize(target_width, target_height);
  const auto begin = std::chrono::steady_clock::now();
  target_->bind();
  renderer_->draw(wanted.camera, wanted.options, target_width, target_height);
  if (software_ || measures) glFinish();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (measures) measured_seconds_.push_back(seconds);
  refining_ = refining_ || measuring_;
  if (software_) {
    // What a full picture costs tells how coarse a moving one must be; half-way steps keep it from flickering.
    const double fitting = resolution * std::sqrt(wanted_seconds / std::max(seconds, 1e-4));
    resolution_ = std::clamp(0.5 * resolution_ + 0.5 * fitting, coarsest, 1.0);
  }
  drawn_seconds_ = software_ || measures ? seconds : 0;
  drawn_ = std::move(wanted);
  drawn_resolution_ = resolution;
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

void LandscapeCanvas::draw_things(const UiContext& ui, ImVec2 origin, PixelPoint canvas) {
  const EditorState& state = ui.state;
  const Terrain& ground = state.shown->terrain();
  const ScreenPlace project = [&](PathPoint cell) -> std::optional<ImVec2> {
    const auto at = pixel_of(state.view.camera, canvas, place_of(ground, cell));
    if (!at) return std::nullopt;
    return ImVec2(origin.x + float(at->x), origin.y + float(at->y));
  };
  outline_.draw(ui, project);
  if (state.gesture) {
    const float step = float(std::max(ground.height.width(), ground.height.height())) / 256;
    draw_gesture(*ImGui::GetWindowDrawList(), ui.theme, *state.gesture, project, step);
  }
  // Other lines over the picture are only wanted where one works on them.
  const bool works =
      state.view.tab == Tab::terrain || state.view.tab == Tab::trails || state.placing.busy() ||
      (state.herd_day.herd && !state.exploring.following && !state.exploring.walking && state.pictures.playing < 0);
  if (!works) return;
  const auto pointer = under_pointer_ ? std::optional(cell_of(ground, *under_pointer_)) : std::nullopt;
  draw_placed(ui, project, 0, pointer);
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
  if (handle_placing(ui, place, reach_at_pointer(ui, canvas), hovered)) return;
  const float still = 16 * io.MouseDragThreshold;
  const bool clicked = hovered && pressed_here && released && io.MouseDragMaxDistanceSqr[0] < still;
  if (state.tool == Tool::select && clicked) {
    const float herd_reach = std::max(reach_at_pointer(ui, canvas) * 1.4F, float(20 / ground_of(state).cell_size));
    const PixelPoint pixel{double(io.MousePos.x - origin_.x), double(io.MousePos.y - origin_.y)};
    const auto animals = draws_shown_plans(state) ? renderer_->animals() : std::span<const AnimalAt>();
    click_landscape(state,
                    {ray_through(state.view.camera, canvas, pixel), under_pointer_, herd_reach, animals, &renderer_->plants()});
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

void LandscapeCanvas::draw(const UiContext& ui, ImVec2 size) {
  EditorState& state = ui.state;
  const int width = std::max(int(size.x), 16);
  const int height = std::max(int(size.y), 16);
  const PixelPoint canvas{double(width), double(height)};
  takes_letters_ = false;
  place_camera(state);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  origin_ = origin;
  state.exploring.aspect = float(width) / float(height);
  mini_map_.handle(ui, origin, size);
  ImGui::InvisibleButton(
      "landscape canvas", ImVec2(float(width), float(height)),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  if (ImGui::IsItemActivated()) pressed_here_ = true;
  const bool hovered = ImGui::IsItemHovered();
  const bool active = ImGui::IsItemActive();
  const ImVec2 end(origin.x + float(width), origin.y + float(height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!state.document.terrain || !state.shown) {
    list.AddRectFilled(origin, end, colour_u32(ui.theme.window));
    return;
  }
  state.view.software = software_;
  follow_quality(state);
  const auto passed = double(ImGui::GetIO().DeltaTime);
  state.exploring.followed = followed_place(state);
  moving_ = advance_path(state, passed) || advance_exploring(state, passed);
  if (moves_by_itself(state)) {
    state.view.seconds = std::fmod(state.view.seconds + std::min(passed, 0.25), longest_seconds);
    moving_ = true;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  handle_mouse(ui, canvas, {mouse.x - origin.x, mouse.y - origin.y}, hovered, active);
  draw_picture(ui, width, height);
  list.PushClipRect(origin, end, true);
  const auto texture = reinterpret_cast<ImTextureID>(std::uintptr_t(target_->texture()));
  list.AddImage(texture, origin, end, ImVec2(0, 1), ImVec2(1, 0));
  draw_things(ui, origin, canvas);
  draw_north_arrow(ui.theme, origin, size, state.view.camera.heading);
  mini_map_.draw(ui);
  draw_mode_badge(ui, origin, size);
  if (state.view.statistics) {
    const LandscapeStatistics& drawn = renderer_->statistics();
    draw_figures(ui, ImVec2(origin.x + ui.theme.px(10), origin.y + ui.theme.px(10)),
                 {drawn.plants, drawn.animals, drawn.triangles, drawn.draw_calls, drawn.instance_bytes, target_->width(),
                  target_->height(), drawn_seconds_});
  }
  list.PopClipRect();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.theme.px(8), ui.theme.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.theme.px(10), ui.theme.px(6)));
  if (ImGui::BeginPopup("landscape menu")) {
    draw_cell_menu(ui, int(std::lround(asked_.x)), int(std::lround(asked_.y)));
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace biotope
