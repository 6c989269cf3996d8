#include "core/movement/plan_hunt.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/random.hpp"
#include "core/movement/plan_hunt_choice.hpp"
#include "core/movement/plan_track.hpp"

namespace biotope {
namespace {

using PlannedDay = std::pair<DailyPlan, HerdCourse>;

/// Visits shorter than this are left out, h. Our choice.
constexpr double shortest_kept = 0.2;
/// It is back so long before the day begins anew, so that rounding never makes it late, h.
constexpr double margin = 1e-3;

/// Walks the steps of one pack's day.
class HuntWriter {
 public:
  HuntWriter(HuntGround& hunt, PathPoint rest) : hunt_(hunt), rest_(rest), speed_(double(hunt.animal.speed)) {
    const Herd& pack = hunt.herd;
    plan_ = {hunt.input.level.level, hunt.pack.herd, pack.species, pack.size, {}, {}, active_hours(hunt.animal.activity), {}};
    gap_ = nearest_gap + (widest_gap - nearest_gap) * random_unit({hunt.input.keys[std::size_t(hunt.pack.herd)], 21});
    put(double(plan_.active.front().from), rest);
  }

  [[nodiscard]] double hour() const { return hour_; }
  [[nodiscard]] PathPoint at() const { return at_; }

  void take(const HuntStep& step) {
    rest_until(double(plan_.active[step.span].from));
    if (step.prey >= 0) {
      visit(step);
    } else {
      drink_at(step.bank);
    }
  }

