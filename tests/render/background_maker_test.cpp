#include "render/background_maker.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <new>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "tests/base/noting.hpp"

using namespace biotope;
using biotope::test::Noting;

namespace {

using Maker = BackgroundMaker<int, int>;
constexpr std::chrono::seconds long_enough{20};

/// A picture that is being made until it is let go or told that it is of no use; notes what was asked for, in order.
class Studio {
 public:
  Maker::Make hand() {
    return [this](const int& asked, const std::stop_token& outdated, const Maker::Publish& publish) {
      {
        const std::lock_guard lock(mutex_);
        asked_.push_back(asked);
      }
      if (asked == 0) wait(outdated);
      if (!outdated.stop_requested()) publish(std::make_shared<const int>(asked));
    };
  }
  void wait_begun() { begun_.get_future().wait(); }
  void let_go() { go_.set_value(); }
  std::vector<int> asked() const {
    const std::lock_guard lock(mutex_);
    return asked_;
  }
  bool was_stopped() const { return stopped_; }

 private:
  void wait(const std::stop_token& outdated) {
    std::promise<void> stop;
    const std::stop_callback on_stop(outdated, [&] { stop.set_value(); });
    auto go = go_.get_future();
    auto stopping = stop.get_future();
    begun_.set_value();
    using namespace std::chrono_literals;
    while (go.wait_for(1ms) != std::future_status::ready && stopping.wait_for(0ms) != std::future_status::ready) continue;
    stopped_ = outdated.stop_requested();
  }

  mutable std::mutex mutex_;
  std::vector<int> asked_;
  std::promise<void> begun_;
  std::promise<void> go_;
  bool stopped_ = false;
};

}  // namespace

TEST_CASE("while a picture is being made only the newest of what is asked for waits, and what runs is finished") {
  Studio studio;
  Maker maker(studio.hand());
  CHECK_FALSE(maker.busy());
  maker.request(0, false);
  studio.wait_begun();
  CHECK(maker.busy());
  CHECK(maker.take() == nullptr);
  for (int i = 1; i <= 5; ++i) maker.request(i, false);
  studio.let_go();
  maker.wait_idle();
  CHECK_FALSE(maker.busy());
  CHECK(studio.asked() == std::vector{0, 5});
  CHECK_FALSE(studio.was_stopped());
  const auto newest = maker.take();
  REQUIRE(newest);
  CHECK(*newest == 5);
  CHECK(maker.take() == nullptr);
}

TEST_CASE("a picture that is of no use any more is given up, the next one is not") {
  Studio studio;
  Maker maker(studio.hand());
  maker.request(0, false);
  studio.wait_begun();
  maker.request(1, true);
  maker.wait_idle();
  CHECK(studio.was_stopped());
  CHECK(studio.asked() == std::vector{0, 1});
  const auto made = maker.take();
  REQUIRE(made);
  CHECK(*made == 1);
}

TEST_CASE("a maker that ends gives up what it is at and begins nothing of what waits") {
  Studio studio;
  {
    Maker maker(studio.hand());
    maker.request(0, false);
    studio.wait_begun();
    maker.request(1, false);
  }
  CHECK(studio.was_stopped());
  CHECK(studio.asked() == std::vector{0});
}

TEST_CASE("a picture too large to make leaves what is shown, and the next one is made") {
  Maker maker([](const int& asked, const std::stop_token&, const Maker::Publish& publish) {
    if (asked == 0) throw std::bad_alloc();
    publish(std::make_shared<const int>(asked));
  });
  maker.request(0, false);
  maker.wait_idle();
  CHECK(maker.take() == nullptr);
  maker.request(1, false);
  maker.wait_idle();
  CHECK(maker.take() != nullptr);
}

namespace {

using NotingMaker = BackgroundMaker<std::promise<std::thread::id>*, Noting>;

NotingMaker::Make making_notes(std::thread::id& made_by) {
  return [&made_by](std::promise<std::thread::id>* const& note, const std::stop_token&, const NotingMaker::Publish& publish) {
    made_by = std::this_thread::get_id();
    publish(std::make_shared<const Noting>(*note));
  };
}

}  // namespace

TEST_CASE("a picture that nobody took is freed by the thread that made it, once there is a newer one") {
  std::thread::id made_by;
  std::promise<std::thread::id> first;
  std::promise<std::thread::id> second;
  auto first_freed = first.get_future();
  NotingMaker maker(making_notes(made_by));
  maker.request(&first, false);
  maker.wait_idle();
  CHECK(first_freed.wait_for(std::chrono::milliseconds(20)) == std::future_status::timeout);
  maker.request(&second, false);
  REQUIRE(first_freed.wait_for(long_enough) == std::future_status::ready);
  CHECK(first_freed.get() == made_by);
  maker.wait_idle();
}

TEST_CASE("a retired picture is freed by the thread that made it, when nobody holds it any more") {
  std::thread::id made_by;
  std::promise<std::thread::id> note;
  auto freed = note.get_future();
  NotingMaker maker(making_notes(made_by));
  maker.request(&note, false);
  maker.wait_idle();
  auto shown = maker.take();
  maker.retire(shown);
  CHECK(freed.wait_for(std::chrono::milliseconds(50)) == std::future_status::timeout);
  shown.reset();
  REQUIRE(freed.wait_for(long_enough) == std::future_status::ready);
  CHECK(freed.get() == made_by);
  CHECK(made_by != std::this_thread::get_id());
}
