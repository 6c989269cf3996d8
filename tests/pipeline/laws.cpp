#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <numeric>

#include "core/pipeline/solve.hpp"
#include "tests/pipeline/random_edits.hpp"
#include "tests/pipeline/snapshot_comparison.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

Document start() {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  return *document;
}

std::shared_ptr<const MapsSnapshot> solved(const Document& document, SolveCache* cache = nullptr) {
  auto maps = solve(document, cache);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

}  // namespace

TEST_CASE("A solve gives every map, level, trail and plan") {
  const auto maps = solved(start());
  CHECK(maps->complete);
  CHECK(maps->cover.size() == maps->web->levels.front().size());
  CHECK(maps->animals.size() == maps->web->levels.size() - 1);
  CHECK(maps->graph->levels.size() == maps->web->levels.size());
  CHECK_FALSE(maps->plans->empty());
  CHECK(maps->trails->total_length() > 0);
}

TEST_CASE("Incremental equals from scratch, to the bit, over random edits and undo") {
  Document document = start();
  SolveCache cache;
  auto maps = solved(document, &cache);
  std::vector<Document> states{document};
  for (std::uint64_t number = 0; number < 8; ++number) {
    random_edit(document, *maps, number);
    if (number == 3) document = states[1];
    if (number == 5) document.use_proportions[1] = false;
    states.push_back(document);
    maps = solved(document, &cache);
    INFO("edit " << number);
    require_same(*maps, *solved(document));
  }
}

TEST_CASE("The same to the bit for one thread and for two") {
  Document document = start();
  random_edit(document, *solved(document), 77);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return solved(document);
  };
  require_same(*run(1), *run(2));
}

TEST_CASE("Painting one plant recomputes no plant and touches only the tiles under the brush") {
  Document document = start();
  SolveCache cache;
  const auto before = solved(document, &cache);
  const auto& web = *before->web;
  const LayerId layer{LayerKind::plant_density, web.species[std::size_t(web.levels[0][0])].name};
  const Grid<float> computed = [&] {
    Grid<float> grid(160, 128);
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 160; ++x) grid(x, y) = cover_fraction((*before->computed_cover[0])(x, y));
    }
    return grid;
  }();
  Stroke stroke(layer, &computed);
  stroke.dab(document, {.mode = BrushMode::set, .radius = 8, .strength = 1, .hardness = 1, .value = 1}, 20, 20);
  const auto after = solved(document, &cache);
  for (std::size_t i = 0; i < after->computed_cover.size(); ++i) CHECK(after->computed_cover[i] == before->computed_cover[i]);
  for (std::size_t i = 1; i < after->cover.size(); ++i) CHECK(after->cover[i] == before->cover[i]);
  for (std::size_t t = 1; t < after->cover[0]->tile_count(); ++t) {
    CHECK(after->cover[0]->tile(t) == before->cover[0]->tile(t));
  }
  CHECK((*after->cover[0])(20, 20) == full_cover);
  CHECK(after->hydrology == before->hydrology);
  CHECK(after->environment == before->environment);
}

TEST_CASE("Painting an animal never competes its own level again, but feeds back below and above") {
  Document document = start();
  SolveCache cache;
  const auto before = solved(document, &cache);
  const AnimalLevel& level = *before->animals[0];
  const auto most = std::max_element(level.population.begin(), level.population.end(), [](const auto& a, const auto& b) {
    return std::accumulate(a.begin(), a.end(), 0.0) < std::accumulate(b.begin(), b.end(), 0.0);
  });
  const auto s = std::size_t(most - level.population.begin());
  const LayerId layer{LayerKind::animal_density, before->web->species[std::size_t(level.species[s])].name};
  const Grid<float> computed(160, 128, 100.0F);
  Stroke stroke(layer, &computed);
  stroke.dab(document, {.mode = BrushMode::set, .radius = 300, .strength = 1, .hardness = 1, .value = 0}, 80, 64);
  const auto after = solved(document, &cache);
  CHECK(after->animals[0]->computed_population == level.computed_population);
  double left = 0;
  for (const double individuals : after->animals[0]->population[s]) left += individuals;
  CHECK(left == Approx(0).margin(1e-3));
  double eaten_before = 0;
  double eaten_after = 0;
  for (const auto& pieces : level.eaten) eaten_before += std::accumulate(pieces.begin(), pieces.end(), 0.0);
  for (const auto& pieces : after->animals[0]->eaten) eaten_after += std::accumulate(pieces.begin(), pieces.end(), 0.0);
  CHECK(eaten_after < eaten_before);
}

TEST_CASE("Painted animals draw their herds to where the paint is") {
  Document document = start();
  const auto before = solved(document);
  const AnimalLevel& level = *before->animals[0];
  const auto most = std::max_element(level.population.begin(), level.population.end(), [](const auto& a, const auto& b) {
    return std::accumulate(a.begin(), a.end(), 0.0) < std::accumulate(b.begin(), b.end(), 0.0);
  });
  const auto s = std::size_t(most - level.population.begin());
  const LayerId layer{LayerKind::animal_density, before->web->species[std::size_t(level.species[s])].name};
  const Grid<float> computed(160, 128, 100.0F);
  Stroke stroke(layer, &computed);
  stroke.dab(document, {.mode = BrushMode::set, .radius = 20, .strength = 1, .hardness = 1, .value = 2000}, 100, 90);
  const auto after = solved(document);
  const auto share_near = [&](const MapsSnapshot& maps) {
    double near = 0;
    double all = 0;
    for (const auto& region : maps.movement[0].travel->presence[s]) {
      for (const auto& [node, probability] : region) {
        const ResourceNode& at = maps.animals[0]->graph->nodes[std::size_t(node)];
        all += double(probability);
        near += std::hypot(at.x - 100, at.y - 90) < 25 ? double(probability) : 0;
      }
    }
    return near / all;
  };
  CHECK(share_near(*after) > 1.5 * share_near(*before));
}

TEST_CASE("A stopped solve says so and what it finished is used by the next one") {
  const Document document = start();
  SolveCache cache;
  std::stop_source source;
  TaskContext context;
  context.stop = source.get_token();
  context.progress = [&](std::string_view stage, double) {
    if (stage == "animals") source.request_stop();
  };
  const auto stopped = solve(document, &cache, context);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().message == stopped_message);
  require_same(*solved(document, &cache), *solved(document));
}

TEST_CASE("Nothing to compute on is a message, not a crash") {
  Document document = start();
  document.species = std::make_shared<const std::vector<Species>>();
  CHECK_FALSE(solve(document));
  document.terrain = nullptr;
  CHECK_FALSE(solve(document));
}
