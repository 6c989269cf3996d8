#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/random.hpp"
#include "core/movement/travel.hpp"
#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

constexpr Mobility deer{0.8F, 0.5F, 1.0F, 3.5F};

TravelGraph graph_of(const MovementScene& scene, int block, const Mobility& mobility = deer) {
  return build_travel_graph(scene.ground, confinement_regions(scene.blocked, scene.ground.terrain->cell_size), mobility, block);
}

/// Cheapest costs by relaxing every edge until nothing changes (Bellman-Ford).
std::vector<float> reference_costs(const TravelGraph& graph, std::uint32_t source) {
  std::vector<float> cost(graph.vertices.size(), std::numeric_limits<float>::infinity());
  cost[source] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
      for (std::uint32_t e = graph.first_edge[v]; e < graph.first_edge[v + 1]; ++e) {
        const float there = cost[v] + graph.cost[e];
        if (there < cost[graph.target[e]]) {
          cost[graph.target[e]] = there;
          changed = true;
        }
      }
    }
  }
  return cost;
}

MovementScene rough_scene() {
  MovementScene scene(60, 45, 10, [](int x, int y) { return 30.0F * std::sin(float(x) * 0.3F) * std::cos(float(y) * 0.23F); });
  for (int y = 0; y < 45; ++y) {
    for (int x = 0; x < 60; ++x) scene.blocked(x, y) = random_unit({7, std::uint64_t(x / 2), std::uint64_t(y / 2)}) < 0.3;
  }
  return scene;
}

}  // namespace

TEST_CASE("walking speed is Tobler's") {
  CHECK(walking_speed(1.4F, 0, 3.5F, 1) == Approx(1.4F));
  // Tobler: 6 km/h at -0.05, 5.04 km/h on the flat.
  CHECK(walking_speed(5.036F, -0.05F, 3.5F, 1) == Approx(6.0F).epsilon(0.002));
  for (const float slope : {-0.6F, -0.2F, -0.1F, 0.0F, 0.05F, 0.3F}) {
    CHECK(walking_speed(1.4F, slope, 3.5F, 1) < walking_speed(1.4F, -0.05F, 3.5F, 1));
  }
  CHECK(walking_speed(1.4F, 0.2F, 3.5F, 1) < walking_speed(1.4F, -0.2F, 3.5F, 1));
  CHECK(walking_speed(1.4F, 0.51F, 3.5F, 0.5F) == 0);
  CHECK(walking_speed(1.4F, -0.51F, 3.5F, 0.5F) == 0);
}

TEST_CASE("on a plane a walk costs its length, there and back") {
  const MovementScene scene(64, 48, 5);
  const TravelGraph graph = graph_of(scene, 8);
  REQUIRE(graph.vertices.size() == 8 * 6);
  for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
    for (std::uint32_t e = graph.first_edge[v]; e < graph.first_edge[v + 1]; ++e) {
      const auto& a = graph.vertices[v];
      const auto& b = graph.vertices[graph.target[e]];
      CHECK(graph.cost[e] == Approx(5 * std::hypot(a.x - b.x, a.y - b.y)));
    }
  }
  const TravelField field = travel_field(graph, 0);
  // Along a row of blocks of 40 m.
  CHECK(field.cost[7] == Approx(280));
  // The other corner: five diagonals and two steps.
  CHECK(field.cost[47] == Approx(5 * 40 * std::sqrt(2.0) + 2 * 40));
}

TEST_CASE("up a ramp is slower than down") {
  const MovementScene scene(64, 8, 5, [](int x, int) { return 5 * 0.2F * float(x); });
  const TravelGraph graph = graph_of(scene, 8);
  const double up = travel_field(graph, 0).cost[7];
  const double down = travel_field(graph, 7).cost[0];
  CHECK(up == Approx(280 * std::exp(3.5 * (0.25 - 0.05))).epsilon(0.001));
  CHECK(down == Approx(280 * std::exp(3.5 * (0.15 - 0.05))).epsilon(0.001));
}

