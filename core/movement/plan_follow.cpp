#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "core/movement/plan_track.hpp"

namespace biotope {
namespace {

/// It comes this near to its herd when it drinks beside it, m. Our choice.
constexpr double drinking_gap = 40;
/// Waits longer than this are stops, h.
constexpr double stop_wait = 10.0 / 60;
/// How much longer than needed it gives itself to catch up. Our choice.
constexpr double spare = 0.1;
/// Its place and the herd's are compared so often, h. Our choice.
constexpr double sight_step = 0.01;

/// Writes a predator's day along a track.
class Follower {
 public:
  Follower(const PlanInput& input, int herd, const FollowedHerd& followed, const FineGround& ground, const FollowedTrack& track)
      : input_(input), followed_(followed), ground_(ground), track_(track) {
    const Herd& pack = input.level.herds[std::size_t(herd)];
    const AnimalTraits& animal = input.web.species[std::size_t(pack.species)].animal();
    speed_ = double(animal.speed);
    visits_ = animal.water_visits;
    latest_ = track.hour.front() + 24 - spare;
    plan_ = {input.level.level, herd, pack.species, pack.size, {}, {}, active_hours(animal.activity), {}};
    const double unit = random_unit({input.keys[std::size_t(herd)], 21});
    gap_ = std::min(nearest_gap + (widest_gap - nearest_gap) * unit, track.length() / 4);
  }

  std::optional<std::pair<DailyPlan, HerdCourse>> write() {
    const double start = track_.hour.front();
    const std::vector<Pass> passes = passes_of_day();
    put(start, passes.front().at);
    for (std::size_t i = 1; i < passes.size(); ++i) go(passes[i]);
    if (hour_ > start + 24) return std::nullopt;
    stop(hour_, start + 24, track_.hour.back());
    put(start + 24, plan_.way.front().at);
    return std::pair{std::move(plan_), std::move(course_)};
  }

 private:
  /// A place of the track and the hour before which it is not passed.
  struct Pass {
    double along = 0;
    PathPoint at;
    double not_before = 0;
  };

  /// The evening before it stopped short of the herd's home; from there it walks on when the herd leaves, to the same place
  /// again.
  [[nodiscard]] std::vector<Pass> passes_of_day() const {
    const double hold = resting_place();
    std::vector<Pass> passes{{hold - track_.length(), track_.point_at(hold), 0}};
    const std::size_t first = track_.before(hold) + 1;
    for (std::size_t i = first; i < track_.points.size(); ++i)
      passes.push_back({track_.along[i] - track_.length(), track_.points[i], 0});
    for (std::size_t i = 1; i < track_.points.size() && track_.along[i] < hold; ++i)
      passes.push_back({track_.along[i], track_.points[i], 0});
    passes.push_back({hold, track_.point_at(hold), 0});
    for (Pass& pass : passes) pass.not_before = not_before(pass.along);
    // Nobody waits in water: what it would wait for there it waits for before it wades in.
    for (std::size_t i = passes.size() - 1; i > 0; --i) {
      Pass& before = passes[i - 1];
      if (!wet(before.at)) continue;
      before.not_before = std::max(before.not_before, passes[i].not_before - hours_between(before.at, passes[i].at));
    }
    return passes;
  }
  /// How far along the track it rests: a gap before its end, or farther back where that is in water.
  [[nodiscard]] double resting_place() const {
    const double hold = track_.length() - gap_;
    if (!wet(track_.point_at(hold))) return hold;
    for (std::size_t i = track_.before(hold); i > 0; --i) {
      if (!wet(track_.points[i])) return track_.along[i];
    }
    return hold;
  }
  [[nodiscard]] bool wet(PathPoint at) const {
    const PathCell cell = cell_at(at);
    return ground_.wet(ground_.height().index(cell.x, cell.y));
  }
  [[nodiscard]] double hours_between(PathPoint a, PathPoint b) const { return ground_.walk_between(a, b) / speed_ / 3600; }

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
    for (const FollowedTrack::Stop& place : track_.stops)
      hours += place.bank >= 0 && place.along > from && place.along <= until ? drink : 0.0;
    return hours;
  }
  [[nodiscard]] double passing_hour(double along) const {
    const double herd_gone = track_.hour_at(along + gap_);
    for (const FollowedTrack::Stop& place : track_.stops) {
      if (place.bank >= 0 && along > place.along - gap_ && along <= place.along - std::min(drinking_gap, gap_)) {
        return std::min(herd_gone, place.hour);
      }
    }
    return herd_gone;
  }

