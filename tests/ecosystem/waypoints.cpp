#include <catch2/catch.hpp>

#include "animal_scene.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

Scene meadow(Landscape land) {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  const int deer = builder.animal("deer", 1, walker(), {{"grass", {grass}}});
  builder.animal("wolf", 2, walker(1), {{"meat", {deer}}});
  land.brook_row(5);
  return {std::move(land), builder.web};
}

std::shared_ptr<const AnimalLevel> level_with(const Scene& scene, int level, const Places& places,
                                              const std::vector<std::shared_ptr<const AnimalLevel>>& below = {},
                                              std::shared_ptr<const AnimalLevel> previous = {}) {
  Ground ground = previous ? previous->basis.ground : scene.land.ground();
  ground.places = std::make_shared<const Places>(places);
  AnimalLevelInput input{scene.web, level, ground, scene.plants, below, {}, {}, {}, 1, std::move(previous)};
  auto result = compute_animal_level(input);
  REQUIRE(result);
  return std::make_shared<const AnimalLevel>(std::move(*result));
}

std::vector<ResourceNode> waypoints(const AnimalLevel& level) {
  std::vector<ResourceNode> found;
  for (const ResourceNode& node : level.graph->nodes) {
    if (node.kind == NodeKind::waypoint) found.push_back(node);
  }
  return found;
}

}  // namespace

TEST_CASE("waypoints and exits are nodes of one cell that offer nothing") {
  const Scene scene = meadow(Landscape(30, 20, 50));
  const auto level = level_with(scene, 1, {{}, {{{29, 10}, 20}}, {{{4.2F, 8.6F}, 0.5F}}, {}, {}});
  const auto found = waypoints(*level);
  REQUIRE(found.size() == 2);
  CHECK(found[0].x == 4);
  CHECK(found[0].y == 9);
  CHECK(found[0].cells == 1);
  CHECK(found[0].area == 2500);
  CHECK(found[0].bounds == Rect{4, 9, 5, 10});
  CHECK(found[0].attraction == 0.5F);
  CHECK(found[0].quantities.empty());
  CHECK(found[0].piece == level->partition->label(4, 9));
  CHECK(found[1].x == 29);
  CHECK(found[1].attraction == exit_attraction);
}

TEST_CASE("a waypoint moves to the nearest passable ground within 20 m, and is none where there is none") {
  Landscape land(60, 40, 5);
  for (int x = 20; x < 23; ++x) land.cliff_column(x);
  for (int x = 40; x < 55; ++x) land.cliff_column(x);
  const Scene scene = meadow(land);
  const auto found = waypoints(*level_with(scene, 1, {{}, {}, {{{20, 20}, 1}, {{47, 20}, 1}, {{-30, 5}, 1}}, {}, {}}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].x == 19);
  CHECK(found[0].y == 20);
}

TEST_CASE("waypoints do not change who lives where, above or below") {
  const Scene scene = meadow(Landscape(30, 20, 50));
  const Places places{{}, {}, {{{4, 8}, 1}, {{20, 12}, 0.1F}}, {}, {}};
  const auto bare = level_with(scene, 1, {});
  const auto visited = level_with(scene, 1, places);
  CHECK(visited->population == bare->population);
  CHECK(visited->eaten == bare->eaten);
  const auto wolves = level_with(scene, 2, places, {visited});
  CHECK(wolves->population == level_with(scene, 2, {}, {bare})->population);
  for (const ResourceNode& node : wolves->graph->nodes) {
    for (const int below : node.built_from) CHECK(visited->graph->nodes[std::size_t(below)].kind != NodeKind::waypoint);
  }
}

TEST_CASE("nodes follow waypoints that are set, moved and taken away, and no other places") {
  const Scene scene = meadow(Landscape(30, 20, 50));
  const auto bare = level_with(scene, 1, {});
  Places places;
  places.waypoints.push_back({{4, 8}, 0.5F});
  const auto set = level_with(scene, 1, places, {}, bare);
  CHECK(waypoints(*set).size() == 1);
  places.pinned_trails.push_back({{{1, 1}, {5, 5}}, 1000});
  const auto pinned = level_with(scene, 1, places, {}, set);
  CHECK(pinned->graph == set->graph);
  places.waypoints[0].at.x = 12;
  CHECK(waypoints(*level_with(scene, 1, places, {}, pinned))[0].x == 12);
  CHECK(waypoints(*level_with(scene, 1, {}, {}, pinned)).empty());
}
