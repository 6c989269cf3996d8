#include "ui/camera_gestures.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "render/landscape_renderer.hpp"
#include "ui/camera_motion.hpp"
#include "ui/exploring.hpp"
#include "ui/walking.hpp"

namespace biotope {
namespace {

constexpr float orbit_rate = 0.3F;  // degrees a pixel
constexpr float look_rate = 0.2F;
constexpr float turning_rate = 110;  // degrees a second, of a stick held to its end

/// Held and moved. What the pointer moved in the frame of the press came before it, and a trembling click is no drag.
bool dragged(ImGuiMouseButton button) { return ImGui::IsMouseDragging(button, 3) && !ImGui::IsMouseClicked(button); }

/// The left button moves the camera instead of working on something.
bool left_moves(const EditorState& state) {
  const bool free = state.tool == Tool::select && !state.placing.busy() && state.herd_day.held_stop < 0;
  return ImGui::GetIO().KeyAlt || free;
}

void look(EditorState& state) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  state.view.camera = turned(state.view.camera, moved.x * look_rate, -moved.y * look_rate);
}

}  // namespace

MoveKeys held_move_keys() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl || io.KeyAlt || io.WantTextInput) return {};
  const auto held = [&](int key) { return io.KeysDown[key] ? 1.0 : 0.0; };
  return {held(GLFW_KEY_D) - held(GLFW_KEY_A), held(GLFW_KEY_W) - held(GLFW_KEY_S), held(GLFW_KEY_E) - held(GLFW_KEY_Q),
          io.KeyShift};
}

bool CameraGestures::dragging(const Pointer& pointer) {
  return pointer.active && (dragged(ImGuiMouseButton_Right) || dragged(ImGuiMouseButton_Middle) || ImGui::GetIO().KeyAlt);
}

void CameraGestures::orbit(const UiContext& ui, const Pointer& pointer) {
  EditorState& state = ui.state;
  if (state.exploring.following) {
    // Around the herd, wherever it has gone.
    pivot_ = state.exploring.followed;
  } else if (!pivot_) {
    const PixelPoint middle{pointer.canvas.x / 2, pointer.canvas.y / 2};
    pivot_ = pick_ground(ground_of(state), state.view.camera.position, ray_through(state.view.camera, pointer.canvas, middle));
  }
  if (!pivot_) pivot_ = state.view.camera.position + glm::dvec3(state.view.camera.forward()) * 500.0;
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  state.view.camera = orbited(state.view.camera, *pivot_, moved.x * orbit_rate, -moved.y * orbit_rate);
}

void CameraGestures::pan(const UiContext& ui, const Pointer& pointer) {
  Camera& camera = ui.state.view.camera;
  const ImVec2 hand = ImGui::GetIO().MouseDelta;
  const double away = pointer.ground ? glm::length(*pointer.ground - camera.position) : 300.0;
  const double metres = 2 * away * std::tan(camera.vertical_field * 0.00872665) / pointer.canvas.y;
  camera = moved(camera, -hand.x * metres, 0, 0);
  const glm::dvec3 up = glm::cross(glm::dvec3(camera.right()), glm::dvec3(camera.forward()));
  camera.position += up * (hand.y * metres);
}

void CameraGestures::dolly(const UiContext& ui, const Pointer& pointer) {
  const float wheel = ImGui::GetIO().MouseWheel;
  EditorState& state = ui.state;
  if (wheel == 0 || state.exploring.walking) return;
  Camera& camera = state.view.camera;
  const double part = 1 - std::pow(0.85, double(wheel));
  const auto herd = state.exploring.following ? state.exploring.followed : std::nullopt;
  if (herd) {
    const glm::dvec3 arm = *herd - camera.position;
    if (part < 0 || glm::length(arm) > 6) camera.position += arm * part;
  } else {
    const glm::dvec3 direction(ray_through(camera, pointer.canvas, pointer.pixel));
    const double away = pointer.ground ? glm::length(*pointer.ground - camera.position) : 200.0;
    camera.position += direction * std::max(away, 4.0) * part;
  }
  state.view.camera_untouched = false;
}

