#include "ui/gamepad.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <catch2/catch.hpp>

using namespace biotope;

namespace {

GamepadButtons with_axis(int axis, float value) {
  GamepadButtons pad;
  pad.axes[std::size_t(axis)] = value;
  return pad;
}

GamepadButtons with_button(int button) {
  GamepadButtons pad;
  pad.down[std::size_t(button)] = true;
  return pad;
}

}  // namespace

TEST_CASE("a gamepad at rest says nothing, nor does a stick that rests a little off its middle") {
  CHECK_FALSE(sticks_of({}, {}).any());
  for (int axis = GLFW_GAMEPAD_AXIS_LEFT_X; axis <= GLFW_GAMEPAD_AXIS_RIGHT_Y; ++axis) {
    CHECK_FALSE(sticks_of(with_axis(axis, 0.14F), {}).any());
    CHECK_FALSE(sticks_of(with_axis(axis, -0.14F), {}).any());
  }
}

TEST_CASE("the left stick moves, the right one looks, and pushing forward is ahead and up") {
  CHECK(sticks_of(with_axis(GLFW_GAMEPAD_AXIS_LEFT_X, 1), {}).move_right == 1);
  CHECK(sticks_of(with_axis(GLFW_GAMEPAD_AXIS_LEFT_Y, -1), {}).move_ahead == 1);
  CHECK(sticks_of(with_axis(GLFW_GAMEPAD_AXIS_RIGHT_X, -1), {}).look_right == -1);
  CHECK(sticks_of(with_axis(GLFW_GAMEPAD_AXIS_RIGHT_Y, -1), {}).look_up == 1);
}

TEST_CASE("the right trigger goes up, the left one down, both together stay") {
  GamepadButtons pad = with_axis(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER, 1);
  CHECK(sticks_of(pad, {}).rise == 1);
  CHECK(sticks_of(with_axis(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER, 1), {}).rise == -1);
  pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = 1;
  CHECK(sticks_of(pad, {}).rise == 0);
}

TEST_CASE("a stick's answer grows from nothing at its edge of rest to one, the same both ways") {
  double before = 0;
  for (float raw = 0; raw <= 1; raw += 0.05F) {
    CHECK(stick_value(raw) >= before);
    CHECK(stick_value(-raw) == -stick_value(raw));
    before = stick_value(raw);
  }
  CHECK(stick_value(1) == 1);
  CHECK(stick_value(0.2F) < 0.01);
}

TEST_CASE("A, X and Y do their thing once however long they are held") {
  const GamepadButtons walk = with_button(GLFW_GAMEPAD_BUTTON_A);
  CHECK(sticks_of(walk, {}).toggles_walking);
  CHECK_FALSE(sticks_of(walk, walk).toggles_walking);
  CHECK(sticks_of(with_button(GLFW_GAMEPAD_BUTTON_X), walk).follows_herd);
  CHECK(sticks_of(with_button(GLFW_GAMEPAD_BUTTON_Y), {}).bookmarks);
  CHECK(sticks_of(with_button(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER), with_button(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER)).fast);
}
