#pragma once

#include <catch2/catch.hpp>
#include <memory>

#include "core/exchange/open_input.hpp"
#include "core/movement/herd_simulation.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope::test {

/// The built-in valley, solved once for all tests.
inline std::shared_ptr<const MapsSnapshot> solved_valley() {
  static const std::shared_ptr<const MapsSnapshot> solved = [] {
    auto document = open_input("sample:valley", {}, {});
    REQUIRE(document);
    auto maps = solve(*document);
    REQUIRE(maps);
    return *maps;
  }();
  return solved;
}

/// What its animals move in, without anything that is finer than cells.
inline std::shared_ptr<const HerdWorld> world_of(const MapsSnapshot& maps) {
  auto world = std::make_shared<HerdWorld>();
  world->web = maps.web;
  world->ground = maps.ground();
  world->levels = maps.animals;
  world->graph = maps.graph;
  world->plans = maps.plans;
  world->seed = maps.document.seed;
  return world;
}

/// The herd of a plan, and the regions of its species.
struct PlannedHerd {
  Herd herd;
  const ConfinementRegions* regions = nullptr;

  PlannedHerd(const HerdWorld& world, const DailyPlan& plan) {
    const AnimalLevel& level = *world.levels[std::size_t(plan.level) - 1];
    herd = level.herds[std::size_t(plan.herd)];
    std::size_t species = 0;
    while (level.species[species] != plan.species) ++species;
    regions = level.regions[species].get();
  }
  [[nodiscard]] bool home(HerdWorld::Cell cell) const { return regions->label(cell.x, cell.y) == herd.region; }
};

/// Whether the species is active at a second of the day.
inline bool active(const DailyPlan& plan, double seconds) {
  for (const DailyPlan::Span& span : plan.active) {
    for (const double hour : {seconds / 3600, seconds / 3600 + 24}) {
      if (hour >= double(span.from) && hour < double(span.until)) return true;
    }
  }
  return false;
}

}  // namespace biotope::test
