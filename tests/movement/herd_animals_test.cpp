#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "core/movement/herd_simulation.hpp"
#include "tests/movement/herd_scene.hpp"

using namespace biotope;
using biotope::test::all_herds;
using biotope::test::meadow;
using biotope::test::same;

namespace {

/// Hours at which the herd stands at a stop of a kind, well into it.
std::vector<double> hours_at(const HerdWorld& world, const DailyPlan& plan, NodeKind kind) {
  std::vector<double> hours;
  for (const PlanStop& stop : plan.stops) {
    if (world.graph_of(plan).nodes[std::size_t(stop.node)].kind == kind && stop.leave - stop.arrive > 0.15F)
      hours.push_back(0.5 * double(stop.arrive + stop.leave));
  }
  return hours;
}

}  // namespace

TEST_CASE("The same hour shows the same animals to the bit, in whichever order hours are asked for, on any number of threads") {
  const auto world = meadow();
  const auto requests = all_herds(*world);
  const std::vector<double> hours{7.3, 7.31, 12.004, 7.29, 18.5, 7.3001, 0.0, 23.9999};
  std::vector<std::vector<std::vector<HerdAnimal>>> forward;
  {
    HerdSimulation simulation(world);
    for (const double hour : hours) forward.push_back(simulation.animals(requests, hour));
  }
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  HerdSimulation other(world);
  for (std::size_t h = hours.size(); h-- > 0;) {
    const auto again = other.animals(requests, hours[h] + (h % 2 == 0 ? 0 : 24));
    // A whole day later it is the same hour but for the last bits of its number.
    for (std::size_t r = 0; r < requests.size(); ++r) {
      REQUIRE(again[r].size() == std::size_t((*world->plans)[r].size));
      for (std::size_t m = 0; m < again[r].size(); ++m) {
        if (h % 2 == 0)
          REQUIRE(same(again[r][m], forward[h][r][m]));
        else
          REQUIRE(length(again[r][m].place - forward[h][r][m].place) < 1e-3);
      }
    }
  }
  // One herd alone is where it is among all.
  HerdSimulation alone(world);
  const auto herd = alone.animals(2, 7.3);
  for (std::size_t m = 0; m < herd.size(); ++m) REQUIRE(same(herd[m], forward[0][2][m]));
}

TEST_CASE(
    "No two members are closer than two fifths of a body length; all are on the map, on passable ground, in no water that is too "
    "deep") {
  const auto world = meadow();
  const auto requests = all_herds(*world);
  HerdSimulation simulation(world);
  std::size_t pairs = 0;
  std::size_t close = 0;
  for (double hour = 0.013; hour < 24; hour += 0.73) {
    const auto herds = simulation.animals(requests, hour);
    for (std::size_t r = 0; r < herds.size(); ++r) {
      const HerdCast cast = cast_herd(world, int(r), {});
      for (std::size_t i = 0; i < herds[r].size(); ++i) {
        const Place at = herds[r][i].place;
        REQUIRE(cast.passable(at));
        REQUIRE(world->depth_at(at) <= 0.6F);
        for (std::size_t j = 0; j < i; ++j) {
          ++pairs;
          close += length(at - herds[r][j].place) < 0.4 * cast.body_length;
        }
      }
    }
  }
  INFO(close << " of " << pairs << " pairs");
  CHECK(close == 0);
}

TEST_CASE("A herd's middle stays near its plan's place; predators at a rush excepted, who are between it and their prey") {
  const auto world = meadow();
  const auto requests = all_herds(*world);
  HerdSimulation simulation(world);
  for (double hour = 0.2; hour < 24; hour += 0.61) {
    const auto herds = simulation.animals(requests, hour);
    for (std::size_t r = 0; r < herds.size(); ++r) {
      const DailyPlan& plan = (*world->plans)[r];
      Place middle{};
      for (const HerdAnimal& animal : herds[r]) middle = middle + animal.place * (1.0 / double(herds[r].size()));
      const Place planned = world->place_of(world->state(plan, hour * 3600).at);
      // A long file is as long as its members; frightened herds move off by less than the fright distance; to drink a herd goes
      // to the edge of the water.
      const double to_water = world->state(plan, hour * 3600).activity == HerdActivity::drinking ? 120 : 0;
      const double stated = 25 + 0.35 * 2.0 * double(plan.size) + fright_distance + to_water;
      const HerdPursuit* pursuit = pursuit_at(plan, hour);
      if (pursuit == nullptr) {
        CHECK(length(middle - planned) < stated);
      } else {
        const Place prey = world->place_of(world->state((*world->plans)[std::size_t(pursuit->plan)], hour * 3600).at);
        CHECK(length(middle - prey) < std::max(length(planned - prey), 60.0) + stated);
      }
    }
  }
}

TEST_CASE("Nobody jumps: between two near moments, and over every checkpoint, a member moves no faster than it can run") {
  const auto world = meadow();
  HerdSimulation simulation(world);
  const HerdCast cast = cast_herd(world, 2, {});
  for (const double from : {6.9, 9.2, 16.4}) {
    auto before = simulation.animals(2, from);
    constexpr double seconds = 1;
    for (double since = seconds; since < 300; since += seconds) {
      const auto now = simulation.animals(2, from + since / 3600);
      for (std::size_t i = 0; i < now.size(); ++i) {
        REQUIRE(length(now[i].place - before[i].place) < (cast.gallop_speed + 1) * seconds);
        const double turned = std::abs(std::remainder(double(now[i].heading - before[i].heading), 6.283185307));
        REQUIRE(turned < 2.0);
      }
      before = now;
    }
  }
}

