#include "ui/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstddef>

namespace biotope {
namespace {

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

/// Keys without a character (Backspace, arrows ...): text that follows them comes after what they did.
bool is_editing(int key) { return key >= GLFW_KEY_ESCAPE && !is_modifier(key); }

/// What one frame has taken so far.
class FrameInput {
 public:
  /// Whether the event can be told from what is taken already.
  [[nodiscard]] bool fits(const InputEvent& event) const {
    switch (event.kind) {
      case InputEvent::Kind::pointer:
      case InputEvent::Kind::wheel:
        return buttons_.empty();
      case InputEvent::Kind::button:
        return !contains(buttons_, event.code) && keys_.empty();
      case InputEvent::Kind::character:
        return !edited_;
      case InputEvent::Kind::key:
        if (contains(keys_, event.code)) return false;
        return is_modifier(event.code) ? keys_.empty() && buttons_.empty() : buttons_.empty();
    }
    return true;
  }
  [[nodiscard]] bool has_key(int code) const { return contains(keys_, code); }
  void take(const InputEvent& event) {
    if (event.kind == InputEvent::Kind::button) buttons_.push_back(event.code);
    if (event.kind != InputEvent::Kind::key || is_modifier(event.code)) return;
    keys_.push_back(event.code);
    edited_ = edited_ || (event.down && is_editing(event.code));
  }

 private:
  static bool contains(const std::vector<int>& list, int code) { return std::find(list.begin(), list.end(), code) != list.end(); }
  std::vector<int> buttons_;
  std::vector<int> keys_;
  bool edited_ = false;
};

}  // namespace

std::vector<InputEvent> InputQueue::take() {
  std::vector<InputEvent> events;
  FrameInput frame;
  // Letters that are typed quickly go down before the ones before them are up: a key may come up later than it did.
  std::deque<InputEvent> later;
  const auto waits = [&](int key) {
    return std::any_of(later.begin(), later.end(), [&](const InputEvent& event) { return event.code == key; });
  };
  while (!waiting_.empty()) {
    const InputEvent& next = waiting_.front();
    // A key that is held repeats faster than slow frames follow one another: once a frame is enough.
    if (next.repeat && frame.has_key(next.code)) {
      waiting_.pop_front();
      continue;
    }
    const bool let_go = next.kind == InputEvent::Kind::key && !next.down && !is_modifier(next.code);
    if (let_go && !frame.fits(next)) {
      later.push_back(next);
    } else if (frame.fits(next) && !(next.kind == InputEvent::Kind::key && waits(next.code))) {
      frame.take(next);
      events.push_back(next);
    } else {
      break;
    }
    waiting_.pop_front();
  }
  waiting_.insert(waiting_.begin(), later.begin(), later.end());
  return events;
}

void PointerState::follow(const InputEvent& event) {
  if (event.kind == InputEvent::Kind::pointer || event.kind == InputEvent::Kind::button) {
    x = event.x;
    y = event.y;
  }
  if (event.kind == InputEvent::Kind::button && event.code >= 0 && event.code < buttons)
    down[std::size_t(event.code)] = event.down;
}

}  // namespace biotope