TEST_CASE("vertices are the connected pieces of passable ground inside blocks") {
  MovementScene scene(16, 8, 25);
  // A wall down the middle of the west block, and a corner of the east block.
  for (int y = 0; y < 8; ++y) scene.blocked(3, y) = 1;
  const TravelGraph graph = graph_of(scene, 8);
  REQUIRE(graph.vertices.size() == 3);
  CHECK(graph.vertex_of_cell(0, 0) == 0);
  CHECK(graph.vertex_of_cell(3, 4) == -1);
  CHECK(graph.vertex_of_cell(7, 7) == 1);
  CHECK(graph.vertex_of_cell(8, 0) == 2);
  // The piece west of the wall touches nothing.
  CHECK(graph.first_edge[1] - graph.first_edge[0] == 0);
  CHECK(graph.edge_count == 1);
}

TEST_CASE("a wall is passed through its gap and not where it is closed") {
  MovementScene scene(64, 64, 10);
  for (int x = 0; x < 64; ++x) scene.blocked(x, 31) = x != 50;
  const TravelGraph graph = graph_of(scene, 4);
  const auto at = [&](int x, int y) { return std::uint32_t(graph.vertex_of_cell(x, y)); };
  const TravelField field = travel_field(graph, at(5, 5));
  REQUIRE(std::isfinite(field.cost[at(5, 60)]));
  bool through_gap = false;
  for (auto v = std::int32_t(at(5, 60)); v >= 0; v = field.parent[std::size_t(v)]) {
    const auto& vertex = graph.vertices[std::size_t(v)];
    CHECK(scene.blocked(vertex.x, vertex.y) == 0);
    through_gap = through_gap || v == std::int32_t(at(50, 31));
  }
  CHECK(through_gap);
  scene.blocked(50, 31) = 1;
  const TravelGraph closed = graph_of(scene, 4);
  const TravelField none = travel_field(closed, std::uint32_t(closed.vertex_of_cell(5, 5)));
  CHECK(std::isinf(none.cost[std::size_t(closed.vertex_of_cell(5, 60))]));
  CHECK(none.parent[std::size_t(closed.vertex_of_cell(5, 60))] == -1);
}

TEST_CASE("wading costs three times dry ground") {
  MovementScene scene(32, 8, 10);
  Hydrology hydrology = *scene.ground.hydrology;
  for (float& depth : hydrology.water_depth.cells()) depth = 0.2F;
  scene.ground.hydrology = std::make_shared<const Hydrology>(std::move(hydrology));
  const TravelGraph graph = graph_of(scene, 8);
  CHECK(travel_field(graph, 0).cost[3] == Approx(3 * 3 * 80));
}

TEST_CASE("the graph connects exactly what the fine cells connect") {
  const MovementScene scene = rough_scene();
  const ConfinementRegions regions = confinement_regions(scene.blocked, 10);
  for (const int block : {1, 3, 7, 16}) {
    const TravelGraph graph = graph_of(scene, block);
    for (int y = 0; y < 45; ++y) {
      for (int x = 0; x < 60; ++x) REQUIRE((graph.vertex_of_cell(x, y) >= 0) == (regions.label(x, y) >= 0));
    }
    for (std::uint32_t source = 0; source < graph.vertices.size(); source += 5) {
      const TravelField field = travel_field(graph, source);
      for (std::size_t v = 0; v < graph.vertices.size(); ++v) {
        REQUIRE(std::isfinite(field.cost[v]) == (graph.vertices[v].region == graph.vertices[source].region));
      }
    }
  }
}

TEST_CASE("the field is the cheapest, and its tree adds up to it") {
  const MovementScene scene = rough_scene();
  const TravelGraph graph = graph_of(scene, 3);
  for (std::uint32_t source = 0; source < graph.vertices.size(); source += 29) {
    const TravelField field = travel_field(graph, source);
    REQUIRE(field.cost == reference_costs(graph, source));
    for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
      if (field.parent[v] < 0) continue;
      const auto parent = std::uint32_t(field.parent[v]);
      bool adds_up = false;
      for (std::uint32_t e = graph.first_edge[parent]; e < graph.first_edge[parent + 1]; ++e) {
        adds_up = adds_up || (graph.target[e] == v && field.cost[parent] + graph.cost[e] == field.cost[v]);
      }
      REQUIRE(adds_up);
    }
  }
}
