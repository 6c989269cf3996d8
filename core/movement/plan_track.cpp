#include "core/movement/plan_track.hpp"

#include <cmath>

namespace biotope {
namespace {

/// Hours the herd is as far along its leg as the points of another way between the same ends.
std::vector<float> hours_along(const CourseLeg& leg, const std::vector<PathPoint>& points) {
  const auto lengths = [](const std::vector<PathPoint>& line) {
    std::vector<double> sum{0};
    for (std::size_t i = 1; i < line.size(); ++i) {
      sum.push_back(sum.back() + std::hypot(double(line[i].x - line[i - 1].x), double(line[i].y - line[i - 1].y)));
    }
    return sum;
  };
  const auto theirs = lengths(leg.points);
  const auto ours = lengths(points);
  std::vector<float> hours;
  std::size_t k = 0;
  for (const double length : ours) {
    const double at = ours.back() > 0 ? length / ours.back() * theirs.back() : 0;
    while (k + 2 < theirs.size() && theirs[k + 1] < at) ++k;
    const double step = theirs[k + 1] - theirs[k];
    const double t = step > 0 ? std::clamp((at - theirs[k]) / step, 0.0, 1.0) : 1.0;
    hours.push_back(float(double(leg.hours[k]) + (double(leg.hours[k + 1]) - double(leg.hours[k])) * t));
  }
  return hours;
}

bool can_walk(const FineGround& ground, const std::vector<PathPoint>& points) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!ground.clear(points[i], points[i + 1])) return false;
  }
  return true;
}

}  // namespace

FollowedTrack track_of(const PlanInput& input, int graph, const FollowedHerd& followed, const FineGround& ground) {
  FollowedTrack track;
  for (const CourseLeg& leg : *followed.course) {
    if (leg.points.size() < 2) continue;
    std::vector<PathPoint> points = leg.points;
    std::vector<float> hours = leg.hours;
    if (!can_walk(ground, points)) {
      const PathCell from = cell_at(points.front());
      const PathCell to = cell_at(points.back());
      if (!ground.passable(from.x, from.y) || !ground.passable(to.x, to.y)) return {};
      points = way_between(input, graph, ground, from, to).points;
      if (points.size() < 2) return {};
      hours = hours_along(leg, points);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      double metres = 0;
      double cost = 0;
      if (!track.points.empty()) {
        cost = track.cost.back() + ground.walk_between(track.points.back(), points[i]);
        metres = track.along.back() +
                 std::hypot(double(points[i].x - track.points.back().x), double(points[i].y - track.points.back().y)) *
                     ground.cell_size();
      }
      track.points.push_back(points[i]);
      track.along.push_back(metres);
      track.cost.push_back(cost);
      track.hour.push_back(double(hours[i]));
    }
    const int node = followed.day->stops[std::size_t(leg.to_stop)].node;
    const bool water = followed.graph->nodes[std::size_t(node)].kind == NodeKind::bank;
    track.stops.push_back({track.along.back(), double(hours.back()), water ? node : -1});
  }
  return track;
}

}  // namespace biotope
