#include "core/ecosystem/losses.hpp"

#include <catch2/catch.hpp>

#include <numeric>

#include "animal_scene.hpp"
#include "core/base/random.hpp"
#include "core/ecosystem/surplus.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

using Losses = std::vector<std::shared_ptr<const PaintLayer>>;
using Levels = std::vector<std::shared_ptr<const AnimalLevel>>;

constexpr int width = 130;
constexpr int height = 90;

/// Grass and bushes, deer that eat both, wolves that eat deer; a cliff between two valleys.
struct Chain {
  WebBuilder builder;
  Ground ground;
  std::vector<std::shared_ptr<const CoverMap>> plants;
  int grass = 0;
  int bushes = 0;
  int deer = 0;
  int wolf = 0;

  Chain() {
    grass = builder.plant("grass", 0.1F);
    bushes = builder.plant("bushes", 0.05F, Stratum::shrub);
    deer = builder.animal("deer", 1, walker(5, 12), {{"fodder", {grass, bushes}, 2}});
    wolf = builder.animal("wolf", 2, walker(1), {{"meat", {deer}, 1}});
    Landscape land(width, height, 50);
    land.cliff_column(60, 1);
    land.brook_row(40);
    ground = land.ground();
    for (const std::uint64_t seed : {1, 2}) {
      Grid<Cover> grid(width, height);
      for (std::size_t i = 0; i < grid.size(); ++i) grid[i] = Cover(random_int(0, full_cover, {seed, i / 29}));
      plants.push_back(std::make_shared<const CoverMap>(tiled(grid)));
    }
  }
  [[nodiscard]] Levels solve(const Losses& losses, const Levels& previous = {}) const {
    Levels levels;
    for (const int level : {1, 2}) {
      AnimalLevelInput input{builder.web, level, ground, plants, levels, {}, {}, losses, 1};
      if (!previous.empty()) input.previous = previous[std::size_t(level) - 1];
      auto result = compute_animal_level(input);
      REQUIRE(result);
      levels.push_back(std::make_shared<const AnimalLevel>(std::move(*result)));
    }
    return levels;
  }
};

std::shared_ptr<const PaintLayer> loss(const Rect& rect, float value, float coverage = 1) {
  return paint_rect(width, height, rect, value, coverage);
}
const Rect everywhere{0, 0, width, height};

bool same_chain(const Levels& a, const Levels& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same_level(*a[i], *b[i]) || a[i]->available != b[i]->available) return false;
  }
  return true;
}

double integral(const Grid<float>& map, double cell_area) {
  double sum = 0;
  for (const float value : map.cells()) sum += double(value) * cell_area;
  return sum;
}

}  // namespace

TEST_CASE("a loss of nothing changes nothing to the bit") {
  const Chain chain;
  const Levels without = chain.solve({});
  CHECK(same_chain(without, chain.solve({loss(everywhere, 0), loss(everywhere, 1, 0), loss(everywhere, 0), nullptr})));
  CHECK(same_chain(without, chain.solve({nullptr, nullptr, nullptr, loss(everywhere, 1)})));
  CHECK(total(without[1]->population[0]) > 0);
}

TEST_CASE("where all growth is lost there is nothing to eat") {
  const Chain chain;
  const Levels burnt = chain.solve({loss(everywhere, 1), loss(everywhere, 1)});
  CHECK(total(burnt[0]->available[0]) == 0);
  CHECK(total(burnt[0]->population[0]) == 0);
  CHECK(total(burnt[1]->population[0]) == 0);
  for (const ResourceNode& node : burnt[0]->graph->nodes) CHECK(node.kind == NodeKind::bank);
  CHECK(total(chain.solve({nullptr, nullptr, loss(everywhere, 1)})[1]->population[0]) == 0);
}

