#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "core/pipeline/solve.hpp"
#include "core/pipeline/stale_stages.hpp"
#include "core/pipeline/worker.hpp"
#include "tests/pipeline/random_edits.hpp"
#include "tests/pipeline/snapshot_comparison.hpp"
#include "tests/pipeline/stopped_solve.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

using Maps = std::shared_ptr<const MapsSnapshot>;

Maps solved(const Document& document, SolveCache* cache = nullptr, const PublishPartial& publish = {}) {
  auto maps = solve(document, cache, {}, publish);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

Document start() {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  return *document;
}

/// A table mountain, so high that its shade falls on much of the map.
void raise_mountain(Document& document, float x, float y, float height = 1500) {
  Stroke stroke({LayerKind::ground, "height"}, &document.terrain->height);
  stroke.dab(document, {.mode = BrushMode::set, .radius = 10, .strength = 1, .hardness = 0.8F, .value = height}, x, y);
}

const Grid<float>& december_light(const MapsSnapshot& maps) {
  return *maps.environment->monthly[std::size_t(Resource::illumination)].layers[11];
}

/// The complete snapshots that a solve shows, the last being its answer.
std::vector<Maps> whole_answers(const Document& document, SolveCache& cache) {
  std::vector<Maps> whole;
  const Maps last = solved(document, &cache, [&](Maps shown) {
    if (shown->complete) whole.push_back(std::move(shown));
  });
  whole.push_back(last);
  return whole;
}

}  // namespace

TEST_CASE("Trails and plans follow a mountain with the far shade of before, and all of them again once shade is known") {
  Document document = start();
  SolveCache cache;
  const Maps before = solved(document, &cache);
  raise_mountain(document, 60, 30);
  const std::vector<Maps> whole = whole_answers(document, cache);
  REQUIRE(whole.size() == 2);
  const MapsSnapshot& first = *whole[0];
  CHECK_FALSE(first.shaded);
  CHECK(first.balanced);
  CHECK(first.trails);
  CHECK(first.plans);
  CHECK(stale_stages(&first, document).environment);
  CHECK(stale_stages(&first, document).level(0));
  CHECK_FALSE(stale_stages(&first, document).water);
  // On the mountain light is that of its own slopes; far from it that of before, until shade is known.
  CHECK(december_light(first)(60, 38) != december_light(*before)(60, 38));
  int shaded_later = 0;
  for (int y = 60; y < december_light(first).height(); ++y) {
    for (int x = 0; x < december_light(first).width(); ++x) {
      REQUIRE(december_light(first)(x, y) == december_light(*before)(x, y));
    }
  }
  for (std::size_t i = 0; i < december_light(first).size(); ++i) {
    if (december_light(*whole[1])[i] < december_light(first)[i]) ++shaded_later;
  }
  CHECK(shaded_later > 100);
  CHECK(whole[1]->exact());
  CHECK_FALSE(stale_stages(whole[1].get(), document).any());
  require_same(*whole[1], *solved(document));
}

TEST_CASE("A hillock throws no shade that has to wait") {
  Document document = start();
  SolveCache cache;
  (void)solved(document, &cache);
  const float ground = document.terrain->height(60, 60);
  raise_mountain(document, 60, 60, ground + 0.5F);
  const std::vector<Maps> whole = whole_answers(document, cache);
  REQUIRE(whole.size() == 1);
  CHECK(whole[0]->exact());
  require_same(*whole[0], *solved(document));
}

TEST_CASE("A run that is stopped while shade waits owes it to the next one") {
  Document document = start();
  SolveCache cache;
  (void)solved(document, &cache);
  for (int i = 0; i < 3; ++i) {
    raise_mountain(document, float(40 + 30 * i), 40);
    std::stop_source source;
    TaskContext context;
    context.stop = source.get_token();
    bool shown = false;
    const auto stop = [&](const Maps& maps) {
      if (!maps->complete) return;
      shown = !maps->shaded;
      source.request_stop();
    };
    CHECK_FALSE(solve(document, &cache, context, stop));
    CHECK(shown);
  }
  // A dab that has nothing to do with the ground still owes the shade.
  const Grid<float> open(document.terrain->height.width(), document.terrain->height.height(), 5.0F);
  Stroke stroke({LayerKind::passage, "all"}, &open);
  stroke.dab(document, {.mode = BrushMode::set, .radius = 6, .strength = 1, .value = 1}, 30, 90);
  const std::vector<Maps> whole = whole_answers(document, cache);
  REQUIRE(whole.size() == 2);
  CHECK_FALSE(whole[0]->exact());
  require_same(*whole[1], *solved(document));
  require_same(*solved(document, &cache), *solved(document));
}

TEST_CASE("A worker that raises mountains ends with all of their shade") {
  Document document = start();
  Worker worker;
  worker.post(document);
  worker.wait_idle();
  for (int i = 0; i < 5; ++i) {
    raise_mountain(document, float(30 + 20 * i), float(40 + 10 * (i % 3)));
    worker.post(document);
    std::this_thread::sleep_for(std::chrono::milliseconds(40 * (i % 3)));
  }
  worker.wait_idle();
  REQUIRE(worker.latest_complete());
  CHECK(worker.latest_complete()->exact());
  require_same(*worker.latest_complete(), *solved(document));
}

TEST_CASE("Incremental equals from scratch among mountains, with stops anywhere and partial answers") {
  Document document = start();
  SolveCache cache;
  Maps maps = solved(document, &cache);
  for (std::uint64_t step = 0; step < 14; ++step) {
    const auto x = float(random_int(0, 159, {step, 192}));
    const auto y = float(random_int(0, 127, {step, 193}));
    if (random_int(0, 2, {step, 194}) > 0) {
      raise_mountain(document, x, y, float(random_int(0, 1500, {step, 195})));
    } else {
      random_edit(document, *maps, step);
    }
    INFO("step " << step);
    if (random_int(0, 2, {step, 196}) == 0) {
      solve_until(document, cache, random_int(1, 24, {step, 197}));
    } else {
      maps = solved(document, &cache, [](const Maps&) {});
      require_same(*maps, *solved(document));
    }
  }
  require_same(*solved(document, &cache, [](const Maps&) {}), *solved(document));
}
