#include <map>
#include <string>

#include "core/ecosystem/obstacle_rows.hpp"
#include "tests/sample/solved_valley.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Predators are within sight of their herd, m.
constexpr double sight = 500;

}  // namespace

TEST_CASE("every herd's way lies in its confinement region, every 36 s of the day and on every cell that it touches") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  REQUIRE(world->plans->size() > 50);
  for (const DailyPlan& plan : *world->plans) {
    const PlannedHerd herd(*world, plan);
    INFO(world->web->species[std::size_t(plan.species)].name << ", herd " << plan.herd);
    int outside = 0;
    for (double seconds = 0; seconds < day_seconds; seconds += 36)
      outside += !herd.home(world->cell_of(world->place_of(world->state(plan, seconds).at)));
    CHECK(outside == 0);
    for (std::size_t i = 0; i + 1 < plan.way.size(); ++i) {
      const PathPoint a = plan.way[i].at;
      const PathPoint b = plan.way[i + 1].at;
      const int pieces = 1 + int(20 * std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)));
      for (int k = 0; k <= pieces; ++k) {
        const float t = float(k) / float(pieces);
        outside += !herd.home(world->cell_of(world->place_of({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t})));
      }
    }
    CHECK(outside == 0);
  }
}

TEST_CASE(
    "predators are within sight of each herd as long as they follow it; most find herds, and follow them most of their hours") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  int followers = 0;
  int packs = 0;
  for (const DailyPlan& plan : *world->plans) {
    packs += plan.level > 1;
    if (plan.pursuits.empty()) continue;
    ++followers;
    double farthest = 0;
    int hunting = 0;
    int awake = 0;
    for (double seconds = 0; seconds < day_seconds; seconds += 36) {
      awake += active(plan, seconds);
      const HerdPursuit* pursuit = pursuit_at(plan, seconds / 3600);
      if (pursuit == nullptr) continue;
      ++hunting;
      const DailyPlan& prey = (*world->plans)[std::size_t(pursuit->plan)];
      const Place at = world->place_of(world->state(plan, seconds).at);
      farthest = std::max(farthest, length(world->place_of(world->state(prey, seconds).at) - at));
    }
    INFO(world->web->species[std::size_t(plan.species)].name << ", pack " << plan.herd);
    CHECK(farthest < sight);
    CHECK(2 * hunting > awake);
  }
  INFO(followers << " of " << packs);
  CHECK(3 * followers > 2 * packs);
}

TEST_CASE("individuals stand in their herd's region, where nothing keeps their species out") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  std::vector<HerdRequest> all;
  for (std::size_t p = 0; p < world->plans->size(); ++p) all.push_back({int(p), 1});
  std::map<int, ObstacleRows> obstacles;
  for (const DailyPlan& plan : *world->plans)
    obstacles.try_emplace(plan.species, world->ground, mobility_of(world->traits(plan)));
  HerdSimulation simulation(world);
  std::size_t animals = 0;
  for (const double hour : {4.63, 6.2, 8.41, 11.7, 16.9, 19.37, 21.8, 1.13}) {
    const auto herds = simulation.animals(all, hour);
    for (std::size_t p = 0; p < herds.size(); ++p) {
      const DailyPlan& plan = (*world->plans)[p];
      const PlannedHerd herd(*world, plan);
      int outside = 0;
      int blocked = 0;
      for (const HerdAnimal& animal : herds[p]) {
        const HerdWorld::Cell cell = world->cell_of(animal.place);
        outside += !herd.home(cell);
        blocked += obstacles.at(plan.species).at(cell.x, cell.y) != Obstacle::none;
        ++animals;
      }
      INFO(world->web->species[std::size_t(plan.species)].name << ", herd " << plan.herd << " at " << hour);
      CHECK(outside == 0);
      CHECK(blocked == 0);
    }
  }
  CHECK(animals > 1000);
}

TEST_CASE("a pack's individuals are near their herd when they hunt") {
  const auto maps = solved_valley();
  const auto world = world_of(*maps);
  HerdSimulation simulation(world);
  for (std::size_t p = 0; p < world->plans->size(); ++p) {
    const DailyPlan& plan = (*world->plans)[p];
    for (const double hour : {4.8, 19.9}) {
      const HerdPursuit* pursuit = pursuit_at(plan, hour);
      if (pursuit == nullptr) continue;
      const DailyPlan& prey = (*world->plans)[std::size_t(pursuit->plan)];
      const Place middle = world->place_of(world->state(prey, hour * 3600).at);
      for (const HerdAnimal& animal : simulation.animals(int(p), hour)) CHECK(length(animal.place - middle) < sight + 100);
    }
  }
}
