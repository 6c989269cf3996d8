#pragma once

#include <vector>

#include "core/base/path_point.hpp"

namespace biotope {

/// A ford that a person placed: within its radius no water is too deep for anybody.
struct PlacedFord {
  PathPoint at;
  float radius = 12;  ///< m
  bool operator==(const PlacedFord&) const = default;
};

/// A way in and out of the map: within its radius nothing blocks an animal, and herds come by as at a waypoint.
struct PlacedExit {
  PathPoint at;
  float radius = 20;  ///< m
  bool operator==(const PlacedExit&) const = default;
};

/// A place that herds come by: a node of the graph that every species of its region visits with this probability (0..1), beside
/// its needs. Trails lead there.
struct Waypoint {
  PathPoint at;
  float attraction = 0.2F;
  bool operator==(const Waypoint&) const = default;
};

/// Herds come by an exit as by a waypoint of the usual attraction.
inline constexpr float exit_attraction = Waypoint{}.attraction;

/// A trail that a person drew or bent: it is always there, at least this worn, and animals prefer to walk on it.
struct PinnedTrail {
  std::vector<PathPoint> points;
  /// kg x trips per year, at least.
  float weight = 50000;
  bool operator==(const PinnedTrail&) const = default;
};

/// A corridor that trails and walking herds avoid; they cross it only where there is no other way.
struct ForbiddenTrail {
  std::vector<PathPoint> points;
  float radius = 25;  ///< m, to each side
  bool operator==(const ForbiddenTrail&) const = default;
};

/// What a person placed on the ground for animals.
struct Places {
  std::vector<PlacedFord> fords;
  std::vector<PlacedExit> exits;
  std::vector<Waypoint> waypoints;
  std::vector<PinnedTrail> pinned_trails;
  std::vector<ForbiddenTrail> forbidden_trails;
  bool operator==(const Places&) const = default;
};

}  // namespace biotope
