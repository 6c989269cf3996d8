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

/// Adds a walk of the herd, by another way where the predator cannot walk the same; false when there is none.
bool append_leg(const PlanInput& input, int graph, const FollowedHerd& followed, const FineGround& ground, const CourseLeg& leg,
                double later, FollowedTrack& track) {
  if (leg.points.size() < 2) return true;
  std::vector<PathPoint> points = leg.points;
  std::vector<float> hours = leg.hours;
  if (!can_walk(ground, points)) {
    const PathCell from = cell_at(points.front());
    const PathCell to = cell_at(points.back());
    if (!ground.passable(from.x, from.y) || !ground.passable(to.x, to.y)) return false;
    points = way_between(input, graph, ground, from, to).points;
    if (points.size() < 2) return false;
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
    track.hour.push_back(double(hours[i]) + later);
  }
  const int node = followed.day->stops[std::size_t(leg.to_stop)].node;
  const bool water = followed.graph->nodes[std::size_t(node)].kind == NodeKind::bank;
  track.stops.push_back({track.along.back(), track.hour.back(), water ? node : -1});
  return true;
}

/// The part of a walk from `skipped` metres after its begin to an hour, and at least one point before and after.
CourseLeg part_of(const CourseLeg& leg, double skipped, double until, double cell_size) {
  std::size_t first = 0;
  double metres = 0;
  while (first + 2 < leg.points.size()) {
    metres +=
        std::hypot(double(leg.points[first + 1].x - leg.points[first].x), double(leg.points[first + 1].y - leg.points[first].y)) *
        cell_size;
    if (metres > skipped) break;
    ++first;
  }
  std::size_t last = first + 1;
  while (last + 1 < leg.points.size() && double(leg.hours[last]) < until) ++last;
  CourseLeg part{{}, {}, leg.from_stop, leg.to_stop};
  if (last >= leg.points.size()) return part;
  const auto begin = std::ptrdiff_t(first);
  const auto end = std::ptrdiff_t(last + 1);
  part.points.assign(leg.points.begin() + begin, leg.points.begin() + end);
  part.hours.assign(leg.hours.begin() + begin, leg.hours.begin() + end);
  return part;
}

double length_of(const CourseLeg& leg, double cell_size) {
  double cells = 0;
  for (std::size_t i = 1; i < leg.points.size(); ++i)
    cells += std::hypot(double(leg.points[i].x - leg.points[i - 1].x), double(leg.points[i].y - leg.points[i - 1].y));
  return cells * cell_size;
}

/// The walks of a herd that does the same every day: the number of a walk goes on from day to day, also backward.
class RepeatedCourse {
 public:
  explicit RepeatedCourse(const HerdCourse& course) : course_(course), count_(std::int64_t(course.size())) {}

  [[nodiscard]] const CourseLeg& leg(std::int64_t number) const { return course_[std::size_t(number - day(number) * count_)]; }
  [[nodiscard]] double later(std::int64_t number) const { return 24 * double(day(number)); }
  [[nodiscard]] double begin(std::int64_t number) const { return double(leg(number).hours.front()) + later(number); }
  [[nodiscard]] double end(std::int64_t number) const { return double(leg(number).hours.back()) + later(number); }
  /// The last walk that begins before an hour.
  [[nodiscard]] std::int64_t before(double hour) const {
    auto number = std::int64_t(std::floor((hour - double(course_.front().hours.front())) / 24)) * count_ + count_ - 1;
    while (begin(number) > hour) --number;
    return number;
  }

 private:
  [[nodiscard]] std::int64_t day(std::int64_t number) const { return (number < 0 ? number - count_ + 1 : number) / count_; }
  const HerdCourse& course_;
  std::int64_t count_;
};

}  // namespace

FollowedTrack track_of(const PlanInput& input, int graph, const FollowedHerd& followed, const FineGround& ground) {
  FollowedTrack track;
  for (const CourseLeg& leg : *followed.course) {
    if (!append_leg(input, graph, followed, ground, leg, 0, track)) return {};
  }
  return track;
}

FollowedTrack track_between(const PlanInput& input, int graph, const FollowedHerd& followed, const FineGround& ground,
                            double from, double until, double behind) {
  FollowedTrack track;
  if (followed.course->empty()) return track;
  const RepeatedCourse course(*followed.course);
  const std::int64_t here = course.before(from);
  const auto count = std::int64_t(followed.course->size());
  std::int64_t first = here;
  double walked = course.end(here) <= from ? length_of(course.leg(here), ground.cell_size()) : 0;
  while (walked < behind && first > here - count) walked += length_of(course.leg(--first), ground.cell_size());
  for (std::int64_t number = first; number < first + 2 * count && (number <= here || course.begin(number) < until); ++number) {
    const double later = course.later(number);
    const CourseLeg part = part_of(course.leg(number), number == first ? walked - behind : 0, until - later, ground.cell_size());
    if (!append_leg(input, graph, followed, ground, part, later, track)) return {};
  }
  return track;
}

}  // namespace biotope
