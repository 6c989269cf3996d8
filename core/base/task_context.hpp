#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace biotope {

/// What a long computation needs from outside: where to report, and when to stop. Passed down, never global.
struct TaskContext {
  /// Called with the stage's name and the fraction done within it (0..1); may be empty. Called from
  /// the computing thread only.
  std::function<void(std::string_view stage, double fraction)> progress;
  /// Asked between tiles; when stop is requested the computation returns early with whatever it has
  /// and its caller throws the result away.
  std::stop_token stop;

  void report(std::string_view stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
  [[nodiscard]] bool stopped() const { return stop.stop_requested(); }
};

}  // namespace biotope
