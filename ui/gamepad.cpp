#include "ui/gamepad.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace biotope {
namespace {

constexpr float dead_middle = 0.15F;

}  // namespace

double stick_value(float raw) {
  const float size = std::clamp((std::abs(raw) - dead_middle) / (1 - dead_middle), 0.0F, 1.0F);
  return double(std::copysign(size * size, raw));
}

GamepadSticks sticks_of(const GamepadButtons& now, const GamepadButtons& before) {
  const auto axis = [&](int number) { return stick_value(now.axes[std::size_t(number)]); };
  // A trigger rests at -1.
  const auto trigger = [&](int number) { return stick_value(0.5F * (now.axes[std::size_t(number)] + 1)); };
  const auto down = [&](int button) { return now.down[std::size_t(button)]; };
  const auto pressed = [&](int button) { return down(button) && !before.down[std::size_t(button)]; };
  GamepadSticks sticks;
  sticks.move_right = axis(GLFW_GAMEPAD_AXIS_LEFT_X);
  sticks.move_ahead = -axis(GLFW_GAMEPAD_AXIS_LEFT_Y);
  sticks.look_right = axis(GLFW_GAMEPAD_AXIS_RIGHT_X);
  sticks.look_up = -axis(GLFW_GAMEPAD_AXIS_RIGHT_Y);
  sticks.rise = trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER) - trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
  sticks.fast = down(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER) || down(GLFW_GAMEPAD_BUTTON_LEFT_THUMB);
  sticks.toggles_walking = pressed(GLFW_GAMEPAD_BUTTON_A);
  sticks.follows_herd = pressed(GLFW_GAMEPAD_BUTTON_X);
  sticks.bookmarks = pressed(GLFW_GAMEPAD_BUTTON_Y);
  return sticks;
}

GamepadSticks Gamepad::read() {
  present_ = false;
  for (int number = GLFW_JOYSTICK_1; number <= GLFW_JOYSTICK_LAST; ++number) {
    GLFWgamepadstate pad;
    if (glfwJoystickIsGamepad(number) != GLFW_TRUE || glfwGetGamepadState(number, &pad) != GLFW_TRUE) continue;
    present_ = true;
    GamepadButtons now;
    std::transform(std::begin(pad.buttons), std::end(pad.buttons), now.down.begin(),
                   [](unsigned char button) { return button == GLFW_PRESS; });
    std::copy(std::begin(pad.axes), std::end(pad.axes), now.axes.begin());
    return sticks_of(now, std::exchange(before_, now));
  }
  before_ = {};
  return {};
}

}  // namespace biotope