TEST_CASE("half the growth feeds half as much: in supplies, nodes and surplus") {
  const Chain chain;
  const Levels whole = chain.solve({});
  const Levels half = chain.solve({loss(everywhere, 0.5F), nullptr});
  for (std::size_t piece = 0; piece < whole[0]->available[0].size(); ++piece) {
    CHECK(half[0]->available[0][piece] == whole[0]->available[0][piece] / 2);
    CHECK(half[0]->available[1][piece] == whole[0]->available[1][piece]);
  }
  // Other patches may be worth a node, but those that both have halve their grass.
  int compared = 0;
  for (const ResourceNode& node : whole[0]->graph->nodes) {
    for (const ResourceNode& other : half[0]->graph->nodes) {
      if (node.kind != NodeKind::vegetation || node.group != int(Stratum::herb) || other.group != node.group) continue;
      if (other.x != node.x || other.y != node.y || other.quantities.empty()) continue;
      CHECK(other.quantities[0].kilograms_per_year == node.quantities[0].kilograms_per_year / 2);
      CHECK(other.quantities[0].available == other.quantities[0].kilograms_per_year);
      ++compared;
    }
  }
  CHECK(compared > 5);
  CHECK(total(half[0]->population[0]) < total(whole[0]->population[0]));
  CHECK(total(half[1]->population[0]) < total(whole[1]->population[0]));
}

TEST_CASE("a fire in one valley is felt there alone") {
  const Chain chain;
  const Levels whole = chain.solve({});
  const Levels fire = chain.solve({loss({0, 0, 60, height}, 0.9F), loss({0, 0, 60, height}, 0.9F)});
  REQUIRE(whole[0]->population[0].size() == 2);
  CHECK(fire[0]->population[0][0] < 0.2 * whole[0]->population[0][0]);
  CHECK(fire[0]->population[0][1] == whole[0]->population[0][1]);
}

TEST_CASE("a disease takes the mean of its share over an animal's region from the predators") {
  const Chain chain;
  const Levels whole = chain.solve({});
  const ConfinementRegions& regions = *whole[0]->regions[0];
  // A third of the first valley's columns, all lost.
  const auto sick = loss({0, 0, 20, height}, 1);
  const std::vector<double> mean = mean_losses(regions, sick.get());
  CHECK(mean[0] == Approx(20.0 / 60));
  CHECK(mean[1] == 0);
  const Levels ill = chain.solve({nullptr, nullptr, sick});
  CHECK(ill[0]->population == whole[0]->population);
  for (std::size_t i = 0; i < ill[1]->prey.size(); ++i) {
    const auto& own = ill[1]->prey[i];
    CHECK(own.available == Approx(whole[1]->prey[i].available * (1 - mean[std::size_t(own.region)])));
  }
}

TEST_CASE("growth without losses, less what is eaten, is the surplus, on the map and in sum") {
  const Chain chain;
  const double cell_area = 2500;
  Losses losses{loss({10, 5, 90, 60}, 0.7F, 0.9F), loss({50, 20, 120, 80}, 0.25F), loss({0, 0, 50, 50}, 0.8F)};
  const Levels levels = chain.solve(losses);
  for (const int plant : {chain.grass, chain.bushes}) {
    const CoverMap& cover = *chain.plants[std::size_t(plant)];
    const PaintLayer* own = losses[std::size_t(plant)].get();
    const SurplusTotal sum = surplus_total(chain.builder.web, plant, &cover, cell_area, levels, own);
    CHECK(sum.eaten > 0);
    CHECK(sum.growth < surplus_total(chain.builder.web, plant, &cover, cell_area, levels).growth);
    const Grid<float> map = plant_surplus(chain.builder.web, plant, cover, levels, own);
    CHECK(integral(map, cell_area) == Approx(sum.surplus()).epsilon(1e-4));
    CHECK(*std::min_element(map.cells().begin(), map.cells().end()) >= 0);
  }
  const PaintLayer* own = losses[std::size_t(chain.deer)].get();
  const SurplusTotal sum = surplus_total(chain.builder.web, chain.deer, nullptr, cell_area, levels, own);
  CHECK(sum.surplus() > 0);
  CHECK(integral(animal_surplus(chain.builder.web, chain.deer, *levels[0], levels, own), cell_area / 1e6) ==
        Approx(sum.surplus()).epsilon(1e-4));
}

TEST_CASE("levels computed after a change of losses are those from scratch") {
  const Chain chain;
  Losses losses(4);
  Levels levels = chain.solve(losses);
  for (std::uint64_t step = 0; step < 8; ++step) {
    const int x = random_int(0, 90, {step, 1});
    const int y = random_int(0, 60, {step, 2});
    losses[std::size_t(step % 4)] = step == 6 ? nullptr : loss({x, y, x + 40, y + 30}, float(random_unit({step, 3})));
    const Levels next = chain.solve(losses, levels);
    CHECK(same_chain(next, chain.solve(losses)));
    // Who eats none of it keeps its resources.
    if (step % 4 >= 2) CHECK(next[0]->graph == levels[0]->graph);
    levels = next;
  }
}
