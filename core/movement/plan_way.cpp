#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "core/movement/plan_parts.hpp"

namespace biotope {
namespace {

/// A herd that feeds goes up to this far from where it came in, m; at water less. Our choice.
constexpr double feeding_range = 120;
constexpr double drinking_range = 40;
/// Who looks for prey by itself roams this far, m. Our choice.
constexpr double hunting_range = 400;
/// It strolls at this share of its walking speed, and stands for some minutes in between. Our choice.
constexpr double stroll = 0.3;
/// From one bite of ground to the next it turns by at most this, rad; more where that leads nowhere. Our choice.
constexpr double widest_turn = 1.2;

/// Writes the way of one day.
class DayWriter {
 public:
  DayWriter(const PlanInput& input, int herd_number, const FineGround& ground)
      : input_(input),
        ground_(ground),
        herd_(herd_number),
        speed_(input.web.species[std::size_t(herd().species)].animal().speed) {
    plan_.level = input.level.level;
    plan_.herd = herd_number;
    plan_.species = herd().species;
    plan_.size = herd().size;
    plan_.active = active_hours(input.web.species[std::size_t(herd().species)].animal().activity);
  }

  /// Legs in order; leg i goes from stay i to stay i + 1, the last one home. `share` shortens stays.
  std::pair<DailyPlan, HerdCourse> write(const DayDraft& draft, const std::vector<const NodeWay*>& legs, double share) {
    const float start = plan_.active.front().from;
    double hour = double(start);
    for (std::size_t i = 0; i < draft.stays.size(); ++i) {
      const PlannedStay& stay = draft.stays[i];
      double leave = hour + double(stay.hours) * share;
      if (share == 1) leave = std::max(leave, double(stay.not_before));
      if (legs.empty()) leave = double(start) + 24;
      plan_.stops.push_back({stay.node, float(hour), float(leave)});
      spend(stay.node, hour, leave, i);
      if (legs.empty()) return {std::move(plan_), std::move(course_)};
      hour = walk(*legs[i], leave, int(i), int(i) + 1);
    }
    const int home = draft.stays.front().node;
    plan_.stops.push_back({home, float(hour), start + 24});
    spend(home, hour, double(start) + 24, draft.stays.size());
    return {std::move(plan_), std::move(course_)};
  }

  /// Stops at their hours; the last leg ends a day after the first stop's arrival.
  std::pair<DailyPlan, HerdCourse> write(std::span<const PlanStop> stops, std::span<const NodeWay* const> legs) {
    plan_.stops.assign(stops.begin(), stops.end());
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const double leave = double(stops[i].leave);
      spend(stops[i].node, double(stops[i].arrive), leave, i);
      if (!legs.empty()) walk(*legs[i], leave, int(i), int((i + 1) % stops.size()));
    }
    const DailyPlan::Waypoint first = plan_.way.front();
    plan_.way.push_back({first.hour + 24, first.at});
    return {std::move(plan_), std::move(course_)};
  }

  /// 1 when the day fits into 24 h with a last rest at home, else the share of the stays that does.
  [[nodiscard]] double fitting_share(const DayDraft& draft, const std::vector<const NodeWay*>& legs) const {
    constexpr double rest = 1;
    const double start = double(plan_.active.front().from);
    double hour = start;
    double walking = 0;
    double staying = 0;
    for (std::size_t i = 0; i < draft.stays.size(); ++i) {
      hour = std::max(hour + double(draft.stays[i].hours), double(draft.stays[i].not_before));
      staying += double(draft.stays[i].hours);
      if (legs.empty()) continue;
      hour += hours_of(*legs[i]);
      walking += hours_of(*legs[i]);
    }
    return hour <= start + 24 - rest ? 1.0 : std::min(0.999, (24 - rest - walking) / staying);
  }

 private:
  [[nodiscard]] const Herd& herd() const { return input_.level.herds[std::size_t(herd_)]; }

  [[nodiscard]] double hours_of(const NodeWay& leg) const { return leg.cost.back() / double(speed_) / 3600; }

  void put(double hour, PathPoint at) { plan_.way.push_back({float(hour), at}); }

  double walk(const NodeWay& leg, double hour, int from_stop, int to_stop) {
    CourseLeg course{leg.points, {}, from_stop, to_stop};
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      const double at = hour + leg.cost[i] / double(speed_) / 3600;
      course.hours.push_back(float(at));
      if (i > 0) put(at, leg.points[i]);
    }
    course_.push_back(std::move(course));
    return hour + hours_of(leg);
  }

  [[nodiscard]] const RunMap* area_of(const ResourceNode& node) const {
    if (node.kind == NodeKind::prey) return nullptr;
    const std::size_t layer = node.kind == NodeKind::bank ? 3 : std::size_t(std::clamp(node.group, 0, 2));
    return input_.level.graph->node_of_cell[layer].get();
  }

  /// A stop: the herd strolls over the node while it is active (at waypoints it stands), and is back where it came in when it
  /// leaves.
  void spend(int number, double arrive, double leave, std::size_t stop) {
    const ResourceNode& node = input_.level.graph->nodes[std::size_t(number)];
    const auto cell = standing_cell(*graph(), node);
    const PathPoint entry = cell ? PathPoint{float(cell->x), float(cell->y)} : PathPoint{float(node.x), float(node.y)};
    put(arrive, entry);
    if (cell && node.kind != NodeKind::waypoint) wander(number, node, entry, arrive, active_until(arrive, leave), stop);
    put(leave, entry);
  }
  [[nodiscard]] const TravelGraph* graph() const {
    const LevelTravel& travel = *input_.movement.travel;
    return travel.graphs[std::size_t(travel.graph_of_species[std::size_t(species_index_of(input_.level, herd()))])].get();
  }
  [[nodiscard]] double active_until(double arrive, double leave) const {
    for (const auto& span : plan_.active) {
      for (const double day : {0.0, 24.0, -24.0}) {
        if (arrive >= double(span.from) + day && arrive < double(span.until) + day)
          return std::min(leave, double(span.until) + day);
      }
    }
    return arrive;
  }