  std::optional<PlannedDay> finish() {
    const double end = double(plan_.way.front().hour) + 24;
    if (plan_.pursuits.empty() || !walk_to(rest_) || hour_ > end - margin) return std::nullopt;
    arrive(resting_node());
    put(end, rest_);
    leave();
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
  [[nodiscard]] double hours_between(PathPoint a, PathPoint b) const { return hunt_.ground.walk_between(a, b) / speed_ / 3600; }

  /// By the last search, if it was made from here and came there, or by another one.
  [[nodiscard]] NodeWay way_to(PathCell from, PathCell goal) {
    const int here = hunt_.graph.vertex_of_cell(from.x, from.y);
    const int there = hunt_.graph.vertex_of_cell(goal.x, goal.y);
    if (here < 0 || there < 0) return {};
    const auto target = std::uint32_t(there);
    if (hunt_.searched_from != here || !std::isfinite(hunt_.search.cost(target))) {
      std::vector<std::uint16_t> goals(hunt_.graph.vertices.size(), 0);
      goals[target] = 1;
      hunt_.search.run(std::uint32_t(here), goals, 1);
      hunt_.searched_from = here;
    }
    const auto vertices = travel_path(hunt_.search, target);
    return vertices.empty() ? NodeWay{} : way_over(hunt_.input, hunt_.number, hunt_.ground, vertices, from, goal);
  }

  /// Walks from where it is; false, and it stays, when there is no way.
  bool walk_to(PathPoint to) {
    if (at_ == to) return true;
    const NodeWay way = way_to(cell_at(at_), cell_at(to));
    if (way.points.empty()) return false;
    const PathPoint entry = way.points.front();
    if (!(entry == at_)) put(hour_ + hours_between(at_, entry), entry);
    const double begin = hour_;
    for (std::size_t i = 1; i < way.points.size(); ++i) put(begin + way.cost[i] / speed_ / 3600, way.points[i]);
    if (!(at_ == to)) put(hour_ + hours_between(at_, to), to);
    return true;
  }

  /// A stop begins, and what was walked since the last one ends; `leave` ends it.
  void arrive(int node) {
    const int stop = int(plan_.stops.size());
    leg_.to_stop = stop;
    if (leg_.points.size() > 1) course_.push_back(std::move(leg_));
    leg_ = {{at_}, {float(hour_)}, stop, stop};
    plan_.stops.push_back({node, float(hour_), float(hour_)});
  }
  void leave() {
    plan_.stops.back().leave = float(hour_);
    const int stop = int(plan_.stops.size()) - 1;
    const auto moved = [&](PathPoint p) { return !(p == leg_.points.front()); };
    if (std::any_of(leg_.points.begin(), leg_.points.end(), moved)) course_.push_back(std::move(leg_));
    leg_ = {{at_}, {float(hour_)}, stop, 0};
  }

  /// Where it rests it is at no resource; what it lives on stands for it.
  [[nodiscard]] int resting_node() const { return hunt_.pack.prey[std::size_t(std::max(last_, 0))].herd.prey_node; }

  void rest_until(double hour) {
    if (hour <= hour_) return;
    arrive(resting_node());
    put(hour, at_);
    leave();
  }

  void drink_at(int bank) {
    const auto cell = standing_cell(hunt_.graph, hunt_.input.level.graph->nodes[std::size_t(bank)]);
    if (!cell || !walk_to({float(cell->x), float(cell->y)})) return;
    arrive(bank);
    put(hour_ + drink, at_);
    leave();
  }

  void visit(const HuntStep& step) {
    const FollowedHerd& herd = hunt_.pack.prey[std::size_t(step.prey)].herd;
    const double until = std::min(std::max(step.leave, step.arrive + shortest_kept), double(plan_.active[step.span].until));
    const FollowedTrack track =
        track_between(hunt_.input, hunt_.number, herd, hunt_.ground, std::max(step.arrive, hour_), until, gap_);
    if (track.points.size() < 2) {
      const PathPoint home = herd.day->way.front().at;
      if (!herd.course->empty() || !hunt_.ground.passable(home)) return;
      if (!walk_to(place_in_sight(hunt_.input, hunt_.pack.herd, home, hunt_.ground)) || hour_ >= until) return;
      stay(step, [&] { put(until, at_); });
      return;
    }
    double hold = std::max(0.0, track.along_at(step.arrive) - gap_);
    for (std::size_t i = track.before(hold); hunt_.wet(track.point_at(hold)) && i > 0; --i) hold = track.along[i];
    if (!walk_to(track.point_at(hold)) || hour_ >= until) return;
    stay(step, [&] { follow(track, hold, until); });
  }

  /// Does something at a herd, and notes how long it had the herd in sight.
  template <class Doing>
  void stay(const HuntStep& step, const Doing& doing) {
    const FollowedHerd& herd = hunt_.pack.prey[std::size_t(step.prey)].herd;
    const double came = hour_;
    last_ = step.prey;
    arrive(herd.prey_node);
    doing();
    leave();
    note_pursuit(herd, came, hour_);
  }

  struct Pass {
    PathPoint at;
    double not_before = 0;
  };
  /// Places along the track from `hold` on and when the herd is a gap further on.
  [[nodiscard]] std::vector<Pass> passes_of(const FollowedTrack& track, double hold) const {
    std::vector<Pass> passes;
    const double last = track.length() - gap_;
    for (std::size_t i = track.before(hold) + 1; i < track.points.size() && track.along[i] <= last; ++i)
      passes.push_back({track.points[i], track.hour_at(track.along[i] + gap_)});
    while (!passes.empty() && hunt_.wet(passes.back().at)) passes.pop_back();
    // Nobody waits in water: what it would wait for there it waits for before it wades in.
    for (std::size_t i = passes.size(); i-- > 1;) {
      Pass& before = passes[i - 1];
      if (hunt_.wet(before.at))
        before.not_before = std::max(before.not_before, passes[i].not_before - hours_between(before.at, passes[i].at));
    }
    return passes;
  }

  /// Walks a gap behind the herd until an hour, or a little longer so that it does not stop in water.
  void follow(const FollowedTrack& track, double hold, double until) {
    for (const Pass& pass : passes_of(track, hold)) {
      const double walk = hours_between(at_, pass.at);
      const double there = std::max(hour_ + walk / trot, pass.not_before);
      if (there > until && !hunt_.wet(at_)) break;
      if (there - walk - hour_ > short_wait) put(there - walk, at_);
      put(there, pass.at);
    }
    if (hour_ < until) put(until, at_);
  }

  /// Both walk straight between the points of their ways, so that they are farthest from each other at one of these.
  void note_pursuit(const FollowedHerd& herd, double from, double until) {
    std::vector<double> hours{from, until};
    const auto add = [&](const DailyPlan& plan) {
      for (const DailyPlan::Waypoint& point : plan.way) {
        const double hour = double(point.hour) + 24 * std::ceil((from - double(point.hour)) / 24);
        if (hour < until) hours.push_back(hour);
      }
    };
    add(plan_);
    add(*herd.day);
    std::sort(hours.begin(), hours.end());
    const auto seen = [&](double hour) {
      const PathPoint ours = place_on_way(plan_, hour);
      const PathPoint theirs = place_on_way(*herd.day, hour);
      return std::hypot(double(ours.x - theirs.x), double(ours.y - theirs.y)) * hunt_.ground.cell_size() <= sight;
    };
    const auto found = std::find_if(hours.begin(), hours.end(), seen);
    const auto lost = std::find_if_not(found, hours.end(), seen);
    if (found == hours.end() || *(lost - 1) - *found < shortest_kept / 2) return;
    plan_.pursuits.push_back({float(*found), float(*(lost - 1)), herd.plan});
  }

  HuntGround& hunt_;
  PathPoint rest_;
  double speed_ = 1;
  double gap_ = 0;
  double hour_ = 0;
  PathPoint at_;
  int last_ = -1;
  CourseLeg leg_;
  DailyPlan plan_;
  HerdCourse course_;
};

}  // namespace

HuntGround::HuntGround(const PlanInput& plan_input, const HuntingPack& hunting_pack)
    : input(plan_input),
      pack(hunting_pack),
      herd(input.level.herds[std::size_t(pack.herd)]),
      animal(input.web.species[std::size_t(herd.species)].animal()),
      number(input.movement.travel->graph_of_species[std::size_t(species_index_of(input.level, herd))]),
      graph(*input.movement.travel->graphs[std::size_t(number)]),
      ground(fine_ground(input, number)),
      search(graph, way_costs(input, number)) {}

int HuntGround::vertex_at(PathPoint at) const {
  const PathCell cell = cell_at(at);
  if (!ground.passable(cell.x, cell.y)) return -1;
  const int vertex = graph.vertex_of_cell(cell.x, cell.y);
  return vertex >= 0 && graph.vertices[std::size_t(vertex)].region == herd.region ? vertex : -1;
}

bool HuntGround::wet(PathPoint at) const {
  const PathCell cell = cell_at(at);
  return ground.wet(ground.height().index(cell.x, cell.y));
}

PathPoint place_on_way(const DailyPlan& plan, double hour) {
  const double first = double(plan.way.front().hour);
  const double at = hour - 24 * std::floor((hour - first) / 24);
  const auto after = std::upper_bound(plan.way.begin(), plan.way.end(), at,
                                      [](double h, const DailyPlan::Waypoint& point) { return h < double(point.hour); });
  if (after == plan.way.end() || after == plan.way.begin()) return plan.way.back().at;
  const DailyPlan::Waypoint& a = *(after - 1);
  const DailyPlan::Waypoint& b = *after;
  const auto t = float((at - double(a.hour)) / (double(b.hour) - double(a.hour)));
  return {a.at.x + (b.at.x - a.at.x) * t, a.at.y + (b.at.y - a.at.y) * t};
}

std::optional<PlannedDay> hunting_day(const PlanInput& input, const HuntingPack& pack) {
  HuntGround ground(input, pack);
  HuntChoice choice(ground);
  HuntWriter writer(ground, choice.rest());
  while (!choice.done()) {
    choice.look(writer.hour(), writer.at());
    if (const std::optional<HuntStep> step = choice.choose()) writer.take(*step);
  }
  return writer.finish();
}

}  // namespace biotope
