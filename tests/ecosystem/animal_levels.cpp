#include <tbb/global_control.h>

#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/base/random.hpp"
#include "core/ecosystem/resource_nodes.hpp"
#include "core/ecosystem/surplus.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr double year = 365;

struct ThreeLevels {
  WebBuilder builder;
  int grass, berries, deer, goat, bear, wolf;
  ThreeLevels() {
    grass = builder.plant("grass", 0.1F);
    berries = builder.plant("berries", 0.02F, Stratum::shrub);
    deer = builder.animal("deer", 1, walker(5, 12), {{"fodder", {grass, berries}, 2}});
    goat = builder.animal("goat", 1, climber(4, 20), {{"fodder", {grass}, 1}});
    bear = builder.animal("bear", 2, climber(1, 2), {{"berries", {berries}, 2}, {"meat", {deer, goat}, 1}});
    wolf = builder.animal("wolf", 2, walker(5, 9), {{"meat", {deer, goat}, 3}});
  }
  static AnimalTraits climber(int smallest, int largest) {
    AnimalTraits traits = walker(smallest, largest);
    traits.max_slope = 1.5F;
    return traits;
  }
};

/// Two valleys parted by a cliff that goats and bears climb; water in both.
Landscape two_valleys() {
  Landscape land(60, 40);
  land.cliff_column(30, 1);
  land.brook_row(10);
  return land;
}

Scene solved_scene() {
  Scene scene(two_valleys(), ThreeLevels().builder.web);
  scene.levels.push_back(scene.solve(1));
  scene.levels.push_back(scene.solve(2));
  return scene;
}

double eaten_of(const AnimalLevel& level, int resource) { return total(level.eaten[std::size_t(resource)]); }

double integral(const Grid<float>& density, double cell_area) {
  double sum = 0;
  for (const float value : density.cells()) sum += double(value) * cell_area;
  return sum;
}

}  // namespace

TEST_CASE("predators live on the yearly growth of their prey, where prey is") {
  // Only the western valley has grass, so only it has deer, and wolves.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  const int deer = builder.animal("deer", 1, walker(10), {{"grass", {grass}}});
  builder.animal("wolf", 2, walker(1), {{"meat", {deer}, 1}});
  Landscape land(41, 20);
  land.cliff_column(20);
  land.brook_row(5);
  for (int y = 0; y < 20; ++y) land.hydrology.discharge(20, y) = 0;
  Scene scene(land, builder.web);
  Grid<Cover> cover(41, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) cover(x, y) = full_cover;
  }
  scene.cover(0, cover);
  scene.levels.push_back(scene.solve(1));
  const auto level = scene.solve(2);
  // 400 ha of grass feed 1090 deer; 20 % of them, 100 kg each, are 21,800 kg of meat; a wolf eats 365 kg.
  CHECK(total(scene.levels[0]->population[0]) == 1090);
  CHECK(level->population[0] == std::vector{59.0, 0.0});
  std::vector<ResourceNode> prey;
  for (const ResourceNode& node : level->graph->nodes) {
    if (node.kind == NodeKind::prey) prey.push_back(node);
  }
  REQUIRE(prey.size() == 1);
  CHECK(prey[0].group == deer);
  CHECK(prey[0].prey_region == 0);
  CHECK(prey[0].quantities[0].kilograms_per_year == Approx(1090 * 0.2 * 100));
  CHECK(!prey[0].built_from.empty());
  for (const int node : prey[0].built_from) CHECK(scene.levels[0]->graph->nodes[std::size_t(node)].centroid_x < 20);
}

TEST_CASE("a prey node stands for the share of its region's growth that lies in the piece") {
  // Deer roam the whole map; a wolf that fears slopes is parted by a ramp that deer walk.
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  const int deer = builder.animal("deer", 1, walker(10), {{"grass", {grass}}});
  AnimalTraits timid = walker(1);
  timid.max_slope = 0.2F;
  builder.animal("wolf", 2, timid, {{"meat", {deer}, 1}});
  Landscape land(40, 10);
  land.cliff_column(9, 0.3F);
  land.brook_row(5);
  Scene scene(land, builder.web);
  scene.levels.push_back(scene.solve(1));
  const auto level = scene.solve(2);
  const double growth = total(scene.levels[0]->population[0]) * 0.2 * 100;
  std::vector<double> quantity;
  for (const ResourceNode& node : level->graph->nodes) {
    if (node.kind == NodeKind::prey) quantity.push_back(node.quantities[0].kilograms_per_year);
  }
  REQUIRE(quantity.size() == 2);
  CHECK(quantity[0] == Approx(growth * 9 / 40));
  CHECK(quantity[1] == Approx(growth * 30 / 40));
}

TEST_CASE("an omnivore finds of the plants what the grazers left") {
  const Scene scene = solved_scene();
  const ThreeLevels web;
  const double grown = 59 * 40 * 10000 * 0.02 + 40 * 10000 * 0.02;
  double reachable = 0;
  double offered = 0;
  for (const ResourceNode& node : scene.levels[1]->graph->nodes) {
    for (const auto& quantity : node.quantities) {
      if (quantity.species != web.berries) continue;
      reachable += quantity.kilograms_per_year;
      offered += quantity.available;
    }
  }
  CHECK(reachable == Approx(grown));
  CHECK(eaten_of(*scene.levels[0], web.berries) > 0);
  CHECK(offered == Approx(reachable - eaten_of(*scene.levels[0], web.berries)));
  CHECK(eaten_of(*scene.levels[1], web.berries) <= offered);
}

