#pragma once

namespace biotope {

/// A point in cell coordinates (0, 0 is the centre of the north-west cell; x east, y south).
struct PathPoint {
  float x = 0;
  float y = 0;
  bool operator==(const PathPoint&) const = default;
};

}  // namespace biotope