  void wander(int number, const ResourceNode& node, PathPoint entry, double hour, double until, std::size_t stop) {
    const RunMap* area = area_of(node);
    const double metres = node.kind == NodeKind::bank   ? drinking_range
                          : node.kind == NodeKind::prey ? hunting_range
                                                        : feeding_range;
    const double range = metres / input_.ground.terrain->cell_size;
    PathPoint at = entry;
    double heading = 2 * 3.14159265358979 * random_unit({input_.keys[std::size_t(herd_)], stop, 15});
    std::uint64_t last_move = 0;
    constexpr std::uint64_t most_tries = 160;
    for (std::uint64_t i = 0; i < most_tries; ++i) {
      const auto unit = [&](std::uint64_t what) { return random_unit({input_.keys[std::size_t(herd_)], stop, i, what}); };
      // On ahead most often, back over the middle at the border.
      const bool outside = std::hypot(double(at.x - entry.x), double(at.y - entry.y)) > 0.8 * range;
      const double ahead = outside ? std::atan2(double(entry.y - at.y), double(entry.x - at.x)) : heading;
      const double angle = ahead + widest_turn * (unit(11) + unit(14) - 1) * (1 + double(i - last_move));
      const double distance = range * (0.15 + 0.35 * unit(12));
      const PathPoint next{std::round(at.x + float(distance * std::cos(angle))),
                           std::round(at.y + float(distance * std::sin(angle)))};
      if (std::hypot(double(next.x - entry.x), double(next.y - entry.y)) > range) continue;
      if (!stands(next) || (area && (*area)(int(next.x), int(next.y)) != number)) continue;
      if (!ground_.clear(at, next) || !ground_.clear(next, entry)) continue;
      const double there = hour + hours_between(at, next) / stroll;
      const double stand = (3 + 9 * unit(13)) / 60;
      const double back = hours_between(next, entry) / stroll;
      if (there + stand + back > until) break;
      put(hour, at);
      put(there, next);
      hour = there + stand;
      heading = std::atan2(double(next.y - at.y), double(next.x - at.x));
      last_move = i;
      at = next;
      put(hour, at);
    }
    if (at.x != entry.x || at.y != entry.y) put(hour + hours_between(at, entry) / stroll, entry);
  }
  /// Whether it may stop there: on passable ground, not in a brook or a ford.
  [[nodiscard]] bool stands(PathPoint at) const {
    return ground_.passable(at) && !ground_.wet(ground_.height().index(int(at.x), int(at.y)));
  }
  /// At the slower of the two ways along the line: it is straight and may be long, so every few metres count.
  [[nodiscard]] double hours_between(PathPoint a, PathPoint b) const {
    const int pieces = std::max(1, int(std::hypot(b.x - a.x, b.y - a.y) / float(ground_.stride())));
    double slowest = 0;
    PathPoint last = a;
    for (int i = 1; i <= pieces; ++i) {
      const float t = float(i) / float(pieces);
      const PathPoint next{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
      slowest = std::max(slowest, std::max(ground_.walk_between(last, next), ground_.walk_between(next, last)));
      last = next;
    }
    return slowest * pieces / double(speed_) / 3600;
  }

  const PlanInput& input_;
  const FineGround& ground_;
  int herd_;
  float speed_;
  DailyPlan plan_;
  HerdCourse course_;
};

}  // namespace

std::pair<DailyPlan, HerdCourse> walk_day(const PlanInput& input, const DayDraft& draft, const NodeWays& ways) {
  if (draft.stays.empty()) return {stand_still(input, draft.herd), {}};
  const int graph = input.movement.travel->graph_of_species[std::size_t(draft.species_index)];
  const FineGround ground = fine_ground(input, graph);
  std::vector<const NodeWay*> legs;
  for (std::size_t i = 0; i < draft.stays.size() && draft.stays.size() > 1; ++i) {
    legs.push_back(ways.get(graph, draft.stays[i].node, draft.stays[(i + 1) % draft.stays.size()].node));
  }
  const bool found = std::find(legs.begin(), legs.end(), nullptr) == legs.end();
  DayWriter writer(input, draft.herd, ground);
  const double share = found ? writer.fitting_share(draft, legs) : 0;
  // Less than a tenth of the stays is no day: the walks are far longer than was thought.
  if (share >= 0.1) return writer.write(draft, legs, share);
  return writer.write({draft.species_index, draft.herd, {draft.stays.front()}}, {}, 1);
}

std::pair<DailyPlan, HerdCourse> write_stops(const PlanInput& input, int herd, std::span<const PlanStop> stops,
                                             std::span<const NodeWay* const> legs) {
  const int species = species_index_of(input.level, input.level.herds[std::size_t(herd)]);
  const FineGround ground = fine_ground(input, input.movement.travel->graph_of_species[std::size_t(species)]);
  return DayWriter(input, herd, ground).write(stops, legs);
}

}  // namespace biotope