TEST_CASE("eaten and surplus together are the growth, for plants and for prey") {
  const Scene scene = solved_scene();
  const ThreeLevels web;
  const double cell_area = scene.land.terrain.cell_area();
  for (const int plant : {web.grass, web.berries}) {
    const CoverMap& cover = *scene.plants[std::size_t(plant)];
    const SurplusTotal sum = surplus_total(scene.web, plant, &cover, cell_area, scene.levels);
    const Grid<float> surplus = plant_surplus(scene.web, plant, cover, scene.levels);
    CHECK(sum.eaten > 0);
    CHECK(sum.growth == Approx(60 * 40 * cell_area * double(scene.web.species[std::size_t(plant)].plant().growth)));
    CHECK(integral(surplus, cell_area) == Approx(sum.surplus()).epsilon(1e-5));
    const float growth = scene.web.species[std::size_t(plant)].plant().growth;
    CHECK(std::all_of(surplus.cells().begin(), surplus.cells().end(), [&](float s) { return s >= 0 && s <= growth; }));
  }
  for (const int prey : {web.deer, web.goat}) {
    const SurplusTotal sum = surplus_total(scene.web, prey, nullptr, cell_area, scene.levels);
    CHECK(sum.growth > 0);
    CHECK(sum.surplus() >= 0);
    CHECK(integral(animal_surplus(scene.web, prey, *scene.levels[0], scene.levels), cell_area / 1e6) ==
          Approx(sum.surplus()).epsilon(1e-5));
  }
  const double meat = (eaten_of(*scene.levels[1], web.deer) + eaten_of(*scene.levels[1], web.goat));
  CHECK(meat == Approx(year * (total(scene.levels[1]->population[0]) * 1 + total(scene.levels[1]->population[1]) * 3)));
  CHECK(meat > 0);
}

TEST_CASE("a fourth level eats what the third left of shared prey") {
  ThreeLevels three;
  AnimalTraits traits = walker(1);
  traits.growth_rate = 0.5F;
  const int tiger = three.builder.animal("tiger", 3, traits, {{"meat", {three.deer, three.wolf}, 2}});
  Scene scene(two_valleys(), three.builder.web);
  for (int level = 1; level <= 3; ++level) scene.levels.push_back(scene.solve(level));
  double deer_offered = 0;
  double deer_grown = 0;
  for (const ResourceNode& node : scene.levels[2]->graph->nodes) {
    if (node.kind != NodeKind::prey || node.group != three.deer) continue;
    deer_offered += node.quantities[0].available;
    deer_grown += node.quantities[0].kilograms_per_year;
  }
  CHECK(eaten_of(*scene.levels[1], three.deer) > 0);
  CHECK(deer_offered == Approx(deer_grown - eaten_of(*scene.levels[1], three.deer)));
  CHECK(scene.levels[2]->species == std::vector{tiger});
  CHECK(total(scene.levels[2]->population[0]) > 0);
  const SurplusTotal deer = surplus_total(scene.web, three.deer, nullptr, 1, scene.levels);
  CHECK(integral(animal_surplus(scene.web, three.deer, *scene.levels[0], scene.levels), scene.land.terrain.cell_area() / 1e6) ==
        Approx(deer.surplus()).epsilon(1e-5));
}

TEST_CASE("species with equal limits share one map of regions, also with the levels below") {
  const Scene scene = solved_scene();
  CHECK(scene.levels[0]->regions[0] != scene.levels[0]->regions[1]);
  CHECK(scene.levels[1]->regions[0] == scene.levels[0]->regions[1]);
  CHECK(scene.levels[1]->regions[1] == scene.levels[0]->regions[0]);
}

TEST_CASE("every herd is of its species' size and herds add up to the population") {
  const Scene scene = solved_scene();
  for (const auto& level : scene.levels) {
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      const AnimalTraits& animal = scene.web.species[std::size_t(level->species[i])].animal();
      std::vector<double> sum(level->population[i].size());
      for (const Herd& herd : level->herds) {
        if (herd.species != level->species[i]) continue;
        CHECK(herd.size >= animal.herd_min);
        CHECK(herd.size <= animal.herd_max);
        sum[std::size_t(herd.region)] += herd.size;
      }
      CHECK(sum == level->population[i]);
    }
  }
}

TEST_CASE("the result does not depend on the number of threads") {
  std::vector<std::vector<std::shared_ptr<const AnimalLevel>>> results;
  for (const std::size_t threads : {1U, 2U, 5U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Landscape land(150, 130, 50);
    for (std::size_t i = 0; i < land.derivatives.slope.size(); ++i)
      land.derivatives.slope[i] = float(random_unit({1, i / 5})) * 0.8F;
    land.brook_row(40);
    land.brook_row(90);
    Scene scene(land, ThreeLevels().builder.web);
    Grid<Cover> cover(150, 130);
    for (std::size_t i = 0; i < cover.size(); ++i) cover[i] = Cover(random_int(0, full_cover, {2, i / 23}));
    scene.cover(0, cover);
    scene.levels.push_back(scene.solve(1, {0.3, 0.7}));
    scene.levels.push_back(scene.solve(2));
    results.push_back(scene.levels);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(total(results[0][i]->population[1]) > 0);
    CHECK(same_level(*results[0][i], *results[1][i]));
    CHECK(same_level(*results[0][i], *results[2][i]));
  }
}

TEST_CASE("a computation that is asked to stop returns nothing") {
  const Scene scene(two_valleys(), ThreeLevels().builder.web);
  std::stop_source source;
  source.request_stop();
  TaskContext context;
  context.stop = source.get_token();
  const AnimalLevelInput input{scene.web, 1, scene.land.ground(), scene.plants, {}, {}, {}, {}, 1};
  CHECK(!compute_animal_level(input, context));
}
