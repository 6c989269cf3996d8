#pragma once

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

/// The first gamepad there is; pressed buttons count once.
class Gamepad {
 public:
  [[nodiscard]] GamepadSticks read();
  [[nodiscard]] bool present() const { return present_; }

 private:
  bool present_ = false;
  bool walking_held_ = false;
  bool herd_held_ = false;
  bool bookmark_held_ = false;
};

}  // namespace biotope
