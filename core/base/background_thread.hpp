#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/last_owner.hpp"

namespace biotope {

/// A thread for what a window must not wait for: it does what it is given, one thing after the other, and frees what is no longer
/// needed. It begins with the first of them and is kept, for every new thread costs memory of its own.
class BackgroundThread {
 public:
  BackgroundThread() = default;
  BackgroundThread(const BackgroundThread&) = delete;
  BackgroundThread& operator=(const BackgroundThread&) = delete;
  /// Ends after what it is at; what was not begun is left undone.
  ~BackgroundThread() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
  }

  /// Does it after all that was given before. The future is ready when it has been done and throws what it threw.
  [[nodiscard]] std::future<void> start(std::function<void()> work) {
    std::packaged_task<void()> task(std::move(work));
    std::future<void> done = task.get_future();
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
    wake();
    return done;
  }
  /// Frees a thing as soon as nobody else holds it any more.
  void retire(std::shared_ptr<const void> thing) {
    const std::lock_guard lock(mutex_);
    retired_.keep(std::move(thing));
    wake();
  }

 private:
  using Clock = std::chrono::steady_clock;
  /// Between looks at what was retired and is still held, however much there is to do.
  static constexpr std::chrono::milliseconds sweep_every{200};

  void wake() {
    if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
    wake_.notify_all();
  }

  void work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    Clock::time_point next_sweep = Clock::now();
    while (!stop.stop_requested()) {
      if (retired_.empty()) {
        wake_.wait(lock, stop, [&] { return !tasks_.empty() || !retired_.empty(); });
      } else {
        wake_.wait_until(lock, stop, next_sweep, [&] { return !tasks_.empty(); });
      }
      if (stop.stop_requested()) return;
      std::packaged_task<void()> task;
      if (!tasks_.empty()) {
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      std::vector<std::shared_ptr<const void>> unused;
      if (Clock::now() >= next_sweep) {
        unused = retired_.take_unused();
        next_sweep = Clock::now() + sweep_every;
      }
      lock.unlock();
      if (task.valid()) task();
      task = {};
      unused.clear();
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<std::packaged_task<void()>> tasks_;
  LastOwner retired_;
  std::jthread thread_;
};

}  // namespace biotope
