#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "core/movement/plan_parts.hpp"

namespace biotope {
namespace {

/// A predator keeps this far behind its herd, m, and comes this near when it drinks beside it. Our choice.
constexpr double nearest_gap = 120;
constexpr double widest_gap = 260;
constexpr double drinking_gap = 40;
/// Waits shorter than this are part of the walk; longer ones than the second are stops, h.
constexpr double short_wait = 1.0 / 60;
constexpr double stop_wait = 10.0 / 60;
/// Time to drink where the herd has drunk before, h, and how much longer than needed it gives itself to catch up. Our choice.
constexpr double drink = 0.25;
constexpr double spare = 0.1;

/// The herd's walks of a day as one line, with the hour the herd passes each point. Stays take no length: a stop's point is there
/// twice.
struct Track {
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

/// The herd's track over ground the predator can walk; empty when there is none.
Track track_of(const PlanInput& input, int graph, const FollowedHerd& followed, const FineGround& ground) {
  Track track;
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

/// Writes a predator's day along a track.
class Follower {
 public:
  Follower(const PlanInput& input, int herd, const FollowedHerd& followed, const FineGround& ground, const Track& track)
      : input_(input), followed_(followed), ground_(ground), track_(track) {
    const Herd& pack = input.level.herds[std::size_t(herd)];
    const AnimalTraits& animal = input.web.species[std::size_t(pack.species)].animal();
    speed_ = double(animal.speed);
    visits_ = animal.water_visits;
    latest_ = track.hour.front() + 24 - spare;
    plan_ = {input.level.level, herd, pack.species, pack.size, followed.plan, {}, active_hours(animal.activity), {}};
    const double unit = random_unit({input.keys[std::size_t(herd)], 21});
    gap_ = std::min(nearest_gap + (widest_gap - nearest_gap) * unit, track.length() / 4);
  }

  std::optional<std::pair<DailyPlan, HerdCourse>> write() {
    const double start = track_.hour.front();
    // The evening before it stopped short of the herd's home; from there it walks on when the herd leaves.
    const double hold = track_.length() - gap_;
    put(start, track_.point_at(hold));
    const std::size_t first = track_.before(hold) + 1;
    for (std::size_t i = first; i < track_.points.size(); ++i) go(track_.along[i] - track_.length(), track_.points[i]);
    for (std::size_t i = 1; i < track_.points.size() && track_.along[i] < hold; ++i) go(track_.along[i], track_.points[i]);
    go(hold, track_.point_at(hold));
    if (hour_ > start + 24) return std::nullopt;
    stop(hour_, start + 24, track_.hour.back());
    put(start + 24, plan_.way.front().at);
    return std::pair{std::move(plan_), std::move(course_)};
  }

 private:
  void put(double hour, PathPoint at) {
    hour_ = hour;
    at_ = at;
    plan_.way.push_back({float(hour), at});
    leg_.points.push_back(at);
    leg_.hours.push_back(float(hour));
  }

  /// Hour before which it does not pass a place: when the herd is a gap further on, or has come to drink close by. While it is
  /// not active it rests where it is, and sets out in time to be behind the herd again when it is.
  [[nodiscard]] double not_before(double along) const {
    const double passing = passing_hour(along);
    for (std::size_t i = 0; i < plan_.active.size(); ++i) {
      const double rest = double(plan_.active[i].until);
      const double wake = i + 1 < plan_.active.size() ? double(plan_.active[i + 1].from) : double(plan_.active.front().from) + 24;
      for (const double day : {-24.0, 0.0, 24.0}) {
        if (passing <= rest + day || passing >= wake + day) continue;
        const double there = std::max(along, std::min(track_.along_at(wake + day), track_.length()) - gap_);
        const double walk = cost_between(along, there) / speed_ / 3600;
        return std::max(passing, std::min(wake + day, latest_) - walk * (1 + spare) - drinking_hours(along, there));
      }
    }
    return passing;
  }
  /// Before the track's begin is its end, from the evening before.
  [[nodiscard]] double cost_between(double from, double until) const {
    if (from >= 0) return track_.cost_at(until) - track_.cost_at(from);
    const double begin = track_.cost.back() - track_.cost_at(track_.length() + from);
    return until >= 0 ? begin + track_.cost_at(until) : begin - (track_.cost.back() - track_.cost_at(track_.length() + until));
  }
  /// Time it takes to drink on the way between two places of the track, h.
  [[nodiscard]] double drinking_hours(double from, double until) const {
    double hours = 0;
    for (const Track::Stop& place : track_.stops)
      hours += place.bank >= 0 && place.along > from && place.along <= until ? drink : 0.0;
    return hours;
  }
  [[nodiscard]] double passing_hour(double along) const {
    const double herd_gone = track_.hour_at(along + gap_);
    for (const Track::Stop& place : track_.stops) {
      if (place.bank >= 0 && along > place.along - gap_ && along <= place.along - std::min(drinking_gap, gap_)) {
        return std::min(herd_gone, place.hour);
      }
    }
    return herd_gone;
  }

  void go(double along, PathPoint to) {
    const double walk = ground_.walk_between(at_, to) / speed_ / 3600;
    const double arrive = std::max(hour_ + walk, not_before(along));
    const double wait = arrive - walk - hour_;
    if (wait > stop_wait) wait_from(hour_, arrive - walk);
    if (wait > short_wait) put(arrive - walk, at_);
    put(arrive, to);
    drink_at(along);
  }

  /// Where the herd has drunk before it, it drinks too, unless it just did.
  void drink_at(double along) {
    for (const Track::Stop& place : track_.stops) {
      if (place.bank < 0 || place.along <= last_along_ || place.along > along || drunk_ >= visits_ || hour_ < last_drink_ + 1)
        continue;
      const int bank = bank_near(followed_.graph->nodes[std::size_t(place.bank)]);
      if (bank < 0 || hour_ + drink > latest_) continue;
      end_leg(bank, hour_, hour_ + drink);
      put(hour_ + drink, at_);
    }
    last_along_ = along;
  }

  /// A wait is a stop, or one stop and the next where the herd goes to drink, or on from there, while the predator stays.
  void wait_from(double from, double until) {
    for (const PlanStop& place : followed_.day->stops) {
      const double later = double(place.arrive);
      if (later <= from + stop_wait || later >= until - stop_wait) continue;
      if (node_at(later) == node_at(0.5 * (from + later))) continue;
      stop(from, later, 0.5 * (from + later));
      from = later;
    }
    stop(from, until, from + 0.01);
  }

  /// A stop while the herd is where it is at `during`.
  void stop(double arrive, double leave, double during) { end_leg(node_at(during), arrive, leave); }

  void end_leg(int node, double arrive, double leave) {
    if (node != followed_.prey_node) {
      ++drunk_;
      last_drink_ = leave;
    }
    plan_.stops.push_back({node, float(arrive), float(leave)});
    leg_.to_stop = int(plan_.stops.size()) - 1;
    const int next = leg_.to_stop;
    course_.push_back(std::move(leg_));
    leg_ = {{at_}, {float(leave)}, next, 0};
  }

  /// The bank close by where the herd drinks, or the node that stands for the herd.
  [[nodiscard]] int node_at(double hour) const {
    for (const PlanStop& place : followed_.day->stops) {
      if (hour < double(place.arrive) || hour > double(place.leave)) continue;
      const ResourceNode& theirs = followed_.graph->nodes[std::size_t(place.node)];
      if (theirs.kind != NodeKind::bank) continue;
      if (std::hypot(double(at_.x) - theirs.x, double(at_.y) - theirs.y) * ground_.cell_size() > 2 * widest_gap) continue;
      if (const int bank = bank_near(theirs); bank >= 0) return bank;
    }
    return followed_.prey_node;
  }
  [[nodiscard]] int bank_near(const ResourceNode& theirs) const {
    const auto& nodes = input_.level.graph->nodes;
    int best = -1;
    double nearest = widest_gap;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].kind != NodeKind::bank) continue;
      const double metres = std::hypot(double(nodes[i].x - theirs.x), double(nodes[i].y - theirs.y)) * ground_.cell_size();
      if (metres >= nearest) continue;
      nearest = metres;
      best = int(i);
    }
    return best;
  }

