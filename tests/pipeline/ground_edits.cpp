#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

#include "core/pipeline/solve.hpp"
#include "core/pipeline/worker.hpp"
#include "tests/pipeline/edit_steps.hpp"
#include "tests/pipeline/snapshot_comparison.hpp"
#include "tests/pipeline/stopped_solve.hpp"

using namespace biotope;

namespace {

const LayerId ground_layer{LayerKind::ground, "height"};

Document start(int width = 260, int height = 200) {
  auto document = tiny_document(width, height);
  if (!document) FAIL(document.error().message);
  return *document;
}

using Maps = std::shared_ptr<const MapsSnapshot>;

Maps solved(const Document& document, SolveCache* cache = nullptr, const PublishPartial& publish = {}) {
  auto maps = solve(document, cache, {}, publish);
  if (!maps) FAIL(maps.error().message);
  return *maps;
}

void dab(Document& document, float x, float y, float radius, float height, BrushMode mode = BrushMode::set) {
  Stroke stroke(ground_layer, &document.terrain->height);
  stroke.dab(document, {.mode = mode, .radius = radius, .strength = 1, .hardness = 0.5F, .value = height}, x, y);
}

}  // namespace

TEST_CASE("A dab of ground is answered near it first, with the water of before, and then exactly") {
  Document document = start();
  SolveCache cache;
  const Maps before = solved(document, &cache);
  dab(document, 40, 150, 12, 190);
  std::vector<Maps> shown;
  const Maps after = solved(document, &cache, [&](Maps partial) { shown.push_back(std::move(partial)); });
  REQUIRE_FALSE(shown.empty());
  const MapsSnapshot& near = *shown.front();
  CHECK_FALSE(near.complete);
  CHECK(near.terrain().height(40, 150) == Approx(190));
  CHECK(near.derivatives->slope == after->derivatives->slope);
  CHECK(near.hydrology == before->hydrology);
  REQUIRE(near.cover.size() == before->cover.size());
  CHECK(*near.environment->map(Resource::temperature).layers[0] == *after->environment->map(Resource::temperature).layers[0]);
  const auto& light = near.environment->map(Resource::illumination);
  CHECK(light.layer(6)(40, 150) == after->environment->map(Resource::illumination).layer(6)(40, 150));
  CHECK_FALSE(light.layer(6)(30, 150) == before->environment->map(Resource::illumination).layer(6)(30, 150));
  // What was shown is not taken back by maps without plants, and nothing of it is left in the end.
  for (const Maps& partial : shown) CHECK(partial->cover.size() == before->cover.size());
  CHECK_FALSE(after->hydrology == before->hydrology);
  require_same(*after, *solved(document));
}

TEST_CASE("Maps that were shown do not change when the ground is painted on") {
  Document document = start();
  SolveCache cache;
  const Maps before = solved(document, &cache);
  std::vector<Maps> held{before};
  std::vector<Document> documents{document};
  for (int i = 0; i < 4; ++i) {
    dab(document, 60 + 40 * float(i), 90, 15, 150 + 10 * float(i));
    documents.push_back(document);
    held.push_back(solved(document, &cache, [](const Maps&) {}));
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    INFO("dab " << i);
    require_same(*held[i], *solved(documents[i]));
  }
}

TEST_CASE("Ground that is painted, undone, drawn on and painted again is answered as from scratch, with stops anywhere") {
  for (std::uint64_t session = 0; session < 3; ++session) {
    Document document = start();
    SolveCache cache;
    (void)solved(document, &cache);
    std::vector<Document> states{document};
    for (std::uint64_t step = 0; step < 9; ++step) {
      Chance chance(1000 * session + step);
      const int kind = chance.whole(0, 7);
      if (kind == 0) {
        document = states[std::size_t(chance.whole(0, int(states.size()) - 1))];
      } else if (kind == 1) {
        document.placements.water.rivers.push_back(
            {{{chance.real(0, 259), chance.real(0, 199)}, {chance.real(0, 259), chance.real(0, 199)}}, 0.5});
      } else {
        dab(document, chance.real(0, 259), chance.real(0, 199), chance.real(3, 40), chance.real(90, 260),
            kind < 4 ? BrushMode::add : BrushMode::set);
      }
      states.push_back(document);
      const int reports = chance.whole(1, 24);
      if (chance.whole(0, 1) == 0) {
        solve_until(document, cache, reports);
      } else {
        INFO("session " << session << ", step " << step);
        require_same(*solved(document, &cache, [](const Maps&) {}), *solved(document));
      }
    }
    INFO("session " << session);
    require_same(*solved(document, &cache, [](const Maps&) {}), *solved(document));
  }
}

TEST_CASE("A worker answers every dab of a stroke near the brush, and all of it in the end") {
  Document document = start();
  Worker worker;
  worker.post(document);
  worker.wait_idle();
  for (int i = 0; i < 12; ++i) {
    dab(document, 40 + 15 * float(i), 120, 10, 200);
    worker.post(document);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  worker.wait_idle();
  require_same(*worker.latest_complete(), *solved(document));
}