TEST_CASE("Feet follow the ground: a walking animal's strides are as long as the distance it walks") {
  const auto world = meadow();
  HerdSimulation simulation(world);
  const DailyPlan& plan = (*world->plans)[1];
  // The middle of the longest walk.
  double hour = 0;
  double longest = 0;
  for (std::size_t i = 0; i + 1 < plan.stops.size(); ++i) {
    const double walk = double(plan.stops[i + 1].arrive - plan.stops[i].leave);
    if (walk > longest) {
      longest = walk;
      hour = double(plan.stops[i].leave) + 0.5 * walk;
    }
  }
  REQUIRE(longest > 0.05);
  int walking = 0;
  auto before = simulation.animals(1, hour);
  for (int step = 1; step <= 60; ++step) {
    const auto now = simulation.animals(1, hour + step * 0.25 / 3600);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double moved = length(now[i].place - before[i].place);
      const double strides = std::remainder(double(now[i].cycles - before[i].cycles), 1.0);
      const double stride =
          stride_length(hip_height(1.2 * double(now[i].size)), std::max(0.05, 0.5 * double(now[i].speed + before[i].speed)));
      if (now[i].speed < 0.5F) continue;
      ++walking;
      CHECK(strides * stride == Approx(moved).margin(0.12));
    }
    before = now;
  }
  CHECK(walking > 300);
}

TEST_CASE("Herds drink at the water's edge with their heads toward it, graze with heads down, and many lie when they rest") {
  const auto world = meadow();
  HerdSimulation simulation(world);
  const DailyPlan& plan = (*world->plans)[1];
  const auto at_banks = hours_at(*world, plan, NodeKind::bank);
  REQUIRE(!at_banks.empty());
  int drinking = 0;
  for (const HerdAnimal& animal : simulation.animals(1, at_banks.front())) {
    const Place ahead{std::sin(double(animal.heading)), std::cos(double(animal.heading))};
    drinking += world->depth_at(animal.place + ahead * 3.0) > 0 && world->depth_at(animal.place) < 0.35F;
  }
  CHECK(drinking >= plan.size * 2 / 3);
  double down = 0;
  const auto at_pasture = hours_at(*world, plan, NodeKind::vegetation);
  REQUIRE(!at_pasture.empty());
  for (const HerdAnimal& animal : simulation.animals(1, at_pasture.front())) down += double(animal.head_down);
  CHECK(down > 0.4 * plan.size);
  double lying = 0;
  for (const HerdAnimal& animal : simulation.animals(2, 1.0)) lying += double(animal.lying);
  CHECK(lying > 0.4 * (*world->plans)[2].size);
}

TEST_CASE("A rushing pack drives its herd before it, and is never out of its sight") {
  const auto world = meadow();
  const auto& plans = *world->plans;
  const auto pack = std::find_if(plans.begin(), plans.end(), [](const DailyPlan& plan) { return !plan.pursuits.empty(); });
  REQUIRE(pack != plans.end());
  const int number = int(pack - plans.begin());
  const HerdCast cast = cast_herd(world, number, {});
  const HerdTrack track(cast, 0, day_seconds, 5);
  HerdSimulation simulation(world);
  int rushes = 0;
  double fastest_flight = 0;
  for (double seconds = 0; seconds < day_seconds && rushes < 3; seconds += 5) {
    if (rush_share(cast, track.at(seconds), seconds) < 0.98) continue;
    ++rushes;
    const HerdPursuit* pursuit = pursuit_at(*pack, seconds / 3600);
    REQUIRE(pursuit != nullptr);
    // A moment earlier the prey runs its fastest.
    for (double before = 0; before < 12; before += 2) {
      for (const HerdAnimal& prey : simulation.animals(pursuit->plan, (seconds - before) / 3600))
        fastest_flight = std::max(fastest_flight, double(prey.speed));
    }
    const auto wolves = simulation.animals(number, seconds / 3600);
    const auto herd = simulation.animals(pursuit->plan, seconds / 3600);
    double nearest = 1e9;
    int alarmed = 0;
    for (const HerdAnimal& prey : herd) {
      for (const HerdAnimal& wolf : wolves) nearest = std::min(nearest, length(prey.place - wolf.place));
      alarmed += prey.alarm > 0.5F;
    }
    CHECK(nearest < 120);
    CHECK(nearest > 1);
    CHECK(alarmed > 0);
    seconds += 1200;
  }
  CHECK(rushes > 0);
  CHECK(fastest_flight > 3.5);
  for (double hour = 0; hour < 24; hour += 1.3) {
    const HerdPursuit* pursuit = pursuit_at(*pack, hour);
    if (pursuit == nullptr) continue;
    const Place prey = world->place_of(world->state(plans[std::size_t(pursuit->plan)], hour * 3600).at);
    for (const HerdAnimal& wolf : simulation.animals(number, hour)) CHECK(length(wolf.place - prey) < 420);
  }
}

TEST_CASE("Memory of runs is bounded") {
  const auto world = meadow();
  const auto requests = all_herds(*world);
  HerdSimulation simulation(world);
  for (int i = 0; i < 40; ++i) {
    static_cast<void>(simulation.animals(requests, 24 * std::fmod(i * 0.618, 1.0)));
    REQUIRE(simulation.bytes() <= HerdSimulation::most_bytes);
  }
}
