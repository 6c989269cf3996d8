#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

namespace biotope {

/// What a person did with mouse and keyboard, in its order. Keys and buttons are numbered as GLFW does.
struct InputEvent {
  enum class Kind : std::uint8_t { pointer, button, wheel, key, character };
  Kind kind = Kind::pointer;
  /// Key, button or character.
  int code = 0;
  int scancode = 0;
  int modifiers = 0;
  bool down = false;
  bool repeat = false;
  /// Place of the pointer at this moment, window pixels; of the wheel, how far it turned.
  float x = 0;
  float y = 0;
  /// Of a pen, 0..1.
  float pressure = 1;
};

/// Hands input to the window frame by frame such that none of it is lost, however slowly frames follow one another: what would
/// undo or hide something of the same frame (a button let go, the pointer moved on after a click, a key tapped twice, a modifier
/// let go after a key) waits for the next one. Only repeats of a held key are merged.
class InputQueue {
 public:
  void push(const InputEvent& event) { waiting_.push_back(event); }
  /// The events of the next frame, in order.
  [[nodiscard]] std::vector<InputEvent> take();
  /// True while some wait for another frame: draw it soon.
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

 private:
  std::deque<InputEvent> waiting_;
};

/// Buttons that are down and where the pointer is, as the frames see them.
struct PointerState {
  static constexpr int buttons = 5;
  std::array<bool, buttons> down{};
  float x = 0;
  float y = 0;
  void follow(const InputEvent& event);
};

}  // namespace biotope
