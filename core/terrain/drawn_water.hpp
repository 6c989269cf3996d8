#pragma once

#include <vector>

#include "core/base/path_point.hpp"

namespace biotope {

/// A river that a person drew, from its head downstream. Its bed is carved into the ground so that it falls all the way, and its
/// water enters at the head; where it runs after the last point is for hydrology to say.
struct DrawnRiver {
  std::vector<PathPoint> course;
  /// Mean yearly discharge that enters at the head, m3/s.
  double discharge = 1;
  bool operator==(const DrawnRiver&) const = default;
};

/// A lake that a person drew: a basin is carved inside the shore, filled to the lowest ground along it.
struct DrawnLake {
  /// Closed line: the last point joins the first.
  std::vector<PathPoint> shore;
  /// Greatest depth below the water's surface, m.
  float depth = 3;
  bool operator==(const DrawnLake&) const = default;
};

/// All water that a person drew.
struct DrawnWater {
  std::vector<DrawnRiver> rivers;
  std::vector<DrawnLake> lakes;
  bool operator==(const DrawnWater&) const = default;
};

}  // namespace biotope
