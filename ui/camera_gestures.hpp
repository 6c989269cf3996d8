#pragma once

#include <optional>

#include "ui/gamepad.hpp"
#include "ui/view_transform.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// What is held of the keys and sticks that move one, -1..1 each.
struct MoveKeys {
  double right = 0;
  double ahead = 0;
  double up = 0;
  bool fast = false;
  [[nodiscard]] bool any() const { return right != 0 || ahead != 0 || up != 0; }
};
[[nodiscard]] MoveKeys held_move_keys();

/// Mouse, keys and gamepad that move the camera of the 3D view: orbit, look, pan, dolly, fly and walk.
class CameraGestures {
 public:
  /// Where the pointer is on the canvas, what lies under it and whether the view has it.
  struct Pointer {
    PixelPoint canvas;
    PixelPoint pixel;
    std::optional<glm::dvec3> ground;
    bool hovered = false;
    bool active = false;
  };
  /// Moves the camera by what happened since the last frame.
  void handle(const UiContext& ui, const Pointer& pointer);
  /// True while a drag moves the camera: what lies under the pointer is then not looked for.
  [[nodiscard]] static bool dragging(const Pointer& pointer);
  /// True while a stick of a gamepad moves the camera: nothing else would draw the next frame.
  [[nodiscard]] bool moved_by_gamepad() const { return moved_by_gamepad_; }

 private:
  void orbit(const UiContext& ui, const Pointer& pointer);
  static void pan(const UiContext& ui, const Pointer& pointer);
  static void dolly(const UiContext& ui, const Pointer& pointer);
  static void fly(const UiContext& ui, const MoveKeys& held);
  static void walk(const UiContext& ui, const MoveKeys& held);
  /// Turns by the gamepad's right stick, acts on its buttons and adds its sticks to what is held.
  void use_gamepad(const UiContext& ui, MoveKeys& held);

  std::optional<glm::dvec3> pivot_;  ///< what an orbit turns around
  Gamepad gamepad_;
  bool moved_by_gamepad_ = false;
};

}  // namespace biotope
