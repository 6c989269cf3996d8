#include "core/movement/herd_simulation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// Predators farther than this from a herd's place go unnoticed in a run, m: their rush and both herds' members reach no farther.
constexpr double noticed_distance = 450;
/// Herds whose casts are kept beyond those of the last call.
constexpr std::size_t most_casts = 400;
/// Seconds between the samples of a formula's track.
constexpr double coarse_step = 10;

float heading_of(Place direction) {
  const double angle = std::atan2(direction.x, direction.y);
  return float(angle < 0 ? angle + 6.283185307179586 : angle);
}

/// A checkpoint's number within the day: what follows from it must not depend on which day it is counted from.
int within_a_day(int checkpoint) { return (checkpoint % checkpoints_per_day + checkpoints_per_day) % checkpoints_per_day; }

int checkpoint_of(double seconds) { return int(std::floor(seconds / checkpoint_seconds)); }

double within_day(double hour) {
  const double seconds = std::fmod(hour * 3600, day_seconds);
  return seconds < 0 ? seconds + day_seconds : seconds;
}

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

struct HerdSimulation::Slot {
  std::shared_ptr<const HerdCast> cast;
  /// Casts of predators and of the followed herd that runs may need; filled before work is shared out.
  std::map<int, std::shared_ptr<const HerdCast>> others;
  std::map<int, std::unique_ptr<BoidRun>> runs;
  std::uint64_t used = 0;
  /// Of the last call.
  int checkpoint = 0;
};

HerdSimulation::HerdSimulation(std::shared_ptr<const HerdWorld> world)
    : world_(std::move(world)), predators_(predators_of_plans(*world_)), slots_(world_->plans->size()) {}
HerdSimulation::~HerdSimulation() = default;
HerdSimulation::HerdSimulation(HerdSimulation&&) noexcept = default;
HerdSimulation& HerdSimulation::operator=(HerdSimulation&&) noexcept = default;

std::shared_ptr<const HerdCast> HerdSimulation::cast(int plan) {
  std::unique_ptr<Slot>& slot = slots_[std::size_t(plan)];
  if (!slot) slot = std::make_unique<Slot>();
  slot->used = uses_;
  if (!slot->cast) slot->cast = std::make_shared<const HerdCast>(cast_herd(world_, plan, predators_[std::size_t(plan)]));
  return slot->cast;
}

std::vector<int> HerdSimulation::predators_near(int plan, double from, double until) const {
  const auto place = [&](int number, double seconds) {
    const double in_day = within_day(seconds / 3600);
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
        const double start = within_a_day(checkpoint) * checkpoint_seconds;
        const std::vector<int> near = predators_near(plan, start, start + run_seconds);
        others[i].insert(others[i].end(), near.begin(), near.end());
      }
    }
    const int followed = (*world_->plans)[std::size_t(plan)].followed;
    if (followed >= 0) others[i].push_back(followed);
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
  const int number = within_a_day(checkpoint);
  std::unique_ptr<BoidRun>& run = slot.runs[number];
  if (!run) {
    const double start = number * checkpoint_seconds;
    std::vector<std::shared_ptr<const HerdCast>> near;
    for (const int predator : predators_near(slot.cast->plan_number, start, start + run_seconds)) {
      const auto found = slot.others.find(predator);
      assert(found != slot.others.end());
      near.push_back(found->second);
    }
    const int followed = slot.cast->plan().followed;
    run = std::make_unique<BoidRun>(slot.cast, std::move(near), followed >= 0 ? slot.others.at(followed) : nullptr, number);
  }
  return *run;
}

