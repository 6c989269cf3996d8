#pragma once

#include <array>

namespace biotope {

/// What a gamepad says, -1..1 each (triggers 0..1); all nought when there is none.
struct GamepadSticks {
  double move_right = 0;
  double move_ahead = 0;
  double look_right = 0;
  double look_up = 0;
  double rise = 0;    ///< right trigger up, left trigger down
  bool fast = false;  ///< right shoulder, or a pressed left stick
  /// A, X and Y since the last frame.
  bool toggles_walking = false;
  bool follows_herd = false;
  bool bookmarks = false;
  [[nodiscard]] bool any() const {
    return move_right != 0 || move_ahead != 0 || look_right != 0 || look_up != 0 || rise != 0 || toggles_walking ||
           follows_herd || bookmarks;
  }
};

/// A stick's value without the middle where it never quite rests, growing gently from there.
[[nodiscard]] double stick_value(float raw);

/// Buttons and axes of a gamepad, numbered as GLFW does: sticks -1..1 (right and down are more), triggers -1 (at rest) .. 1.
struct GamepadButtons {
  std::array<bool, 15> down{};
  std::array<float, 6> axes{0, 0, 0, 0, -1, -1};
};

/// What a gamepad says now; buttons that do something once do it in the frame in which they went down.
[[nodiscard]] GamepadSticks sticks_of(const GamepadButtons& now, const GamepadButtons& before);

/// The first gamepad there is.
class Gamepad {
 public:
  [[nodiscard]] GamepadSticks read();
  [[nodiscard]] bool present() const { return present_; }

 private:
  bool present_ = false;
  GamepadButtons before_;
};

}  // namespace biotope
