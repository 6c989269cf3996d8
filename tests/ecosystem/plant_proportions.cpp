#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_priority.hpp"
#include "core/ecosystem/plant_share_choice.hpp"
#include "tests/ecosystem/plant_competition_reference.hpp"
#include "tests/ecosystem/plant_scene.hpp"

using namespace biotope;
using plant_scene::constant;
using plant_scene::easy_plant;
using plant_scene::Scene;
using plant_scene::Year;

namespace {

std::vector<CoverMap> compete(const FoodWeb& web, const Scene& scene, const std::vector<double>& desired) {
  auto covers = compete_with_proportions(web, scene.environment(), desired);
  REQUIRE(covers.has_value());
  return *covers;
}

int sum(const CoverMap& map) {
  int total = 0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) total += int(map(x, y));
  }
  return total;
}

/// Years of one value, on quarters of an index: every sum is exact.
Scene quarter_scene(int width, int height, std::uint64_t seed) {
  Scene scene(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::uint64_t r = 0; r < monthly_resources; ++r) {
        Year year = constant(float(random_int(12, 36, {seed, std::uint64_t(x), std::uint64_t(y), r})) / 4);
        for (std::size_t m = 0; m < 3; ++m) year[m] = std::max(1.0F, year[m] - 2);
        scene.set(Resource(r), x, y, year);
      }
    }
  }
  return scene;
}

/// Paper algorithm 1 as it is written: all cells are looked at for every unit.
std::vector<std::vector<int>> plain_algorithm(const FoodWeb& web, const PlantEnvironment& environment, int width, int height,
                                              const std::vector<double>& desired) {
  std::vector<plant_reference::CellState> states(std::size_t(width * height));
  for (auto& state : states) state.cover.assign(desired.size(), 0);
  std::vector<double> given(desired.size(), 0);
  while (true) {
    int chosen = -1;
    std::size_t chosen_cell = 0;
    double least = 0;
    for (std::size_t i = 0; i < desired.size(); ++i) {
      if (desired[i] == 0) continue;
      const PlantTraits& plant = web.species[i].plant();
      long best = 0;
      std::size_t best_cell = 0;
      for (std::size_t cell = 0; cell < states.size(); ++cell) {
        const double fitness = plant_reference::fitness_left(plant, environment.cell(int(cell) % width, int(cell) / width),
                                                             states[cell], states[cell].cover[i]);
        // Cells are compared in steps of 1/20 of fitness.
        const long key = fitness > 0 ? std::max(1L, (std::max(1L, std::lround(fitness)) + 6) / 12) : 0;
        if (key > best) {
          best = key;
          best_cell = cell;
        }
      }
      if (best == 0) continue;
      const double unit = plant_reference::unit_of(plant);
      double total = unit;
      for (const double g : given) total += g;
      double error = 0;
      for (std::size_t j = 0; j < desired.size(); ++j) {
        const double share = (given[j] + (i == j ? unit : 0)) / total;
        error += (desired[j] - share) * (desired[j] - share);
      }
      if (chosen < 0 || error < least - 1e-12) {
        chosen = int(i);
        chosen_cell = best_cell;
        least = error;
      }
    }
    if (chosen < 0) break;
    const PlantTraits& plant = web.species[std::size_t(chosen)].plant();
    plant_reference::give_unit(plant, states[chosen_cell], std::size_t(chosen));
    given[std::size_t(chosen)] += plant_reference::unit_of(plant);
  }
  std::vector<std::vector<int>> covers;
  for (const auto& state : states) covers.push_back(state.cover);
  return covers;
}

}  // namespace

TEST_CASE("Shares of plants that grow everywhere are met") {
  const FoodWeb web = plant_scene::web_of({{"a", easy_plant()}, {"b", easy_plant()}, {"c", easy_plant()}});
  const auto covers = compete(web, Scene(4, 4), {0.5, 0.25, 0.25});
  const auto shares = achieved_shares(covers);
  CHECK(shares[0] == Approx(0.5).margin(0.01));
  CHECK(shares[1] == Approx(0.25).margin(0.01));
  CHECK(sum(covers[0]) + sum(covers[1]) + sum(covers[2]) == 16 * full_cover);
}

TEST_CASE("A plant that has no place drops out and the others go on; one that nobody wants stays away") {
  PlantTraits palm = easy_plant();
  palm.temperature = {8, 9};
  const FoodWeb web = plant_scene::web_of({{"palm", palm}, {"grass", easy_plant()}, {"unwanted", easy_plant()}});
  const auto covers = compete(web, Scene(3, 3), {0.5, 0.5, 0});
  CHECK(sum(covers[0]) == 0);
  CHECK(sum(covers[1]) == 9 * full_cover);
  CHECK(sum(covers[2]) == 0);
}