void CameraGestures::use_gamepad(const UiContext& ui, MoveKeys& held) {
  const GamepadSticks sticks = gamepad_.read();
  moved_by_gamepad_ = sticks.any();
  if (!moved_by_gamepad_) return;
  EditorState& state = ui.state;
  const auto run_command = [&](const char* id) {
    if (const EditorCommand* command = ui.commands.find(id)) run(*command, state);
  };
  if (sticks.toggles_walking) run_command("explore.walk");
  if (sticks.follows_herd) run_command("explore.follow");
  if (sticks.bookmarks) run_command("explore.bookmark");
  const float degrees = turning_rate * std::min(ImGui::GetIO().DeltaTime, 0.1F);
  if (sticks.look_right != 0 || sticks.look_up != 0) {
    state.view.camera_untouched = false;
    state.view.camera = turned(state.view.camera, float(sticks.look_right) * degrees, float(sticks.look_up) * degrees);
    keep_arm(state);
  }
  held.right += sticks.move_right;
  held.ahead += sticks.move_ahead;
  held.up += sticks.rise;
  held.fast = held.fast || sticks.fast;
}

void CameraGestures::fly(const UiContext& ui, const MoveKeys& held) {
  EditorState& state = ui.state;
  if (!held.any()) return;
  take_camera(state);
  const Terrain& terrain = ground_of(state);
  Camera& camera = state.view.camera;
  const double ground = ground_height(terrain, std::clamp(camera.position.x, 0.0, terrain.width_metres()),
                                      std::clamp(camera.position.y, 0.0, terrain.height_metres()));
  // Faster the higher one flies.
  const double metres = std::clamp(camera.position.z - ground, 4.0, 4000.0) * (held.fast ? 4.0 : 1.2) *
                        std::min(double(ImGui::GetIO().DeltaTime), 0.1);
  camera = moved(camera, held.right * metres, held.ahead * metres, held.up * metres);
  state.view.camera_untouched = false;
}

void CameraGestures::walk(const UiContext& ui, const MoveKeys& held) {
  EditorState& state = ui.state;
  const double seconds = std::min(double(ImGui::GetIO().DeltaTime), 0.25);
  const double length = std::max(1.0, std::hypot(held.right, held.ahead));
  const double metres = (held.fast ? pace_running : pace_on_foot) * seconds / length;
  const bool known = state.shown && state.shown->document.terrain == state.document.terrain;
  const WalkingGround ground{ground_of(state), known ? state.shown->hydrology.get() : nullptr};
  if (held.any()) state.exploring.flight.reset();
  if (state.exploring.flight) return;
  state.view.camera = camera_on_foot(ground, state.view.camera, held.right * metres, held.ahead * metres, seconds);
}

void CameraGestures::handle(const UiContext& ui, const Pointer& pointer) {
  EditorState& state = ui.state;
  Exploring& exploring = state.exploring;
  const Camera before = state.view.camera;
  const bool left = pointer.active && dragged(ImGuiMouseButton_Left) && left_moves(state);
  const bool right = pointer.active && dragged(ImGuiMouseButton_Right);
  const bool middle = pointer.active && dragged(ImGuiMouseButton_Middle);
  const bool moved_by_hand = left || right || middle;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) pivot_.reset();
  if (moved_by_hand && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0)) {
    exploring.flight.reset();
    state.pictures.playing = -1;
    state.view.camera_untouched = false;
    if (right || (left && exploring.walking)) {
      look(state);
    } else if (left) {
      orbit(ui, pointer);
    } else if (!exploring.walking) {
      take_camera(state);
      pan(ui, pointer);
    }
  }
  if (pointer.hovered) dolly(ui, pointer);
  const bool led = exploring.walking || exploring.following || exploring.flight || state.pictures.playing >= 0;
  if (pointer.hovered && led && take_key(state, DialogKey::escape)) {
    take_camera(state);
    set_walking(state, false);
  }
  MoveKeys held = pointer.hovered || pointer.active ? held_move_keys() : MoveKeys{};
  use_gamepad(ui, held);
  if (exploring.walking) {
    walk(ui, held);
    return;
  }
  fly(ui, held);
  state.view.camera = kept_over_ground(state.view.camera, ground_of(state), 1.5, water_of(state));
  const bool changed = before.position != state.view.camera.position || before.pitch != state.view.camera.pitch;
  if (changed) keep_arm(state);
}

}  // namespace biotope
