#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace biotope {

/// Measures how long each stage of a solve takes.
class StageClock {
 public:
  /// Ends the running stage and begins another.
  void begin(std::string stage) {
    end();
    stage_ = std::move(stage);
    started_ = std::chrono::steady_clock::now();
  }
  void end() {
    if (stage_.empty()) return;
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - started_;
    timings_.emplace_back(std::exchange(stage_, {}), elapsed.count());
  }
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& timings() const { return timings_; }

 private:
  std::string stage_;
  std::chrono::steady_clock::time_point started_;
  std::vector<std::pair<std::string, double>> timings_;
};

}  // namespace biotope
