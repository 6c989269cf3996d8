#include <algorithm>
#include <utility>

#include "core/movement/herd_simulation_slot.hpp"

namespace biotope {

namespace {

/// Farthest from a stop's place that members look for room there (to drink, most of all), m.
constexpr double stop_reach = 200;
/// Farthest that a herd walks in a run, m, besides where its members are around its place.
constexpr double run_reach = 250;

bool same_plan(const DailyPlan& a, const DailyPlan& b) {
  const auto same_stop = [](const PlanStop& s, const PlanStop& t) {
    return s.node == t.node && s.arrive == t.arrive && s.leave == t.leave;
  };
  const auto same_span = [](const DailyPlan::Span& s, const DailyPlan::Span& t) {
    return s.from == t.from && s.until == t.until;
  };
  const auto same_point = [](const DailyPlan::Waypoint& s, const DailyPlan::Waypoint& t) {
    return s.hour == t.hour && s.at.x == t.at.x && s.at.y == t.at.y;
  };
  return a.level == b.level && a.herd == b.herd && a.species == b.species && a.size == b.size && a.pursuits == b.pursuits &&
         std::equal(a.stops.begin(), a.stops.end(), b.stops.begin(), b.stops.end(), same_stop) &&
         std::equal(a.active.begin(), a.active.end(), b.active.begin(), b.active.end(), same_span) &&
         std::equal(a.way.begin(), a.way.end(), b.way.begin(), b.way.end(), same_point);
}

bool same_kinds(const DailyPlan& plan, const GraphLevel& a, const GraphLevel& b) {
  return std::all_of(plan.stops.begin(), plan.stops.end(), [&](const PlanStop& stop) {
    const auto node = std::size_t(stop.node);
    return node < a.nodes.size() && node < b.nodes.size() && a.nodes[node].kind == b.nodes[node].kind;
  });
}

/// Whether a herd may stand on the same cells of a rectangle.
bool same_region(const HerdWorld& world, const HerdRegion& a, const HerdRegion& b, Place low, Place high) {
  if (a.labels == b.labels && a.label == b.label) return true;
  const HerdWorld::Cell north_west = world.cell_of({low.x, high.y});
  const HerdWorld::Cell south_east = world.cell_of({high.x, low.y});
  for (int y = north_west.y; y <= south_east.y; ++y) {
    for (int x = north_west.x; x <= south_east.x; ++x) {
      if (a.holds({x, y}) != b.holds({x, y})) return false;
    }
  }
  return true;
}

bool comparable(const HerdWorld& a, const HerdWorld& b) {
  return a.seed == b.seed && a.plans->size() == b.plans->size() && a.terrain().cell_size == b.terrain().cell_size &&
         a.terrain().height.width() == b.terrain().height.width() && a.terrain().height.height() == b.terrain().height.height();
}

}  // namespace

/// Whether a herd's cast would be the same in the world of now.
bool HerdSimulation::same_herd(const HerdCast& cast, const HerdWorld& before) const {
  const auto number = std::size_t(cast.plan_number);
  const DailyPlan& now = (*world_->plans)[number];
  const DailyPlan& then = (*before.plans)[number];
  if (world_->plans != before.plans && !same_plan(now, then)) return false;
  const auto species = [](const HerdWorld& world, const DailyPlan& plan) -> const Species& {
    return world.web->species[std::size_t(plan.species)];
  };
  if (world_->web != before.web && species(*world_, now).traits != species(before, then).traits) return false;
  if (world_->graph != before.graph && !same_kinds(now, world_->graph_of(now), before.graph_of(then))) return false;
  if (cast.predators != predators_[number]) return false;
  if (world_->levels != before.levels && cast.young_share != herd_young_share(*world_, now)) return false;
  const HerdRegion region = herd_region(*world_, now);
  for (std::size_t stop = 0; stop < cast.stops.size(); ++stop) {
    if (stop < cast.beside.size() && stays_.before(cast.plan_number, stop) != cast.beside[stop]) return false;
    const double reach = stop_reach + herd_reach(*world_, now);
    const Place low = cast.stops[stop].centre - Place{reach, reach};
    const Place high = cast.stops[stop].centre + Place{reach, reach};
    if (!same_region(*world_, cast.region, region, low, high) || !world_->same_within(before, low, high)) return false;
  }
  return true;
}

/// Forgets the runs of a herd around which something changed.
void HerdSimulation::keep_runs(Slot& slot, const HerdWorld& before) const {
  const HerdRegion region = herd_region(*world_, slot.cast->plan());
  const double reach = run_reach + herd_reach(*world_, slot.cast->plan());
  std::erase_if(slot.runs, [&](const auto& entry) {
    const BoidRun& run = *entry.second;
    const double start = entry.first * checkpoint_seconds;
    if (run.predators() != predators_near(slot.cast->plan_number, start, start + run_seconds)) return true;
    const Place low = run.origin() - Place{reach, reach};
    const Place high = run.origin() + Place{reach, reach};
    return !same_region(*world_, slot.cast->region, region, low, high) || !world_->same_within(before, low, high);
  });
}

void HerdSimulation::follow(std::shared_ptr<const HerdWorld> world) {
  if (world == world_) return;
  const std::shared_ptr<const HerdWorld> before = std::exchange(world_, std::move(world));
  const bool known = comparable(*before, *world_);
  if (before->plans != world_->plans || before->web != world_->web || !known) {
    predators_ = predators_of_plans(*world_);
    stays_ = HerdStays(*world_);
  }
  if (!known) {
    slots_.clear();
    slots_.resize(world_->plans->size());
    return;
  }
  // Casts are shared between herds and those that hunt them.
  std::map<int, bool> same;
  const auto is_same = [&](const HerdCast& cast) {
    const auto [found, added] = same.emplace(cast.plan_number, false);
    if (added) found->second = same_herd(cast, *before);
    return found->second;
  };
  for (std::unique_ptr<Slot>& slot : slots_) {
    if (!slot || !slot->cast) continue;
    if (!is_same(*slot->cast)) {
      slot.reset();
      continue;
    }
    if (std::erase_if(slot->others, [&](const auto& other) { return !is_same(*other.second); }) > 0) slot->runs.clear();
    keep_runs(*slot, *before);
  }
  const auto move_on = [&](HerdCast& cast) {
    cast.world = world_;
    cast.region = herd_region(*world_, cast.plan());
  };
  for (std::unique_ptr<Slot>& slot : slots_) {
    if (!slot || !slot->cast) continue;
    move_on(*slot->cast);
    for (auto& [plan, other] : slot->others) move_on(*other);
  }
}

}  // namespace biotope
