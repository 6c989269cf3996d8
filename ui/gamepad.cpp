#include "ui/gamepad.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace biotope {
namespace {

constexpr float dead_middle = 0.15F;

/// True in the frame in which a button goes down.
bool pressed_now(bool down, bool& held) {
  const bool before = std::exchange(held, down);
  return down && !before;
}

}  // namespace

double stick_value(float raw) {
  const float size = std::clamp((std::abs(raw) - dead_middle) / (1 - dead_middle), 0.0F, 1.0F);
  return double(std::copysign(size * size, raw));
}

GamepadSticks Gamepad::read() {
  present_ = false;
  for (int number = GLFW_JOYSTICK_1; number <= GLFW_JOYSTICK_LAST && !present_; ++number) {
    GLFWgamepadstate pad;
    if (glfwJoystickIsGamepad(number) != GLFW_TRUE || glfwGetGamepadState(number, &pad) != GLFW_TRUE) continue;
    present_ = true;
    const auto down = [&](int button) { return pad.buttons[button] == GLFW_PRESS; };
    // A trigger rests at -1.
    const auto trigger = [&](int axis) { return stick_value(0.5F * (pad.axes[axis] + 1)); };
    GamepadSticks sticks;
    sticks.move_right = stick_value(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]);
    sticks.move_ahead = -stick_value(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
    sticks.look_right = stick_value(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X]);
    sticks.look_up = -stick_value(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]);
    sticks.rise = trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER) - trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
    sticks.fast = down(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER) || down(GLFW_GAMEPAD_BUTTON_LEFT_THUMB);
    sticks.toggles_walking = pressed_now(down(GLFW_GAMEPAD_BUTTON_A), walking_held_);
    sticks.follows_herd = pressed_now(down(GLFW_GAMEPAD_BUTTON_X), herd_held_);
    sticks.bookmarks = pressed_now(down(GLFW_GAMEPAD_BUTTON_Y), bookmark_held_);
    return sticks;
  }
  return {};
}

}  // namespace biotope
