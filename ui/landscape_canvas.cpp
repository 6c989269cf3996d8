#include "ui/landscape_canvas.hpp"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include "ui/camera_motion.hpp"
#include "ui/canvas_menu.hpp"
#include "ui/editor_actions.hpp"
#include "ui/map_furniture.hpp"
#include "ui/placing_overlay.hpp"
#include "ui/tool_gestures.hpp"

namespace biotope {
namespace {

constexpr double wanted_seconds = 1.0 / 24;  // of a moving picture; map and window take their share of the frame too
constexpr double coarsest = 0.4;             // share of the resolution below which one no longer sees what is there
constexpr double rest_seconds = 0.25;        // after which the picture is drawn sharp

bool same_camera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.heading == b.heading && a.pitch == b.pitch && a.vertical_field == b.vertical_field;
}

bool same_options(const LandscapeOptions& a, const LandscapeOptions& b) {
  return a.hour == b.hour && a.month == b.month && a.plants == b.plants && a.animals == b.animals && a.trails == b.trails &&
         a.water == b.water && a.quality == b.quality && a.weather == b.weather && a.seconds == b.seconds && a.visible_species == b.visible_species && a.brush == b.brush;
}

bool drawn_by_processor() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name != nullptr ? name : "";
  return renderer.find("llvmpipe") != std::string_view::npos || renderer.find("softpipe") != std::string_view::npos;
}

/// The ground as it is drawn.
const Terrain& ground_of(const EditorState& state) {
  const bool known = state.shown && state.shown->document.terrain == state.document.terrain;
  return known ? state.shown->terrain() : *state.document.terrain;
}

bool dragged(ImGuiMouseButton button) { return ImGui::IsMouseDragging(button, 0); }

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
  wanted.options.quality = state.settings.quality;
  wanted.options.visible_species = state.view.visible_species;
  if (under_pointer_ && is_brush(state.tool)) {
    const PathPoint cell = cell_of(ground_of(state), *under_pointer_);
    wanted.options.brush = glm::vec3(cell.x, cell.y, state.brush.radius);
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
  if (same && drawn_resolution_ >= resolution) return;
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
  if (software_) {
    glFinish();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    // What a full picture costs tells how coarse a moving one must be; half-way steps keep it from flickering.
    const double fitting = resolution * std::sqrt(wanted_seconds / std::max(seconds, 1e-4));
    resolution_ = std::clamp(0.5 * resolution_ + 0.5 * fitting, coarsest, 1.0);
    drawn_seconds_ = seconds;
  }
  drawn_ = std::move(wanted);
  drawn_resolution_ = resolution;
  drawn_at_ = ImGui::GetTime();
  has_picture_ = true;
}

void LandscapeCanvas::handle_wheel(const UiContext& ui, PixelPoint canvas, PixelPoint pixel) const {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0) return;
  EditorView& view = ui.state.view;
  const glm::dvec3 direction(ray_through(view.camera, canvas, pixel));
  const double away = under_pointer_ ? glm::length(*under_pointer_ - view.camera.position) : 200.0;
  view.camera.position += direction * std::max(away, 4.0) * (1 - std::pow(0.85, double(wheel)));
  view.camera_untouched = false;
}

void LandscapeCanvas::handle_fly_keys(const UiContext& ui) const {
  EditorState& state = ui.state;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.KeyAlt || io.WantTextInput) return;
  const auto held = [&](int key) { return io.KeysDown[key] ? 1.0 : 0.0; };
  const double right = held(GLFW_KEY_D) - held(GLFW_KEY_A);
  const double forward = held(GLFW_KEY_W) - held(GLFW_KEY_S);
  const double up = held(GLFW_KEY_E) - held(GLFW_KEY_Q);
  if (right == 0 && forward == 0 && up == 0) return;
  const Terrain& terrain = ground_of(state);
  const double ground = ground_height(terrain, std::clamp(state.view.camera.position.x, 0.0, terrain.width_metres()),
                                      std::clamp(state.view.camera.position.y, 0.0, terrain.height_metres()));
  // Faster the higher one flies.
  const double metres = std::clamp(state.view.camera.position.z - ground, 4.0, 4000.0) * (io.KeyShift ? 4.0 : 1.2) *
                        std::min(double(io.DeltaTime), 0.1);
  state.view.camera = moved(state.view.camera, right * metres, forward * metres, up * metres);
  state.view.camera_untouched = false;
}

