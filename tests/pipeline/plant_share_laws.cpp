#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "core/ecosystem/plant_share_schedule.hpp"
#include "core/pipeline/solve.hpp"
#include "core/pipeline/stale_stages.hpp"
#include "core/pipeline/worker.hpp"
#include "core/species/desired_shares.hpp"
#include "tests/pipeline/random_edits.hpp"
#include "tests/pipeline/snapshot_comparison.hpp"
#include "tests/pipeline/stopped_solve.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

using Maps = std::shared_ptr<const MapsSnapshot>;

const LayerId ground_layer{LayerKind::ground, "height"};
const LayerId moisture_layer{LayerKind::resource, "moisture"};

Maps solved(const Document& document, SolveCache* cache = nullptr, const PublishPartial& publish = {}) {
  auto maps = solve(document, cache, {}, publish);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

void ask_share(Document& document, std::size_t plant, double share) {
  const auto web = build_food_web(*document.species);
  if (!web) FAIL(web.error().message);
  const std::string name = web->species[std::size_t(web->levels[0][plant])].name;
  document.species = std::make_shared<const std::vector<Species>>(
      with_desired_share(*document.species, *web, 0, document.climate.name, name, share, {}));
}

/// The small valley, large enough to compete by a schedule, with shares for its plants.
Document start() {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) FAIL(document.error().message);
  REQUIRE(competes_by_schedule(document->terrain->height.width(), document->terrain->height.height()));
  ask_share(*document, 8, 0.3);
  return *document;
}

void dab(Document& document, const LayerId& layer, float x, float y, float radius, float value) {
  const Grid<float> computed(document.terrain->height.width(), document.terrain->height.height(), 5.0F);
  Stroke stroke(layer, layer == ground_layer ? &document.terrain->height : &computed);
  stroke.dab(document, {.mode = BrushMode::set, .radius = radius, .strength = 1, .hardness = 0.5F, .value = value}, x, y);
}

/// Another river or lake, or one less.
void draw_water(Document& document, float x, float y, std::uint64_t step) {
  DrawnWater& water = document.placements.water;
  const int kind = random_int(0, 2, {step, 80});
  if (kind == 0) {
    water.rivers.push_back({{{x, y}, {x + 15, y + 20}, {x + 40, y + 10}}, double(random_int(1, 9, {step, 81}))});
  } else if (kind == 1) {
    water.lakes.push_back({{{x - 12, y}, {x, y - 9}, {x + 14, y + 2}, {x, y + 11}}, 4});
  } else if (!water.rivers.empty()) {
    water.rivers.erase(water.rivers.begin());
  }
}

}  // namespace

TEST_CASE("A share that one plant asks for leaves the others alive, and is had where the land can give it") {
  Document document = start();
  const Maps maps = solved(document);
  CHECK(maps->plant_desired[8] == Approx(0.3).margin(0.001));
  int alive = 0;
  for (const double share : maps->plant_achieved) alive += share > 0 ? 1 : 0;
  CHECK(alive > 6);
  document.use_proportions[0] = false;
  const Maps freely = solved(document);
  CHECK(freely->plant_desired.empty());
  CHECK(maps->plant_achieved[8] > freely->plant_achieved[8]);
}

TEST_CASE("Plants with shares are shown near the brush first, by the schedule of before, and then exactly") {
  Document document = start();
  SolveCache cache;
  const Maps before = solved(document, &cache);
  dab(document, moisture_layer, 40, 100, 10, 8);
  std::vector<Maps> shown;
  const Maps after = solved(document, &cache, [&](Maps partial) { shown.push_back(std::move(partial)); });
  require_same(*after, *solved(document));
  const auto with_plants = [](const Maps& partial) { return !partial->cover.empty(); };
  REQUIRE(std::ranges::count_if(shown, with_plants) >= 2);
  const MapsSnapshot& near = **std::ranges::find_if(shown, with_plants);
  CHECK_FALSE(near.complete);
  REQUIRE(near.cover.size() == before->cover.size());
  bool changed = false;
  for (std::size_t i = 0; i < before->cover.size(); ++i) {
    for (int x = 0; x < 160; ++x) CHECK((*near.cover[i])(x, 20) == (*before->cover[i])(x, 20));
    changed |= (*near.cover[i])(40, 100) != (*before->cover[i])(40, 100);
  }
  CHECK(changed);
}

