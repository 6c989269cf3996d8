#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <stop_token>
#include <utility>

#include "core/base/background_priority.hpp"
#include "core/base/background_thread.hpp"

namespace biotope {

/// Makes pictures on a thread of its own, so that the window never waits for one. A mailbox of one slot: of what is asked for
/// while a picture is being made only the newest counts.
template <class Request, class Picture>
class BackgroundMaker {
 public:
  using PicturePointer = std::shared_ptr<const Picture>;
  using Publish = std::function<void(PicturePointer)>;
  /// Makes what was asked for and publishes it, perhaps something coarser first; gives up when the token asks for it.
  using Make = std::function<void(const Request&, const std::stop_token&, const Publish&)>;

  explicit BackgroundMaker(Make make) : make_(std::move(make)) {}
  /// Stops the picture being made; what waits is not begun.
  ~BackgroundMaker() {
    const std::lock_guard lock(mutex_);
    slot_.reset();
    outdated_.request_stop();
  }
  BackgroundMaker(const BackgroundMaker&) = delete;
  BackgroundMaker& operator=(const BackgroundMaker&) = delete;

  /// `stops_running`: the picture being made is of no use any more. Otherwise it is finished: under a long stroke there would
  /// else never be one.
  void request(Request request, bool stops_running) {
    const std::lock_guard lock(mutex_);
    if (stops_running) outdated_.request_stop();
    const bool waits = slot_.has_value();
    slot_ = std::move(request);
    // What throws here ends the program: nobody would ever hear of it.
    if (!waits) (void)thread_.start([this]() noexcept { make_newest(); });
  }
  /// The newest picture made since this was last asked; null when there is none.
  [[nodiscard]] PicturePointer take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(made_, nullptr);
  }
  /// True while a picture is being made or waits to be made.
  [[nodiscard]] bool busy() const {
    const std::lock_guard lock(mutex_);
    return working_ || slot_.has_value();
  }
  /// Blocks until everything asked for is made.
  void wait_idle() {
    std::unique_lock lock(mutex_);
    idle_.wait(lock, [&] { return !working_ && !slot_; });
  }
  /// Takes over a picture that is no longer shown, to free it when nobody holds it any more.
  void retire(PicturePointer old) { thread_.retire(std::move(old)); }

 private:
  void make_newest() {
    const BackgroundPriority priority;
    std::unique_lock lock(mutex_);
    std::optional<Request> request = std::exchange(slot_, std::nullopt);
    if (!request) return;
    working_ = true;
    outdated_ = std::stop_source();
    const std::stop_token outdated = outdated_.get_token();
    lock.unlock();
    make(*request, outdated);
    request.reset();
    lock.lock();
    working_ = false;
    idle_.notify_all();
  }

  void make(const Request& request, const std::stop_token& outdated) {
    try {
      make_(request, outdated, [this](PicturePointer picture) {
        const std::lock_guard lock(mutex_);
        thread_.retire(std::exchange(made_, std::move(picture)));
      });
    } catch (const std::bad_alloc&) {
      // What is shown stays: a landscape that is too large to draw is also too large to compute, and the worker says so.
    }
  }

  mutable std::mutex mutex_;
  std::condition_variable idle_;
  std::optional<Request> slot_;
  bool working_ = false;
  PicturePointer made_;
  std::stop_source outdated_;
  Make make_;
  /// Last, so that it ends before what it uses.
  BackgroundThread thread_;
};

}  // namespace biotope
