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
  /// Between looks at what was retired and is still held, where there is nothing to do; otherwise it looks before each thing.
  static constexpr std::chrono::milliseconds sweep_every{200};

  void wake() {
    if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
    wake_.notify_all();
  }

  void work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      const auto asked = [&] { return !tasks_.empty(); };
      if (retired_.empty()) {
        wake_.wait(lock, stop, [&] { return asked() || !retired_.empty(); });
      } else {
        wake_.wait_for(lock, stop, sweep_every, asked);
      }
      if (stop.stop_requested()) return;
      std::vector<std::shared_ptr<const void>> unused = retired_.take_unused();
      std::packaged_task<void()> task;
      if (asked()) {
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      lock.unlock();
      unused.clear();
      if (task.valid()) task();
      task = {};
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