TEST_CASE("Trails and plans follow a dab by the schedule of before, and all of them again once shares are found anew") {
  Document document = start();
  SolveCache cache;
  (void)solved(document, &cache);
  dab(document, moisture_layer, 40, 100, 10, 8);
  std::vector<Maps> whole;
  const auto keep = [&](Maps shown) {
    if (shown->complete) whole.push_back(std::move(shown));
  };
  const Maps after = solved(document, &cache, keep);
  REQUIRE(whole.size() == 1);
  CHECK_FALSE(whole[0]->balanced);
  CHECK(whole[0]->trails);
  CHECK(whole[0]->plans);
  CHECK(stale_stages(whole[0].get(), document).level(0));
  CHECK_FALSE(stale_stages(whole[0].get(), document).environment);
  CHECK(after->balanced);
  CHECK_FALSE(stale_stages(after.get(), document).any());
  // What follows from it reads plants, and a dab that no plant reads leaves shares alone.
  whole.clear();
  dab(document, {LayerKind::passage, "all"}, 40, 100, 10, 1);
  CHECK(solved(document, &cache, keep)->balanced);
  CHECK(whole.empty());
}

TEST_CASE("A run that is stopped while shares are found anew keeps the schedule of before for the next dab") {
  Document document = start();
  SolveCache cache;
  const Maps first = solved(document, &cache);
  for (int i = 0; i < 3; ++i) {
    dab(document, moisture_layer, float(40 + 20 * i), 60, 8, 8);
    std::stop_source source;
    TaskContext context;
    context.stop = source.get_token();
    Maps shown;
    const auto stop = [&](Maps maps) {
      if (!maps->complete) return;
      shown = std::move(maps);
      source.request_stop();
    };
    CHECK_FALSE(solve(document, &cache, context, stop));
    REQUIRE(shown);
    for (std::size_t plant = 0; plant < first->cover.size(); ++plant) {
      for (int x = 0; x < 160; ++x) CHECK((*shown->cover[plant])(x, 120) == (*first->cover[plant])(x, 120));
    }
  }
  require_same(*solved(document, &cache), *solved(document));
}

TEST_CASE("A worker answers every dab with all that follows, and finds shares anew when the brush rests") {
  Document document = start();
  Worker worker;
  worker.post(document);
  worker.wait_idle();
  for (int i = 0; i < 6; ++i) {
    dab(document, moisture_layer, float(30 + 15 * i), 70, 8, 7);
    worker.post(document);
    std::this_thread::sleep_for(std::chrono::milliseconds(30 * (i % 3)));
  }
  worker.wait_idle();
  REQUIRE(worker.latest_complete());
  CHECK(worker.latest_complete()->balanced);
  require_same(*worker.latest_complete(), *solved(document));
}

TEST_CASE("Incremental equals from scratch where plants have shares, with stops anywhere and partial answers") {
  Document document = start();
  SolveCache cache;
  Maps maps = solved(document, &cache);
  std::vector<Document> states{document};
  for (std::uint64_t step = 0; step < 18; ++step) {
    const int kind = random_int(0, 7, {step, 90});
    const auto x = float(random_int(0, 159, {step, 91}));
    const auto y = float(random_int(0, 127, {step, 92}));
    if (kind == 0) ask_share(document, std::size_t(random_int(0, 17, {step, 93})), 0.1 * random_int(0, 9, {step, 94}));
    if (kind == 1) document = states[std::size_t(random_int(0, int(states.size()) - 1, {step, 95}))];
    if (kind == 2) dab(document, ground_layer, x, y, 9, float(random_int(90, 200, {step, 96})));
    if (kind == 3) dab(document, moisture_layer, x, y, 12, float(random_int(1, 9, {step, 97})));
    if (kind == 4) draw_water(document, x, y, step);
    if (kind > 4) random_edit(document, *maps, step);
    states.push_back(document);
    INFO("step " << step << ", kind " << kind);
    if (random_int(0, 2, {step, 98}) == 0) {
      solve_until(document, cache, random_int(1, 24, {step, 99}));
    } else {
      maps = solved(document, &cache, [](const Maps&) {});
      require_same(*maps, *solved(document));
    }
  }
  require_same(*solved(document, &cache, [](const Maps&) {}), *solved(document));
}
