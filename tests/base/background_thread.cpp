#include "core/base/background_thread.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/base/noting.hpp"

using namespace biotope;
using biotope::test::Noting;

TEST_CASE("a background thread does what it is given one after the other, and not on the caller's thread") {
  BackgroundThread thread;
  std::vector<int> done;
  std::thread::id by;
  std::future<void> last;
  for (int i = 0; i < 20; ++i) {
    last = thread.start([&done, &by, i] {
      done.push_back(i);
      by = std::this_thread::get_id();
    });
  }
  last.get();
  REQUIRE(done.size() == 20);
  for (int i = 0; i < 20; ++i) CHECK(done[std::size_t(i)] == i);
  CHECK(by != std::this_thread::get_id());
}

TEST_CASE("what goes wrong on a background thread is told to who asked for it, and the next thing is done") {
  BackgroundThread thread;
  auto fails = thread.start([] { throw std::runtime_error("no"); });
  auto works = thread.start([] {});
  CHECK_THROWS_AS(fails.get(), std::runtime_error);
  CHECK_NOTHROW(works.get());
}

TEST_CASE("what is retired is freed on the background thread, as soon as nobody else holds it") {
  std::promise<std::thread::id> note;
  auto freed = note.get_future();
  BackgroundThread thread;
  std::thread::id by;
  thread.start([&by] { by = std::this_thread::get_id(); }).get();
  auto thing = std::make_shared<const Noting>(note);
  thread.retire(thing);
  CHECK(freed.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout);
  // It is looked for again even where other work is done in between.
  thread.start([] {}).get();
  thing.reset();
  REQUIRE(freed.wait_for(std::chrono::seconds(20)) == std::future_status::ready);
  CHECK(freed.get() == by);
}

TEST_CASE("what is retired several times is freed too") {
  std::promise<std::thread::id> note;
  auto freed = note.get_future();
  BackgroundThread thread;
  auto thing = std::make_shared<const Noting>(note);
  thread.retire(thing);
  thread.retire(thing);
  thread.retire(std::move(thing));
  CHECK(freed.wait_for(std::chrono::seconds(20)) == std::future_status::ready);
}

TEST_CASE("what is retired is freed though there is always something else to do") {
  std::promise<std::thread::id> note;
  auto freed = note.get_future();
  BackgroundThread thread;
  auto thing = std::make_shared<const Noting>(note);
  thread.retire(thing);
  std::vector<std::future<void>> tasks;
  const auto brief = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
  for (int i = 0; i < 2000; ++i) tasks.push_back(thread.start(brief));
  thing.reset();
  CHECK(freed.wait_for(std::chrono::seconds(20)) == std::future_status::ready);
  CHECK(tasks.back().wait_for(std::chrono::seconds(0)) == std::future_status::timeout);
}

TEST_CASE("a background thread ends after what it is at; what was not begun is left undone") {
  bool second = false;
  std::promise<void> begun;
  {
    BackgroundThread thread;
    auto first = thread.start([&] {
      begun.set_value();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    });
    auto never = thread.start([&] { second = true; });
    begun.get_future().get();
  }
  CHECK_FALSE(second);
}
