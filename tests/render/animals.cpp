#include <catch2/catch.hpp>

#include "render/animal_members.hpp"
#include "render/animal_mesh.hpp"

using namespace biotope;

namespace {

Species grazer() {
  Species species;
  species.name = "grazer";
  AnimalTraits traits;
  traits.speed = 1.4F;
  traits.shape.body_length = 2;
  species.traits = traits;
  return species;
}

/// A flat terrain of 1 km with one herd of 20 that walks from west to east between 8 and 8:10 and stands before and after.
struct WalkingHerd {
  MapsSnapshot maps;
  DailyPlan plan;

  WalkingHerd() {
    Terrain terrain;
    terrain.height = Grid<float>(100, 100, 5.0F);
    terrain.cell_size = 10;
    maps.document.terrain = std::make_shared<const Terrain>(std::move(terrain));
    FoodWeb web;
    web.species = {grazer()};
    web.level = {1};
    maps.web = std::make_shared<const FoodWeb>(std::move(web));
    ResourceAccessGraph graph;
    graph.levels.resize(2);
    graph.levels[1].nodes.resize(2);
    graph.levels[1].nodes[0].x = 20;
    graph.levels[1].nodes[1].x = 80;
    maps.graph = std::make_shared<const ResourceAccessGraph>(std::move(graph));
    plan.size = 20;
    plan.active = {{0, 24}};
    plan.stops = {{0, 0, 8}, {1, 8.167F, 23.8F}};
    plan.way = {{0, {20, 50}}, {8, {20, 50}}, {8.167F, {80, 50}}, {23.8F, {80, 50}}, {24, {20, 50}}};
  }
};

}  // namespace

TEST_CASE("A herd's members are a pure function of the hour, one for each animal, on the map") {
  const WalkingHerd herd;
  for (const double hour : {0.0, 7.9, 8.05, 12.0, 23.9}) {
    const auto once = herd_members(herd.maps, herd.plan, 3, hour);
    const auto again = herd_members(herd.maps, herd.plan, 3, hour);
    REQUIRE(once.size() == 20);
    for (std::size_t i = 0; i < once.size(); ++i) {
      CHECK(once[i].place == again[i].place);
      CHECK(once[i].place.x >= 0);
      CHECK(once[i].place.x <= 1000);
      CHECK(once[i].size > 0.4F);
    }
  }
}

TEST_CASE("Standing members keep near the herd and apart from each other; another herd stands otherwise") {
  const WalkingHerd herd;
  const auto members = herd_members(herd.maps, herd.plan, 0, 12);
  const glm::dvec2 middle{805, 495};
  int crowded = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    CHECK(glm::length(members[i].place - middle) < 30);
    for (std::size_t j = 0; j < i; ++j) crowded += glm::length(members[i].place - members[j].place) < 0.3;
  }
  CHECK(crowded <= 2);
  CHECK(herd_members(herd.maps, herd.plan, 1, 12).front().place != members.front().place);
}

TEST_CASE("Nobody jumps: between two near moments a member moves no faster than an animal can") {
  const WalkingHerd herd;
  auto before = herd_members(herd.maps, herd.plan, 0, 7.95);
  constexpr double seconds = 2;
  for (double hour = 7.95 + seconds / 3600; hour < 8.3; hour += seconds / 3600) {
    const auto now = herd_members(herd.maps, herd.plan, 0, hour);
    for (std::size_t i = 0; i < now.size(); ++i) {
      REQUIRE(glm::length(now[i].place - before[i].place) < 4.5 * seconds);
    }
    before = now;
  }
}

TEST_CASE("Every model of animal has a mesh at every detail, fewer triangles the coarser, as tall as it should be") {
  for (const char* model : {"bovid", "deer", "horse", "goat", "sheep", "bear", "wolf", "cat", "fox", "boar", "rhino", "unheard-of"}) {
    AnimalShape shape;
    shape.model = model;
    shape.shoulder_height = 1.2F;
    std::size_t last = 10000;
    for (const AnimalDetail detail : {AnimalDetail::fine, AnimalDetail::plain, AnimalDetail::silhouette}) {
      const AnimalMesh mesh = make_animal_mesh(shape, detail);
      INFO(model);
      CHECK(mesh.indices.size() / 3 < last);
      last = mesh.indices.size() / 3;
      float lowest = 10;
      float withers = 0;
      for (const AnimalVertex& vertex : mesh.vertices) {
        lowest = std::min(lowest, vertex.position.z);
        if (vertex.rig.x == 0) withers = std::max(withers, vertex.position.z);
        CHECK(glm::length(vertex.normal) == Approx(1).margin(1e-3));
      }
      CHECK(lowest == Approx(0).margin(0.08));
      CHECK(withers > 0.8F);
      CHECK(withers < 1.6F);
    }
    CHECK(last <= 130);
  }
}
