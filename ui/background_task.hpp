#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"

namespace biotope {

/// One piece of work on a thread of its own, whose result is picked up by the window's thread when it is there.
template <class T>
class BackgroundTask {
 public:
  using Work = std::function<Result<T>(const TaskContext&)>;

  /// Starts; what was running is stopped and its result dropped.
  void start(std::string what, Work work) {
    cancel();
    auto shared = std::make_shared<Shared>();
    shared->stage = what;
    what_ = std::move(what);
    shared_ = shared;
    thread_ = std::jthread([shared, work = std::move(work)](const std::stop_token& stop) {
      TaskContext context;
      context.stop = stop;
      context.progress = [&shared](std::string_view stage, double fraction) {
        const std::lock_guard lock(shared->mutex);
        shared->stage = stage;
        shared->fraction = fraction;
      };
      Result<T> result = work(context);
      const std::lock_guard lock(shared->mutex);
      shared->result = std::move(result);
      shared->done = true;
    });
  }

  [[nodiscard]] bool running() const { return shared_ != nullptr; }
  [[nodiscard]] const std::string& what() const { return what_; }
  [[nodiscard]] std::string stage() const {
    if (!shared_) return {};
    const std::lock_guard lock(shared_->mutex);
    return shared_->stage;
  }
  [[nodiscard]] double fraction() const {
    if (!shared_) return 0;
    const std::lock_guard lock(shared_->mutex);
    return shared_->fraction;
  }
  /// The result, once, when it is there.
  [[nodiscard]] std::optional<Result<T>> take() {
    if (!shared_ || !shared_->done) return std::nullopt;
    std::optional<Result<T>> result = std::move(shared_->result);
    thread_.join();
    shared_.reset();
    return result;
  }
  /// Asks the work to stop and waits for nothing; it is running until its result is taken.
  void ask_to_stop() { thread_.request_stop(); }
  /// Asks the work to stop and forgets it; waits for its thread.
  void cancel() {
    if (!shared_) return;
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    shared_.reset();
  }

 private:
  struct Shared {
    std::mutex mutex;
    std::string stage;
    double fraction = 0;
    std::optional<Result<T>> result;
    std::atomic<bool> done = false;
  };
  std::string what_;
  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

}  // namespace biotope
