#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace biotope {

/// While it lives, Ctrl-C and termination ask the running computation to stop, so that it can clear away what it has begun; a
/// second one ends the program at once. Make it before any thread that computes.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

 private:
  sigset_t signals_{};
  sigset_t before_{};
  std::stop_source source_;
  std::jthread watcher_;
};

}  // namespace biotope
