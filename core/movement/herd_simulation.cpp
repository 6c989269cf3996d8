#include "core/movement/herd_simulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/movement/herd_bodies.hpp"
#include "core/movement/herd_simulation_slot.hpp"

namespace biotope {

namespace {

/// Predators farther than this from a herd's place go unnoticed in a run, m: their rush and both herds' members reach no farther.
constexpr double noticed_distance = 450;
/// Seconds between the samples of a formula's track.
constexpr double coarse_step = 10;

float heading_of(Place direction) {
  const double angle = std::atan2(direction.x, direction.y);
  return float(angle < 0 ? angle + 6.283185307179586 : angle);
}

int checkpoint_of(double seconds) { return int(std::floor(seconds / checkpoint_seconds)); }

/// What the guide wants of the body, as far as the body is slow enough for it.
void set_pose(const HerdGuide& guide, const HerdMemberTraits& traits, HerdAnimal& animal) {
  animal.head_down = float(guide.head_down * (1 - smooth_step(0.45, 1.1, double(animal.speed))));
  animal.lying = float(guide.lying * (1 - smooth_step(0.05, 0.3, double(animal.speed))));
  animal.alarm = float(guide.alarm);
  animal.size = traits.size;
  animal.young = traits.young;
  animal.male = traits.male;
}

}  // namespace

HerdSimulation::HerdSimulation(std::shared_ptr<const HerdWorld> world)
    : world_(std::move(world)), predators_(predators_of_plans(*world_)), stays_(*world_), slots_(world_->plans->size()) {}
HerdSimulation::~HerdSimulation() = default;
HerdSimulation::HerdSimulation(HerdSimulation&&) noexcept = default;
HerdSimulation& HerdSimulation::operator=(HerdSimulation&&) noexcept = default;

double herd_reach(const HerdWorld& world, const DailyPlan& plan) {
  const double body = double(world.traits(plan).shape.body_length);
  return body * (6 + 2.0 * std::sqrt(double(plan.size)) + 0.8 * double(plan.size)) + (plan.pursuits.empty() ? 60 : 260);
}

std::shared_ptr<HerdCast> HerdSimulation::cast(int plan) {
  std::unique_ptr<Slot>& slot = slots_[std::size_t(plan)];
  if (!slot) slot = std::make_unique<Slot>();
  slot->used = uses_;
  if (!slot->cast) slot->cast = std::make_shared<HerdCast>(cast_herd(world_, plan, predators_[std::size_t(plan)], &stays_));
  return slot->cast;
}

std::vector<int> HerdSimulation::predators_near(int plan, double from, double until) const {
  const auto place = [&](int number, double seconds) {
    const double in_day = seconds_within_day(seconds / 3600);
    return world_->place_of(world_->state((*world_->plans)[std::size_t(number)], in_day).at);
  };
  std::vector<int> near;
  for (const int predator : predators_[std::size_t(plan)]) {
    for (const double share : {0.0, 0.5, 1.0}) {
      const double seconds = from + (until - from) * share;
      if (length(place(predator, seconds) - place(plan, seconds)) > noticed_distance) continue;
      near.push_back(predator);
      break;
    }
  }
  return near;
}

/// Makes every cast that the requests need, so that tasks only read what they share.
void HerdSimulation::prepare(std::span<const HerdRequest> herds, double seconds) {
  // Casts are made in parallel: each depends on its plan alone.
  std::vector<int> wanted;
  std::vector<std::vector<int>> others(herds.size());
  for (std::size_t i = 0; i < herds.size(); ++i) {
    const int plan = herds[i].plan;
    wanted.push_back(plan);
    if (herds[i].boids > 0) {
      for (const int checkpoint : {checkpoint_of(seconds) - 1, checkpoint_of(seconds)}) {
        const double start = checkpoint_within_a_day(checkpoint) * checkpoint_seconds;
        const std::vector<int> near = predators_near(plan, start, start + run_seconds);
        others[i].insert(others[i].end(), near.begin(), near.end());
      }
    }
    // Whoever is followed in the runs, or a moment before.
    constexpr double rounding = 1;
    const double before = (checkpoint_of(seconds) - 1) * checkpoint_seconds - rounding;
    const double after = checkpoint_of(seconds) * checkpoint_seconds + run_seconds + rounding;
    const std::vector<int> followed = followed_between((*world_->plans)[std::size_t(plan)], before, after);
    others[i].insert(others[i].end(), followed.begin(), followed.end());
    wanted.insert(wanted.end(), others[i].begin(), others[i].end());
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  parallel_each(wanted.size(), [&](std::size_t i) { static_cast<void>(cast(wanted[i])); });
  for (std::size_t i = 0; i < herds.size(); ++i) {
    for (const int other : others[i]) slots_[std::size_t(herds[i].plan)]->others[other] = cast(other);
  }
}

BoidRun& HerdSimulation::run(Slot& slot, int checkpoint) {
  const int number = checkpoint_within_a_day(checkpoint);
  std::unique_ptr<BoidRun>& run = slot.runs[number];
  if (!run) {
    const double start = number * checkpoint_seconds;
    std::vector<std::shared_ptr<const HerdCast>> near;
    for (const int predator : predators_near(slot.cast->plan_number, start, start + run_seconds)) {
      const auto found = slot.others.find(predator);
      assert(found != slot.others.end());
      near.push_back(found->second);
    }
    std::vector<std::shared_ptr<const HerdCast>> followed;
    for (const int herd : followed_between(slot.cast->plan(), start, start + run_seconds))
      followed.push_back(slot.others.at(herd));
    run = std::make_unique<BoidRun>(slot.cast, std::move(near), std::move(followed), number);
  }
  return *run;
}

std::vector<HerdAnimal> HerdSimulation::by_formula(const Slot& slot, double seconds) const {
  const HerdCast& cast = *slot.cast;
  constexpr double apart = 1;
  std::vector<const HerdCast*> followed;
  for (const int herd : followed_between(cast.plan(), seconds - apart, seconds)) followed.push_back(slot.others.at(herd).get());
  HerdGuides guides(cast, {}, std::move(followed), seconds - apart, seconds, coarse_step);
  std::vector<HerdGuide> before;
  std::vector<HerdGuide> now;
  guides.at(seconds - apart, before);
  guides.at(seconds, now);
  std::vector<HerdAnimal> animals(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    HerdAnimal& animal = animals[i];
    const Place move = now[i].at - before[i].at;
    animal.place = now[i].at;
    animal.speed = float(std::min(length(move) / apart, cast.gallop_speed));
    animal.heading = heading_of(animal.speed > 0.2F ? unit_of(move) : now[i].facing);
    // At the pace of a walk on flat ground: from afar nobody sees a foot slip.
    const double strides =
        seconds * cast.walk_speed / stride_length(hip_height(cast.shoulder), cast.walk_speed) + cast.members[i].hop_phase;
    animal.cycles = float(strides - std::floor(strides));
    set_pose(now[i], cast.members[i], animal);
  }
  return animals;
}

namespace {

/// States of a herd in two runs that fade into each other.
struct RunStates {
  std::vector<BoidState> older_at_checkpoint;
  std::vector<BoidState> newer_at_checkpoint;
  std::vector<BoidState> older;
  std::vector<BoidState> newer;
};

/// Members between two runs, relative to the newer one's origin; `cycles`: of their strides only the fraction.
std::vector<BoidState> faded(const RunStates& runs, Place shift, double share, std::vector<float>& cycles) {
  const auto mixed = [share](double a, double b) { return a + (b - a) * share; };
  std::vector<BoidState> states = runs.newer;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BoidState& a = runs.older[i];
    const BoidState& older = runs.older_at_checkpoint[i];
    BoidState& b = states[i];
    b.x = float(mixed(double(a.x) + shift.x, double(b.x)));
    b.y = float(mixed(double(a.y) + shift.y, double(b.y)));
    // The way around that was the shorter one when the newer run began.
    const double full = 2 * std::numbers::pi;
    const double turns = std::round((double(older.angle) - double(runs.newer_at_checkpoint[i].angle)) / full);
    b.angle = float(mixed(double(a.angle), double(b.angle) + full * turns));
    b.speed = float(mixed(double(a.speed), double(b.speed)));
    // Both count strides from their own beginning: whole strides are added so that legs need hardly be moved to agree.
    const double whole = std::round(double(older.cycles));
    const double strides = mixed(double(a.cycles), double(b.cycles) + whole);
    cycles.push_back(float(strides - std::floor(strides)));
  }
  return states;
}

}  // namespace

std::vector<HerdAnimal> HerdSimulation::simulated(Slot& slot, double seconds) {
  const int checkpoint = checkpoint_of(seconds);
  slot.checkpoint = checkpoint;
  const double since = seconds - checkpoint * checkpoint_seconds;
  BoidRun& older = run(slot, checkpoint - 1);
  BoidRun& newer = run(slot, checkpoint);
  RunStates runs;
  older.at(checkpoint_seconds, runs.older_at_checkpoint);
  newer.at(0, runs.newer_at_checkpoint);
  older.at(checkpoint_seconds + since, runs.older);
  newer.at(since, runs.newer);
  std::vector<float> cycles;
  std::vector<BoidState> states = faded(runs, older.origin() - newer.origin(), smooth_step(0, checkpoint_seconds, since), cycles);
  // Members of a mixture may come nearer to each other than those of either run.
  push_apart(*slot.cast, newer.origin(), states, 10);
  std::vector<HerdGuide> guides;
  newer.guides().at(checkpoint * checkpoint_seconds + since, guides);
  std::vector<HerdAnimal> animals(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    HerdAnimal& animal = animals[i];
    const Place at = newer.origin() + Place{double(states[i].x), double(states[i].y)};
    animal.place = slot.cast->nearest_passable(guides[i].at, at);
    animal.heading = heading_of({std::sin(double(states[i].angle)), std::cos(double(states[i].angle))});
    animal.speed = states[i].speed;
    animal.cycles = cycles[i];
    set_pose(guides[i], slot.cast->members[i], animal);
  }
  return animals;
}

std::vector<HerdAnimal> HerdSimulation::placed(const HerdRequest& herd, double seconds) {
  Slot& slot = *slots_[std::size_t(herd.plan)];
  if (slot.cast->members.empty() || slot.cast->stops.empty()) return {};
  const float share = std::clamp(herd.boids, 0.0F, 1.0F);
  if (share <= 0) return by_formula(slot, seconds);
  std::vector<HerdAnimal> animals = simulated(slot, seconds);
  if (share >= 1) return animals;
  const std::vector<HerdAnimal> formula = by_formula(slot, seconds);
  for (std::size_t m = 0; m < formula.size(); ++m) {
    HerdAnimal& animal = animals[m];
    animal.place = formula[m].place + (animal.place - formula[m].place) * double(share);
    const double a = double(formula[m].heading);
    const double b = double(animal.heading);
    animal.heading = heading_of(
        unit_of(Place{std::sin(a), std::cos(a)} * double(1 - share) + Place{std::sin(b), std::cos(b)} * double(share)));
  }
  return animals;
}

/// The requests and all herds that may stand in the way of one of them, by rising plan.
std::vector<HerdRequest> HerdSimulation::with_neighbours(std::span<const HerdRequest> herds, double seconds) const {
  const std::vector<DailyPlan>& plans = *world_->plans;
  std::vector<HerdRequest> all(herds.begin(), herds.end());
  std::vector<float> share(plans.size(), -1);
  std::vector<Place> places;
  std::vector<double> reaches;
  for (const DailyPlan& plan : plans) {
    places.push_back(world_->place_of(world_->state(plan, seconds).at));
    reaches.push_back(herd_reach(*world_, plan));
  }
  for (const HerdRequest& herd : herds) {
    const auto h = std::size_t(herd.plan);
    for (std::size_t p = 0; p < plans.size(); ++p) {
      const double reach = reaches[p] + reaches[h] + settling_reach;
      const Place gap = places[p] - places[h];
      if (dot(gap, gap) < reach * reach) share[p] = std::max(share[p], herd.boids);
    }
  }
  for (const HerdRequest& herd : herds) share[std::size_t(herd.plan)] = -1;
  for (std::size_t p = 0; p < plans.size(); ++p) {
    if (share[p] >= 0) all.push_back({int(p), share[p]});
  }
  std::sort(all.begin(), all.end(), [](const HerdRequest& a, const HerdRequest& b) { return a.plan < b.plan; });
  return all;
}

/// Moves all animals apart that stand in each other or in trunks.
void HerdSimulation::settle_herds(std::span<const HerdRequest> herds, std::vector<std::vector<HerdAnimal>>& animals) const {
  std::vector<HerdBody> bodies;
  for (std::size_t i = 0; i < herds.size(); ++i) {
    const HerdCast& cast = *slots_[std::size_t(herds[i].plan)]->cast;
    for (std::size_t m = 0; m < animals[i].size(); ++m) {
      const HerdAnimal& animal = animals[i][m];
      bodies.push_back(herd_body(cast, double(animal.size), animal.place, double(animal.heading), double(animal.speed),
                                 (std::uint64_t(herds[i].plan) << 32U) + m));
    }
  }
  settle(*world_, bodies);
  std::size_t next = 0;
  for (std::vector<HerdAnimal>& herd : animals) {
    for (HerdAnimal& animal : herd) animal.place = bodies[next++].at;
  }
}

std::vector<std::vector<HerdAnimal>> HerdSimulation::animals(std::span<const HerdRequest> herds, double hour) {
  ++uses_;
  const double seconds = seconds_within_day(hour);
  const std::vector<HerdRequest> all = with_neighbours(herds, seconds);
  prepare(all, seconds);
  std::vector<std::vector<HerdAnimal>> animals(all.size());
  parallel_each(all.size(), [&](std::size_t i) { animals[i] = placed(all[i], seconds); });
  settle_herds(all, animals);
  std::vector<std::vector<HerdAnimal>> result;
  for (const HerdRequest& herd : herds) {
    const auto found =
        std::lower_bound(all.begin(), all.end(), herd.plan, [](const HerdRequest& a, int plan) { return a.plan < plan; });
    result.push_back(std::move(animals[std::size_t(found - all.begin())]));
  }
  forget_old();
  return result;
}

std::vector<HerdAnimal> HerdSimulation::animals(int plan, double hour) {
  const HerdRequest request{plan, 1};
  return std::move(animals(std::span(&request, 1), hour).front());
}

}  // namespace biotope