  void go(const Pass& pass) {
    const double walk = hours_between(at_, pass.at);
    const double wait = pass.not_before - walk - hour_;
    const double arrive = std::max(hour_ + walk / trot, pass.not_before);
    if (wait > stop_wait) wait_from(hour_, arrive - walk);
    if (wait > short_wait) put(arrive - walk, at_);
    put(arrive, pass.at);
    drink_at(pass.along);
  }

  /// Where the herd has drunk before it, it drinks too, unless it just did; from the bank, not in the stream.
  void drink_at(double along) {
    if (wet(at_)) return;
    for (const FollowedTrack::Stop& place : track_.stops) {
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
  const FollowedTrack& track_;
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

/// Waits for a herd that stays at home all day.
std::optional<std::pair<DailyPlan, HerdCourse>> lie_in_wait(const PlanInput& input, int herd, const FollowedHerd& followed,
                                                            const FineGround& ground) {
  DailyPlan plan = stand_still(input, herd);
  const PathPoint home = followed.day->way.front().at;
  if (!ground.passable(home)) return std::nullopt;
  const PathPoint at = place_in_sight(input, herd, home, ground);
  for (auto& waypoint : plan.way) waypoint.at = at;
  plan.stops = {{followed.prey_node, plan.way.front().hour, plan.way.back().hour}};
  return std::pair{std::move(plan), HerdCourse{}};
}

/// It keeps to one herd whenever it is active.
void pursue_all_day(DailyPlan& plan, int followed) {
  const auto push = [&](float from, float until) {
    if (from < until) plan.pursuits.push_back({from, until, followed});
  };
  const float begin = plan.way.front().hour;
  // The hours of the plan begin with its way, which may be later than the first hour of the day at which it is active.
  for (const float day : {-24.0F, 0.0F, 24.0F}) {
    for (const DailyPlan::Span& span : plan.active)
      push(std::max(span.from + day, begin), std::min(span.until + day, begin + 24));
  }
}

/// Farthest that a predator is from its herd while it is active, m.
double farthest_while_active(const PlanInput& input, const DailyPlan& plan, const FollowedHerd& followed, double cell_size) {
  double farthest = 0;
  for (const DailyPlan::Span& span : plan.active) {
    for (double hour = double(span.from); hour < double(span.until); hour += sight_step) {
      const PathPoint at = herd_state(plan, *input.level.graph, hour, cell_size).at;
      const PathPoint herd = herd_state(*followed.day, *followed.graph, hour, cell_size).at;
      farthest = std::max(farthest, std::hypot(double(at.x - herd.x), double(at.y - herd.y)) * cell_size);
    }
  }
  return farthest;
}

}  // namespace

PathPoint place_in_sight(const PlanInput& input, int herd, PathPoint home, const FineGround& ground) {
  constexpr std::uint64_t tries = 64;
  for (std::uint64_t i = 0; i < tries; ++i) {
    const auto unit = [&](std::uint64_t what) { return random_unit({input.keys[std::size_t(herd)], i, what}); };
    const double angle = 2 * 3.14159265358979 * unit(31);
    const double cells = (nearest_gap + (widest_gap - nearest_gap) * unit(32)) / ground.cell_size();
    const PathPoint place{home.x + float(cells * std::cos(angle)), home.y + float(cells * std::sin(angle))};
    if (ground.clear(home, place)) return place;
  }
  return home;
}

std::optional<std::pair<DailyPlan, HerdCourse>> follow_herd(const PlanInput& input, int herd, const FollowedHerd& followed,
                                                            const FineGround& ground) {
  std::optional<std::pair<DailyPlan, HerdCourse>> day;
  if (followed.course->empty()) {
    day = lie_in_wait(input, herd, followed, ground);
  } else {
    const int species = species_index_of(input.level, input.level.herds[std::size_t(herd)]);
    const FollowedTrack track = track_of(input, input.movement.travel->graph_of_species[std::size_t(species)], followed, ground);
    if (track.points.size() < 2 || track.length() <= 0) return std::nullopt;
    day = Follower(input, herd, followed, ground, track).write();
  }
  if (!day || farthest_while_active(input, day->first, followed, ground.cell_size()) > sight) return std::nullopt;
  pursue_all_day(day->first, followed.plan);
  return day;
}

}  // namespace biotope