std::vector<HerdAnimal> HerdSimulation::by_formula(const Slot& slot, double seconds) const {
  const HerdCast& cast = *slot.cast;
  const int followed = cast.plan().followed;
  constexpr double apart = 1;
  HerdGuides guides(cast, {}, followed >= 0 ? slot.others.at(followed).get() : nullptr, seconds - apart, seconds, coarse_step);
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

std::vector<HerdAnimal> HerdSimulation::simulated(Slot& slot, double seconds) {
  const int checkpoint = checkpoint_of(seconds);
  slot.checkpoint = checkpoint;
  const double since = seconds - checkpoint * checkpoint_seconds;
  BoidRun& older = run(slot, checkpoint - 1);
  BoidRun& newer = run(slot, checkpoint);
  std::vector<BoidState> at_checkpoint;
  std::vector<BoidState> began;
  std::vector<BoidState> from_older;
  std::vector<BoidState> states;
  older.at(checkpoint_seconds, at_checkpoint);
  newer.at(0, began);
  older.at(checkpoint_seconds + since, from_older);
  newer.at(since, states);
  const double share = smooth_step(0, checkpoint_seconds, since);
  const Place shift = older.origin() - newer.origin();
  const auto mixed = [share](double a, double b) { return a + (b - a) * share; };
  std::vector<float> cycles(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BoidState& a = from_older[i];
    BoidState& b = states[i];
    b.x = float(mixed(double(a.x) + shift.x, double(b.x)));
    b.y = float(mixed(double(a.y) + shift.y, double(b.y)));
    // The way around that was the shorter one when the newer run began.
    const double full = 2 * std::numbers::pi;
    const double turns = std::round((double(at_checkpoint[i].angle) - double(began[i].angle)) / full);
    b.angle = float(mixed(double(a.angle), double(b.angle) + full * turns));
    b.speed = float(mixed(double(a.speed), double(b.speed)));
    // Both count strides from their own beginning: whole strides are added so that legs need hardly be moved to agree.
    const double whole = std::round(double(at_checkpoint[i].cycles));
    const double strides = mixed(double(a.cycles), double(b.cycles) + whole);
    cycles[i] = float(strides - std::floor(strides));
  }
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

std::vector<std::vector<HerdAnimal>> HerdSimulation::animals(std::span<const HerdRequest> herds, double hour) {
  ++uses_;
  const double seconds = within_day(hour);
  prepare(herds, seconds);
  std::vector<std::vector<HerdAnimal>> result(herds.size());
  parallel_each(herds.size(), [&](std::size_t i) {
    Slot& slot = *slots_[std::size_t(herds[i].plan)];
    if (slot.cast->members.empty() || slot.cast->stops.empty()) return;
    const float share = std::clamp(herds[i].boids, 0.0F, 1.0F);
    if (share <= 0) {
      result[i] = by_formula(slot, seconds);
      return;
    }
    result[i] = simulated(slot, seconds);
    if (share >= 1) return;
    const std::vector<HerdAnimal> formula = by_formula(slot, seconds);
    for (std::size_t m = 0; m < formula.size(); ++m) {
      HerdAnimal& animal = result[i][m];
      animal.place = formula[m].place + (animal.place - formula[m].place) * double(share);
      const double a = double(formula[m].heading);
      const double b = double(animal.heading);
      animal.heading = heading_of(
          unit_of(Place{std::sin(a), std::cos(a)} * double(1 - share) + Place{std::sin(b), std::cos(b)} * double(share)));
    }
  });
  forget_old();
  return result;
}

std::vector<HerdAnimal> HerdSimulation::animals(int plan, double hour) {
  const HerdRequest request{plan, 1};
  return std::move(animals(std::span(&request, 1), hour).front());
}

std::size_t HerdSimulation::bytes() const {
  std::size_t sum = 0;
  for (const auto& slot : slots_) {
    if (!slot) continue;
    for (const auto& [number, run] : slot->runs) sum += run->bytes();
  }
  return sum;
}

void HerdSimulation::forget_old() {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i]) kept.push_back(i);
  }
  std::stable_sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) { return slots_[a]->used < slots_[b]->used; });
  std::size_t held = bytes();
  std::size_t casts = kept.size();
  for (const std::size_t i : kept) {
    // A picture may take several calls: those of the last ones count as in use.
    if (slots_[i]->used + 2 >= uses_) {
      // Of those in use only the runs of the moment stay.
      auto& runs = slots_[i]->runs;
      for (auto run = runs.begin(); held > most_bytes && run != runs.end();) {
        const bool of_the_moment =
            run->first == slots_[i]->checkpoint || (run->first + 1) % checkpoints_per_day == slots_[i]->checkpoint;
        if (!of_the_moment) held -= run->second->bytes();
        run = of_the_moment ? std::next(run) : runs.erase(run);
      }
      continue;
    }
    if (held <= most_bytes && casts <= most_casts) continue;
    for (const auto& [number, run] : slots_[i]->runs) held -= run->bytes();
    slots_[i].reset();
    --casts;
  }
}

}  // namespace biotope
