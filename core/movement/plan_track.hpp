#pragma once

#include <algorithm>
#include <vector>

#include "core/movement/plan_parts.hpp"

namespace biotope {

/// A predator keeps this far behind its herd, m. Our choice.
inline constexpr double nearest_gap = 120;
inline constexpr double widest_gap = 260;
/// A herd is lost from sight beyond this, m. Our choice.
inline constexpr double sight = 480;
/// Who falls behind trots: as much faster than it walks. Our choice; wolves travel at some 8 km/h and walk at 5.
inline constexpr double trot = 1.5;
/// Time a predator takes to drink, h. Our choice.
inline constexpr double drink = 0.25;
/// Waits shorter than this are part of the walk, h.
inline constexpr double short_wait = 1.0 / 60;

/// Walks of a day of a herd that is followed, as one line, with the hour the herd passes each point. Stays take no length: a
/// stop's point is there twice.
struct FollowedTrack {
  std::vector<PathPoint> points;
  std::vector<double> along;  ///< m from the first point
  std::vector<double> hour;
  std::vector<double> cost;  ///< metres of flat walking from the first point
  struct Stop {
    double along = 0;
    double hour = 0;
    /// Bank of the herd's level; -1 when it is none.
    int bank = -1;
  };
  std::vector<Stop> stops;

  [[nodiscard]] double length() const { return along.back(); }
  [[nodiscard]] std::size_t before(double metres) const {
    const auto after = std::upper_bound(along.begin(), along.end(), metres);
    return std::min(std::size_t(std::max<std::ptrdiff_t>(0, after - along.begin() - 1)), along.size() - 2);
  }
  [[nodiscard]] double fraction(std::size_t i, double metres) const {
    const double step = along[i + 1] - along[i];
    return step > 0 ? std::clamp((metres - along[i]) / step, 0.0, 1.0) : 1.0;
  }
  [[nodiscard]] double hour_at(double metres) const {
    if (metres >= length()) return hour.back();
    const std::size_t i = before(metres);
    return hour[i] + (hour[i + 1] - hour[i]) * fraction(i, metres);
  }
  [[nodiscard]] double cost_at(double metres) const {
    const std::size_t i = before(metres);
    return cost[i] + (cost[i + 1] - cost[i]) * fraction(i, metres);
  }
  /// How far the herd has come at an hour.
  [[nodiscard]] double along_at(double at_hour) const {
    const auto after = std::upper_bound(hour.begin(), hour.end(), at_hour);
    if (after == hour.begin()) return 0;
    if (after == hour.end()) return length();
    const auto i = std::size_t(after - hour.begin()) - 1;
    return along[i] + (along[i + 1] - along[i]) * std::clamp((at_hour - hour[i]) / (hour[i + 1] - hour[i]), 0.0, 1.0);
  }
  [[nodiscard]] PathPoint point_at(double metres) const {
    const std::size_t i = before(metres);
    const auto t = float(fraction(i, metres));
    return {points[i].x + (points[i + 1].x - points[i].x) * t, points[i].y + (points[i + 1].y - points[i].y) * t};
  }
};

/// The herd's track over ground that the predator, whose travel graph is `graph`, can walk; empty when there is none.
[[nodiscard]] FollowedTrack track_of(const PlanInput& input, int graph, const FollowedHerd& followed, const FineGround& ground);

/// The same of the walks that a stretch of hours (any, the herd does the same every day) touches, from at least `behind` metres
/// before where the herd is at its begin, if it walks that far in a day. Empty also when the herd walks nowhere.
[[nodiscard]] FollowedTrack track_between(const PlanInput& input, int graph, const FollowedHerd& followed,
                                          const FineGround& ground, double from, double until, double behind);

/// A place in sight of `home`, where a herd stays all day, drawn for a pack; `home` itself where there is none.
[[nodiscard]] PathPoint place_in_sight(const PlanInput& input, int herd, PathPoint home, const FineGround& ground);

}  // namespace biotope
