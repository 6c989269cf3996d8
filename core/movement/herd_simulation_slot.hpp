#pragma once

#include <cmath>
#include <map>
#include <memory>

#include "core/movement/herd_simulation.hpp"

namespace biotope {

/// What is kept of a herd. Only for the parts of HerdSimulation.
struct HerdSimulation::Slot {
  std::shared_ptr<HerdCast> cast;
  /// Casts of predators and of the followed herd that runs may need; filled before work is shared out.
  std::map<int, std::shared_ptr<HerdCast>> others;
  std::map<int, std::unique_ptr<BoidRun>> runs;
  std::uint64_t used = 0;
  /// Of the last call.
  int checkpoint = 0;
};

/// A checkpoint's number within the day: what follows from it must not depend on which day it is counted from.
[[nodiscard]] constexpr int checkpoint_within_a_day(int checkpoint) {
  return (checkpoint % checkpoints_per_day + checkpoints_per_day) % checkpoints_per_day;
}

/// Seconds since midnight of any hour.
[[nodiscard]] inline double seconds_within_day(double hour) {
  const double seconds = std::fmod(hour * 3600, day_seconds);
  return seconds < 0 ? seconds + day_seconds : seconds;
}

}  // namespace biotope
