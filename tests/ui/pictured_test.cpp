#include "ui/pictured.hpp"

#include <catch2/catch.hpp>

using namespace biotope;

namespace {

/// A landscape of which all is known.
std::shared_ptr<MapsSnapshot> whole() {
  auto maps = std::make_shared<MapsSnapshot>();
  auto terrain = std::make_shared<Terrain>();
  terrain->height = Grid<float>(8, 8, 1);
  maps->document.terrain = terrain;
  maps->document_revision = 1;
  maps->web = std::make_shared<const FoodWeb>();
  maps->hydrology = std::make_shared<const Hydrology>();
  maps->environment = std::make_shared<const EnvironmentMaps>();
  maps->cover = {std::make_shared<const CoverMap>(8, 8, Cover(0))};
  maps->trails = std::make_shared<const TrailNetwork>();
  maps->plans = std::make_shared<const std::vector<DailyPlan>>();
  maps->graph = std::make_shared<const ResourceAccessGraph>();
  maps->complete = true;
  return maps;
}

/// What the worker publishes while it answers an edit: up to the plants.
std::shared_ptr<MapsSnapshot> answer_with_plants(const MapsSnapshot& before) {
  auto maps = std::make_shared<MapsSnapshot>(before);
  maps->document_revision = 2;
  maps->complete = false;
  maps->trails = nullptr;
  maps->plans = nullptr;
  maps->graph = nullptr;
  maps->cover = {std::make_shared<const CoverMap>(8, 8, Cover(9))};
  return maps;
}

}  // namespace

TEST_CASE("the 3D view shows new plants as soon as they are known, with the herds and trails of before") {
  const auto before = whole();
  const auto newest = answer_with_plants(*before);
  const auto shown = pictured_maps(newest, before, before);
  CHECK(shown->cover == newest->cover);
  CHECK(shown->document_revision == 2);
  CHECK_FALSE(shown->complete);
  CHECK(shown->trails == before->trails);
  CHECK(shown->plans == before->plans);
  CHECK(shown->graph == before->graph);

  // The levels above come one after the other: nothing in the picture is another, so it stays.
  const auto later = std::make_shared<MapsSnapshot>(*newest);
  later->animals.push_back(std::make_shared<const AnimalLevel>());
  CHECK(pictured_maps(later, before, shown) == shown);
  const auto all = std::make_shared<MapsSnapshot>(*later);
  all->complete = true;
  all->trails = std::make_shared<const TrailNetwork>();
  CHECK(pictured_maps(all, all, shown) == all);
}

TEST_CASE("until the plants of an edit are known the picture stays") {
  const auto before = whole();
  const auto newest = answer_with_plants(*before);
  newest->cover.clear();
  CHECK(pictured_maps(newest, before, before) == before);
  newest->cover = {nullptr};
  CHECK(pictured_maps(newest, before, before) == before);
}

TEST_CASE("a new landscape is shown at once, and its plants as soon as they are known") {
  const auto old = whole();
  const auto bare = std::make_shared<MapsSnapshot>();
  bare->document.terrain = std::make_shared<const Terrain>();
  CHECK(pictured_maps(bare, nullptr, old) == bare);
  const auto wet = std::make_shared<MapsSnapshot>(*bare);
  wet->hydrology = std::make_shared<const Hydrology>();
  CHECK(pictured_maps(wet, nullptr, bare) == bare);
  const auto green = std::make_shared<MapsSnapshot>(*whole());
  green->document.terrain = bare->document.terrain;
  green->complete = false;
  CHECK(pictured_maps(green, nullptr, bare) == green);
  const auto more = std::make_shared<MapsSnapshot>(*green);
  CHECK(pictured_maps(more, nullptr, green) == green);
}

TEST_CASE("growth that is lost shows at once, paint that only animals feel does not make a new picture") {
  auto before = whole();
  auto web = std::make_shared<FoodWeb>();
  web->species.resize(1);
  web->species[0].name = "grass";
  before->web = web;
  const auto first = answer_with_plants(*before);
  const auto shown = pictured_maps(first, before, before);
  const auto roaming = std::make_shared<MapsSnapshot>(*first);
  roaming->document_revision = 3;
  roaming->document.layers[{LayerKind::animal_density, "deer"}] = std::make_shared<const PaintLayer>();
  CHECK(pictured_maps(roaming, before, shown) == shown);
  const auto burnt = std::make_shared<MapsSnapshot>(*first);
  PaintLayer loss(8, 8);
  loss.set(1, 1, {0.5F, 1.0F});
  burnt->document.layers[{LayerKind::loss, "grass"}] = std::make_shared<const PaintLayer>(loss);
  CHECK(pictured_maps(burnt, before, shown) != shown);
}