  const PlanInput& input_;
  const FollowedHerd& followed_;
  const FineGround& ground_;
  const Track& track_;
  double speed_ = 1;
  double gap_ = 0;
  double latest_ = 24;
  double hour_ = 0;
  PathPoint at_;
  double last_along_ = 0;
  int visits_ = 0;
  int drunk_ = 0;
  double last_drink_ = -24;
  CourseLeg leg_;
  DailyPlan plan_;
  HerdCourse course_;
};

/// A place in sight of a herd that stays at home all day.
std::optional<std::pair<DailyPlan, HerdCourse>> lie_in_wait(const PlanInput& input, int herd, const FollowedHerd& followed,
                                                            const FineGround& ground) {
  DailyPlan plan = stand_still(input, herd);
  const PathPoint home = followed.day->way.front().at;
  if (!ground.passable(home)) return std::nullopt;
  PathPoint at = home;
  constexpr std::uint64_t tries = 64;
  for (std::uint64_t i = 0; i < tries; ++i) {
    const auto unit = [&](std::uint64_t what) { return random_unit({input.keys[std::size_t(herd)], i, what}); };
    const double angle = 2 * 3.14159265358979 * unit(31);
    const double cells = (nearest_gap + (widest_gap - nearest_gap) * unit(32)) / ground.cell_size();
    const PathPoint place{home.x + float(cells * std::cos(angle)), home.y + float(cells * std::sin(angle))};
    if (!ground.clear(home, place)) continue;
    at = place;
    break;
  }
  for (auto& waypoint : plan.way) waypoint.at = at;
  plan.followed = followed.plan;
  plan.stops = {{followed.prey_node, plan.way.front().hour, plan.way.back().hour}};
  return std::pair{std::move(plan), HerdCourse{}};
}

}  // namespace

std::optional<std::pair<DailyPlan, HerdCourse>> follow_herd(const PlanInput& input, int herd, const FollowedHerd& followed,
                                                            const FineGround& ground) {
  if (followed.course->empty()) return lie_in_wait(input, herd, followed, ground);
  const LevelTravel& travel = *input.movement.travel;
  const int species = species_index_of(input.level, input.level.herds[std::size_t(herd)]);
  const Track track = track_of(input, travel.graph_of_species[std::size_t(species)], followed, ground);
  if (track.points.size() < 2 || track.length() <= 0) return std::nullopt;
  return Follower(input, herd, followed, ground, track).write();
}

}  // namespace biotope