void LandscapeCanvas::follow_stroke(const UiContext& ui, PixelPoint canvas) {
  EditorState& state = ui.state;
  const Terrain& terrain = ground_of(state);
  for (const auto& point : state.path.points) {
    const glm::vec3 ray = ray_through(state.view.camera, canvas, {point[0] - origin_.x, point[1] - origin_.y});
    const auto ground = pick_ground(terrain, state.view.camera.position, ray);
    if (!ground) continue;
    const PathPoint cell = cell_of(terrain, *ground);
    drag_tool(state, cell);
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

void LandscapeCanvas::draw_things(const UiContext& ui, ImVec2 origin, PixelPoint canvas) const {
  const EditorState& state = ui.state;
  // Lines over the picture are only wanted where one works on them.
  const bool works =
      state.view.tab == Tab::terrain || state.view.tab == Tab::trails || state.placing.busy() || state.herd_day.herd;
  if (!works) return;
  const Terrain& ground = state.shown->terrain();
  const auto project = [&](PathPoint cell) -> std::optional<ImVec2> {
    const auto at = pixel_of(state.view.camera, canvas, place_of(ground, cell));
    if (!at) return std::nullopt;
    return ImVec2(origin.x + float(at->x), origin.y + float(at->y));
  };
  const auto pointer = under_pointer_ ? std::optional(cell_of(ground, *under_pointer_)) : std::nullopt;
  draw_placed(ui, project, 0, pointer);
}

void LandscapeCanvas::handle_tool(const UiContext& ui, PixelPoint canvas, bool hovered) {
  EditorState& state = ui.state;
  const ImGuiIO& io = ImGui::GetIO();
  if (paints_ && tool_active(state)) {
    follow_stroke(ui, canvas);
    return;
  }
  const auto place = under_pointer_ ? std::optional(cell_of(ground_of(state), *under_pointer_)) : std::nullopt;
  if (handle_placing(ui, place, reach_at_pointer(ui, canvas), hovered)) return;
  if (!hovered || !under_pointer_) return;
  const PathPoint cell = cell_of(ground_of(state), *under_pointer_);
  const int x = int(std::lround(cell.x));
  const int y = int(std::lround(cell.y));
  if (state.tool != Tool::select && !io.KeyAlt && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    press_tool(state, cell, {io.KeyCtrl, io.KeyShift});
    paints_ = tool_active(state);
    if (paints_) follow_stroke(ui, canvas);
    return;
  }
  const float still = 16 * io.MouseDragThreshold;
  if (state.tool == Tool::select && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && io.MouseDragMaxDistanceSqr[0] < still) {
    const float herd_reach = std::max(reach_at_pointer(ui, canvas) * 1.4F, float(20 / ground_of(state).cell_size));
    if (!choose_herd(state, cell, herd_reach)) ask_why(state, x, y);
  }
  if (ImGui::IsMouseReleased(ImGuiMouseButton_Right) && io.MouseDragMaxDistanceSqr[1] < still) {
    asked_ = cell;
    ImGui::OpenPopup("landscape menu");
  }
}

void LandscapeCanvas::handle_mouse(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered, bool active) {
  EditorState& state = ui.state;
  const Terrain& terrain = ground_of(state);
  const ImGuiIO& io = ImGui::GetIO();
  const bool moving = active && (dragged(ImGuiMouseButton_Right) || dragged(ImGuiMouseButton_Middle) || io.KeyAlt);
  if ((hovered || active) && !moving) {
    under_pointer_ = pick_ground(terrain, state.view.camera.position, ray_through(state.view.camera, canvas, pixel));
  } else if (!moving) {
    under_pointer_.reset();
  }
  if (hovered && under_pointer_) {
    const PathPoint cell = cell_of(terrain, *under_pointer_);
    state.pointer = {true, cell.x, cell.y};
  }
  const bool orbits = active && dragged(ImGuiMouseButton_Left) &&
                      (io.KeyAlt || (state.tool == Tool::select && !state.placing.busy() && state.herd_day.held_stop < 0));
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) pivot_.reset();
  if (orbits) {
    if (!pivot_) {
      const PixelPoint middle{canvas.x / 2, canvas.y / 2};
      pivot_ = pick_ground(terrain, state.view.camera.position, ray_through(state.view.camera, canvas, middle));
      if (!pivot_) pivot_ = state.view.camera.position + glm::dvec3(state.view.camera.forward()) * 500.0;
    }
    state.view.camera = orbited(state.view.camera, *pivot_, io.MouseDelta.x * 0.3F, -io.MouseDelta.y * 0.3F);
  } else if (active && dragged(ImGuiMouseButton_Right)) {
    state.view.camera = turned(state.view.camera, io.MouseDelta.x * 0.2F, -io.MouseDelta.y * 0.2F);
  } else if (active && dragged(ImGuiMouseButton_Middle)) {
    const double away = under_pointer_ ? glm::length(*under_pointer_ - state.view.camera.position) : 300.0;
    const double metres = 2 * away * std::tan(state.view.camera.vertical_field * 0.00872665) / canvas.y;
    const Camera level = moved(state.view.camera, -io.MouseDelta.x * metres, 0, 0);
    state.view.camera = level;
    const glm::dvec3 up = glm::cross(glm::dvec3(level.right()), glm::dvec3(level.forward()));
    state.view.camera.position += up * (io.MouseDelta.y * metres);
  }
  if (active && (orbits || dragged(ImGuiMouseButton_Right) || dragged(ImGuiMouseButton_Middle)))
    state.view.camera_untouched = false;
  if (hovered) handle_wheel(ui, canvas, pixel);
  takes_letters_ = hovered || active;
  if (takes_letters_) handle_fly_keys(ui);
  state.view.camera = kept_over_ground(state.view.camera, terrain);
  handle_tool(ui, canvas, hovered);
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
  ImGui::InvisibleButton(
      "landscape canvas", ImVec2(float(width), float(height)),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  const bool active = ImGui::IsItemActive();
  const ImVec2 end(origin.x + float(width), origin.y + float(height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!state.document.terrain || !state.shown) {
    list.AddRectFilled(origin, end, colour_u32(ui.theme.window));
    return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  handle_mouse(ui, canvas, {mouse.x - origin.x, mouse.y - origin.y}, hovered, active);
  draw_picture(ui, width, height);
  list.PushClipRect(origin, end, true);
  const auto texture = reinterpret_cast<ImTextureID>(std::uintptr_t(target_->texture()));
  list.AddImage(texture, origin, end, ImVec2(0, 1), ImVec2(1, 0));
  draw_things(ui, origin, canvas);
  draw_north_arrow(ui.theme, origin, size, state.view.camera.heading);
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
