#pragma once

#include <algorithm>
#include <vector>

#include "core/movement/plan_parts.hpp"

namespace biotope {

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

}  // namespace biotope