TEST_CASE("A unit goes to the fittest cell, the first in row order of equals") {
  // A unit takes 4 of 5 light, so each cell feeds one; two plants take turns, the first listed first.
  PlantTraits plant = easy_plant();
  plant.geology = {1, 0, 0.5F, 0, 0};
  plant.unit_cover = 0.1F;
  plant.light_consumption = 40;
  const FoodWeb web = plant_scene::web_of({{"a", plant}, {"b", plant}});
  Scene scene(4, 1);
  scene.geology()(0, 0) = Geology::marl;
  const auto covers = compete(web, scene, {0.5, 0.5});
  std::vector<int> first;
  std::vector<int> second;
  for (int x = 0; x < 4; ++x) {
    first.push_back(int(covers[0](x, 0)));
    second.push_back(int(covers[1](x, 0)));
  }
  CHECK(first == std::vector{0, 24, 0, 24});
  CHECK(second == std::vector{24, 0, 24, 0});
}

TEST_CASE("A plant that needs shade waits for others to make it") {
  PlantTraits tree = easy_plant(Stratum::tree);
  tree.light_consumption = 5;
  PlantTraits fern = easy_plant(Stratum::herb);
  fern.illumination = {1, 5};
  Scene scene(2, 2);
  scene.fill(Resource::illumination, constant(8));
  const auto covers = compete(plant_scene::web_of({{"fern", fern}, {"tree", tree}}), scene, {0.5, 0.5});
  CHECK(sum(covers[0]) > 0);
  CHECK(sum(covers[1]) == 4 * full_cover);
}

TEST_CASE("With proportions it is the paper's algorithm 1, unit by unit") {
  const int width = 5;
  const int height = 3;
  FoodWeb web = plant_scene::thesis_flora();
  for (Species& species : web.species) {
    auto& plant = std::get<PlantTraits>(species.traits);
    plant.texture = {1, 9};
    plant.geology = {1, 1, 1, 1, 1};
    if (plant.light_consumption < 1) plant.light_consumption = plant.water_consumption = 1.25F;
  }
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    std::vector<double> desired(18, 0);
    for (std::uint64_t i = 0; i < 16; ++i) desired[std::size_t(random_int(0, 17, {seed, i}))] += 1.0 / 16;
    if (seed >= 3) {
      for (std::size_t i = 0; i < 18; i += 2) std::get<PlantTraits>(web.species[i].traits).unit_cover = 0.1F;
    }
    const Scene scene = quarter_scene(width, height, seed);
    const auto covers = compete(web, scene, desired);
    const auto expected = plain_algorithm(web, scene.environment(), width, height, desired);
    int total = 0;
    for (int cell = 0; cell < width * height; ++cell) {
      for (std::size_t i = 0; i < 18; ++i) {
        CAPTURE(seed, cell, i);
        total += expected[std::size_t(cell)][i];
        if (int(covers[i](cell % width, cell / width)) != expected[std::size_t(cell)][i]) {
          REQUIRE(int(covers[i](cell % width, cell / width)) == expected[std::size_t(cell)][i]);
        }
      }
    }
    CHECK(total > width * height * full_cover / 4);
  }
}

TEST_CASE("A stopped competition with proportions gives nothing") {
  std::stop_source source;
  source.request_stop();
  TaskContext context;
  context.stop = source.get_token();
  const FoodWeb web = plant_scene::web_of({{"a", easy_plant()}});
  CHECK_FALSE(compete_with_proportions(web, Scene(2, 2).environment(), std::vector{1.0}, context).has_value());
}

TEST_CASE("Cells by priority: the highest key, the first in row order, through any changes") {
  for (const std::size_t cells : {std::size_t(1), std::size_t(64), std::size_t(65), std::size_t(5000)}) {
    CellPriority priority(cells);
    std::vector<std::uint8_t> keys(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      keys[i] = std::uint8_t(random_int(0, 5, {cells, i}));
      priority.put(i, keys[i]);
    }
    priority.index_all();
    for (std::uint64_t step = 0; step < 3000; ++step) {
      const auto cell = std::size_t(random_int(0, int(cells) - 1, {cells, step, 1}));
      // Keys sink over time with some rises, so that maxima change on all floors.
      keys[cell] = std::uint8_t(random_int(0, step % 100 == 0 ? 240 : 5, {cells, step, 2}));
      priority.set(cell, keys[cell]);
      const auto highest = std::max_element(keys.begin(), keys.end());
      REQUIRE(priority.best() == *highest);
      if (*highest > 0) REQUIRE(priority.first_best() == std::size_t(highest - keys.begin()));
    }
  }
}
