#pragma once

#include <string>
#include <vector>

#include "core/base/path_point.hpp"

namespace biotope {

/// A stop that a person wants in a herd's day.
struct PlanStopEdit {
  /// The resource is the node of the herd's level that lies at, or nearest to, this cell.
  PathPoint at;
  float arrive = 0;  ///< hours, 0..24
  float leave = 0;   ///< hours, after arrival (may pass 24)
  bool operator==(const PlanStopEdit&) const = default;
};

/// A herd's day as a person planned it.
struct PlanEdit {
  std::string species;
  /// A cell of the region the herd lives in, and its number among the herds of its species there: together they name the herd,
  /// whatever else changes.
  PathPoint home;
  int number = 0;
  std::vector<PlanStopEdit> stops;
  bool operator==(const PlanEdit&) const = default;
};

}  // namespace biotope
