#include <algorithm>
#include <catch2/catch.hpp>

#include "core/ecosystem/ford_discs.hpp"
#include "core/movement/herd_simulation.hpp"
#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

constexpr int width = 120;
constexpr int height = 60;
constexpr double cell_size = 5;
/// Columns of the river, and the row of its ford.
constexpr int west_bank = 57;
constexpr int east_bank = 62;
constexpr int ford_row = 30;

/// Meadows on both sides of a river that is too deep everywhere, with a ford that a person placed, and a herd that spends the
/// morning in the west and the afternoon in the east.
std::shared_ptr<const HerdWorld> river_with_a_ford(int size, bool ford) {
  MovementScene scene(width, height, cell_size);
  auto derivatives = std::make_shared<Derivatives>();
  derivatives->slope = derivatives->east = derivatives->north = Grid<float>(width, height, 0);
  scene.ground.derivatives = derivatives;
  Hydrology hydrology;
  hydrology.water_depth = Grid<float>(width, height);
  hydrology.discharge = Grid<float>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = west_bank; x < east_bank; ++x) hydrology.water_depth(x, y) = 1.2F;
  }
  scene.ground.hydrology = std::make_shared<const Hydrology>(std::move(hydrology));
  auto places = std::make_shared<Places>();
  if (ford) places->fords.push_back({{0.5F * float(west_bank + east_bank - 1), float(ford_row)}, 20});
  scene.ground.places = places;
  AnimalTraits traits;
  traits.mass_min = 80;
  traits.mass_max = 120;
  traits.speed = 1.4F;
  traits.max_slope = 0.8F;
  traits.wade_depth = 0.5F;
  traits.activity = Activity::diurnal;
  traits.water_visits = 0;
  traits.shape.body_length = 1.8F;
  traits.shape.shoulder_height = 1.1F;
  scene.blocked = blocked_cells(scene.ground, mobility_of(traits));
  const int deer = scene.animal("deer", 1, traits, {0});
  AnimalLevel level = scene.level(1, {MovementScene::node(NodeKind::vegetation, 30, 12, 40000, 1500),
                                      MovementScene::node(NodeKind::vegetation, 95, 50, 40000, 1500)});
  level.herds = {{deer, 0, size}};
  scene.add(std::move(level));
  PlanEdit edit;
  edit.species = "deer";
  edit.home = {30, 12};
  edit.stops = {{{30, 12}, 6, 12}, {{95, 50}, 12.2F, 20}};
  auto plans = compute_daily_plans(scene.web, scene.levels, scene.movement, scene.ground, 1, {}, nullptr, {{edit}});
  REQUIRE(plans);
  auto world = std::make_shared<HerdWorld>();
  world->web = std::make_shared<const FoodWeb>(scene.web);
  world->ground = scene.ground;
  world->levels = scene.levels;
  auto graph = std::make_shared<ResourceAccessGraph>();
  graph->levels.resize(1);
  graph->levels.push_back(*scene.levels.front()->graph);
  world->graph = graph;
  world->plans = std::make_shared<const std::vector<DailyPlan>>(std::move(*plans));
  world->seed = 3;
  return world;
}

bool in_ford(const HerdWorld& world, HerdWorld::Cell cell) {
  const auto discs = ford_discs(world.ground);
  return std::any_of(discs.begin(), discs.end(),
                     [&](const FordDisc& disc) { return std::hypot(cell.x - disc.x, cell.y - disc.y) <= disc.radius; });
}

}  // namespace

TEST_CASE("a herd crosses a deep river at the ford: all of it comes over, and nobody swims beside it") {
  const auto world = river_with_a_ford(GENERATE(1, 12, 45), true);
  const DailyPlan& plan = world->plans->front();
  REQUIRE(plan.unreachable_stops.empty());
  REQUIRE(plan.stops.size() == 2);
  HerdSimulation simulation(world);
  const double west = west_bank * cell_size;
  const double east = east_bank * cell_size;
  const double sets_out = double(plan.stops[0].leave);
  const double arrives = double(plan.stops[1].arrive);
  for (const HerdAnimal& animal : simulation.animals(0, sets_out - 0.3)) CHECK(animal.place.x < west);
  int wading = 0;
  for (double hour = sets_out - 0.1; hour < arrives + 0.3; hour += 4.0 / 3600) {
    for (const HerdAnimal& animal : simulation.animals(0, hour)) {
      if (world->depth_at(animal.place) <= 0.5F) continue;
      ++wading;
      REQUIRE(in_ford(*world, world->cell_of(animal.place)));
    }
  }
  CHECK(wading > 0);
  for (const HerdAnimal& animal : simulation.animals(0, arrives + 0.4)) CHECK(animal.place.x > east);
}

TEST_CASE("without a ford the other bank is out of a herd's reach") {
  const auto world = river_with_a_ford(12, false);
  const DailyPlan& plan = world->plans->front();
  CHECK(plan.unreachable_stops == std::vector<int>{1});
  HerdSimulation simulation(world);
  for (double hour = 0; hour < 24; hour += 1.7) {
    for (const HerdAnimal& animal : simulation.animals(0, hour)) CHECK(animal.place.x < west_bank * cell_size);
  }
}
