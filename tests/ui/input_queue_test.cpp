#include "ui/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <catch2/catch.hpp>

#include "core/base/random.hpp"

namespace biotope {
namespace {

using Kind = InputEvent::Kind;

InputEvent key(int code, bool down) { return {Kind::key, code, 0, 0, down}; }
InputEvent character(char letter) { return {Kind::character, letter}; }
InputEvent button(int code, bool down, float x = 0) { return {Kind::button, code, 0, 0, down, false, x, 0}; }
InputEvent pointer(float x) { return {Kind::pointer, 0, 0, 0, false, false, x, 0}; }

InputQueue queue_of(const std::vector<InputEvent>& events) {
  InputQueue queue;
  for (const InputEvent& event : events) queue.push(event);
  return queue;
}

TEST_CASE("A key tapped within a frame is down in that frame and up in the next") {
  InputQueue queue = queue_of({key(GLFW_KEY_BACKSPACE, true), key(GLFW_KEY_BACKSPACE, false)});
  const auto first = queue.take();
  REQUIRE(first.size() == 1);
  CHECK(first[0].down);
  CHECK_FALSE(queue.empty());
  const auto second = queue.take();
  REQUIRE(second.size() == 1);
  CHECK_FALSE(second[0].down);
  CHECK(queue.empty());
  CHECK(queue.take().empty());
}

TEST_CASE("A key tapped three times is pressed in three frames") {
  InputQueue queue;
  for (int i = 0; i < 3; ++i) {
    queue.push(key(GLFW_KEY_DELETE, true));
    queue.push(key(GLFW_KEY_DELETE, false));
  }
  int presses = 0;
  for (int frame = 0; frame < 10; ++frame) {
    int in_frame = 0;
    for (const InputEvent& event : queue.take()) in_frame += event.down ? 1 : 0;
    CHECK(in_frame <= 1);
    presses += in_frame;
  }
  CHECK(presses == 3);
}

TEST_CASE("A click is where it was made, though the pointer has gone on") {
  InputQueue queue = queue_of({pointer(10), button(0, true, 10), pointer(80), button(0, false, 80), pointer(200)});
  PointerState state;
  for (const InputEvent& event : queue.take()) state.follow(event);
  CHECK(state.down[0]);
  CHECK(state.x == 10);
  for (const InputEvent& event : queue.take()) state.follow(event);
  CHECK_FALSE(state.down[0]);
  CHECK(state.x == 80);
  for (const InputEvent& event : queue.take()) state.follow(event);
  CHECK(state.x == 200);
  CHECK(queue.empty());
}

TEST_CASE("A double click in one slow frame is two clicks") {
  InputQueue queue = queue_of({button(0, true), button(0, false), button(0, true), button(0, false)});
  PointerState state;
  int clicks = 0;
  for (int frame = 0; frame < 6; ++frame) {
    const bool before = state.down[0];
    for (const InputEvent& event : queue.take()) state.follow(event);
    clicks += !before && state.down[0] ? 1 : 0;
  }
  CHECK(clicks == 2);
}

TEST_CASE("A modifier let go after a key is still held in the key's frame") {
  InputQueue queue = queue_of({key(GLFW_KEY_LEFT_CONTROL, true), key(GLFW_KEY_V, true), key(GLFW_KEY_V, false),
                               key(GLFW_KEY_LEFT_CONTROL, false), button(0, true)});
  const auto first = queue.take();
  REQUIRE(first.size() == 2);
  CHECK(first[0].code == GLFW_KEY_LEFT_CONTROL);
  CHECK(first[1].code == GLFW_KEY_V);
  const auto second = queue.take();
  for (const InputEvent& event : second) CHECK_FALSE(event.down);
}

TEST_CASE("A held key repeats once a frame, and stops when it is let go") {
  InputQueue queue = queue_of({key(GLFW_KEY_W, true)});
  for (int i = 0; i < 50; ++i) {
    InputEvent again = key(GLFW_KEY_W, true);
    again.repeat = true;
    queue.push(again);
  }
  queue.push(key(GLFW_KEY_W, false));
  CHECK(queue.take().size() == 1);
  const auto second = queue.take();
  REQUIRE(second.size() == 1);
  CHECK_FALSE(second[0].down);
  CHECK(queue.empty());
}

TEST_CASE("A word typed within a frame is typed in that frame") {
  InputQueue queue;
  for (const char letter : {'w', 'o', 'l', 'f'}) {
    queue.push(key(letter - 'a' + 'A', true));
    queue.push(character(letter));
    queue.push(key(letter - 'a' + 'A', false));
  }
  std::string typed;
  for (const InputEvent& event : queue.take()) {
    if (event.kind == Kind::character) typed += char(event.code);
  }
  CHECK(typed == "wolf");
}

TEST_CASE("Text after a Backspace comes after it") {
  InputQueue queue = queue_of({character('a'), key(GLFW_KEY_BACKSPACE, true), key(GLFW_KEY_BACKSPACE, false), character('b')});
  REQUIRE(queue.take().size() == 2);
  const auto second = queue.take();
  REQUIRE(second.size() == 2);
  CHECK(second[1].code == 'b');
}

TEST_CASE("Whatever was done, nothing is lost, doubled or stuck, and every button and key keeps its order") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<InputEvent> done;
    bool down[4] = {};
    const int codes[4] = {GLFW_KEY_A, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_ENTER, 0};
    for (std::uint64_t i = 0; i < 40; ++i) {
      const auto which = std::size_t(random_bits({seed, 1, i}) % 5);
      if (which == 4) {
        done.push_back(pointer(float(i)));
      } else {
        down[which] = !down[which];
        done.push_back(which == 3 ? button(0, down[which], float(i)) : key(codes[which], down[which]));
      }
    }
    InputQueue queue = queue_of(done);
    std::vector<InputEvent> seen;
    int frames = 0;
    while (!queue.empty() && frames < 1000) {
      const auto events = queue.take();
      seen.insert(seen.end(), events.begin(), events.end());
      ++frames;
    }
    REQUIRE(queue.empty());
    REQUIRE(seen.size() == done.size());
    for (const Kind kind : {Kind::key, Kind::button}) {
      for (const int code : codes) {
        const auto of = [&](const std::vector<InputEvent>& list) {
          std::vector<bool> states;
          for (const InputEvent& event : list) {
            if (event.kind == kind && event.code == code) states.push_back(event.down);
          }
          return states;
        };
        CHECK(of(seen) == of(done));
      }
    }
  }
}

}  // namespace
}  // namespace biotope
