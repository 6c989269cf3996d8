#include "core/pipeline/stale_stages.hpp"

#include <catch2/catch.hpp>

#include "core/pipeline/solve.hpp"
#include "core/pipeline/worker.hpp"
#include "tests/scenes/small_valley.hpp"

using namespace biotope;

namespace {

const MapsSnapshot& solved() {
  static const std::shared_ptr<const MapsSnapshot> maps = [] {
    auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
    if (!document) FAIL(document.error().message);
    auto snapshot = solve(*document);
    if (!snapshot) FAIL(snapshot.error().message);
    return *snapshot;
  }();
  return *maps;
}

Document painted(const LayerId& layer, float value) {
  Document document = solved().document;
  PaintLayer paint(document.terrain->height.width(), document.terrain->height.height());
  paint.set(5, 5, {value, 1});
  document.layers[layer] = std::make_shared<const PaintLayer>(paint);
  return document;
}

std::string species_of_level(std::size_t level) {
  return solved().web->species[std::size_t(solved().web->levels[level].front())].name;
}

}  // namespace

TEST_CASE("What was answered is not stale; nothing answered leaves everything to do") {
  CHECK_FALSE(stale_stages(&solved(), solved().document).any());
  const StaleStages all = stale_stages(nullptr, solved().document);
  CHECK(all.water);
  CHECK(all.environment);
  CHECK(all.level(0));
  CHECK(all.trails);
  CHECK(all.days);
}

TEST_CASE("Painting a level leaves what lies below it as it is") {
  const std::size_t top = solved().web->levels.size() - 1;
  REQUIRE(top >= 2);
  const StaleStages hunter = stale_stages(&solved(), painted({LayerKind::animal_density, species_of_level(top)}, 1));
  CHECK_FALSE(hunter.water);
  CHECK_FALSE(hunter.environment);
  CHECK_FALSE(hunter.level(0));
  CHECK_FALSE(hunter.level(1));
  CHECK(hunter.level(int(top)));
  CHECK(hunter.trails);
  const StaleStages plant = stale_stages(&solved(), painted({LayerKind::plant_density, species_of_level(0)}, 0.5F));
  CHECK_FALSE(plant.environment);
  CHECK(plant.level(0));
  CHECK(plant.level(int(top)));
  const StaleStages loss = stale_stages(&solved(), painted({LayerKind::loss, species_of_level(0)}, 0.5F));
  CHECK_FALSE(loss.level(0));
  CHECK(loss.level(1));
  CHECK(stale_stages(&solved(), painted({LayerKind::ground, "height"}, 900)).water);
}

TEST_CASE("What only leads ways touches trails and days; what is named or locked touches nothing") {
  Document document = solved().document;
  document.placements.places.pinned_trails.push_back({{{5, 5}, {30, 30}}, 1000});
  StaleStages stale = stale_stages(&solved(), document);
  CHECK(stale.trails);
  CHECK_FALSE(stale.level(1));
  document = solved().document;
  document.title = "Another";
  document.locked_area = std::make_shared<const SelectionMask>(4, 4);
  document.layer_states[{LayerKind::passage, "all"}] = {false, true};
  CHECK_FALSE(stale_stages(&solved(), document).any());
}

TEST_CASE("What a stage is said to leave alone is the same object after the answer") {
  const std::size_t top = solved().web->levels.size() - 1;
  SolveCache cache;
  const auto before = solve(solved().document, &cache);
  REQUIRE(before);
  const Document edits[] = {painted({LayerKind::animal_density, species_of_level(top)}, 2),
                            painted({LayerKind::plant_density, species_of_level(0)}, 0.5F),
                            painted({LayerKind::loss, species_of_level(0)}, 0.5F), painted({LayerKind::passage, "all"}, 1)};
  for (const Document& edit : edits) {
    const StaleStages stale = stale_stages(before->get(), edit);
    SolveCache own;
    REQUIRE(solve(solved().document, &own));
    const auto first = solve(solved().document, &own);
    const auto after = solve(edit, &own);
    REQUIRE(first);
    REQUIRE(after);
    if (!stale.water) CHECK((*after)->hydrology == (*first)->hydrology);
    if (!stale.environment) CHECK((*after)->environment == (*first)->environment);
    if (!stale.level(0)) CHECK((*after)->cover == (*first)->cover);
    for (std::size_t i = 0; i < (*after)->animals.size(); ++i) {
      if (!stale.level(int(i) + 1)) CHECK((*after)->animals[i] == (*first)->animals[i]);
    }
  }
}

TEST_CASE("A partial answer takes from what is stale what it holds") {
  StaleStages stale = stale_stages(nullptr, solved().document);
  MapsSnapshot reached;
  reached.web = solved().web;
  reached.hydrology = solved().hydrology;
  stale = still_stale(stale, reached);
  CHECK_FALSE(stale.water);
  CHECK(stale.level(0));
  reached.environment = solved().environment;
  reached.cover = solved().cover;
  reached.animals = {solved().animals.front()};
  stale = still_stale(stale, reached);
  CHECK_FALSE(stale.level(1));
  CHECK(stale.level(2));
  CHECK_FALSE(still_stale(stale, solved()).any());
}
