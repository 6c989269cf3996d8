#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "core/movement/movement_cache.hpp"
#include "core/movement/trail_raster.hpp"
#include "core/movement/walkers.hpp"
#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

AnimalTraits deer_traits() {
  AnimalTraits traits;
  traits.mass_min = 80;
  traits.mass_max = 120;
  traits.speed = 1.2F;
  traits.max_slope = 0.8F;
  traits.water_visits = 2;
  return traits;
}

/// Resources behind a fork: water in the west, two meadows in the east with a ridge between them.
MovementScene forked_valley() {
  MovementScene scene(120, 80, 10);
  for (int x = 70; x < 120; ++x) scene.blocked(x, 40) = 1;
  scene.animal("deer", 1, deer_traits(), {0});
  scene.add(scene.level(1, {MovementScene::node(NodeKind::bank, 5, 40, 3000, 0), MovementScene::node(NodeKind::vegetation, 110, 25, 50000, 9000),
                            MovementScene::node(NodeKind::vegetation, 110, 55, 50000, 9000)}));
  return scene;
}

}  // namespace

TEST_CASE("presence sums to one over a region and follows needs and quantities (eq. 1)") {
  MovementScene scene(40, 40, 20);
  scene.animal("deer", 1, deer_traits(), {0});
  const AnimalLevel level = scene.level(1, {MovementScene::node(NodeKind::bank, 5, 5, 1000, 0), MovementScene::node(NodeKind::bank, 35, 5, 3000, 0),
                                            MovementScene::node(NodeKind::vegetation, 5, 30, 20000, 1000),
                                            MovementScene::node(NodeKind::vegetation, 35, 30, 20000, 4000)});
  const auto presence = presence_in_region(scene.web, level, 0, 0);
  REQUIRE(presence.size() == 4);
  // Two visits to water are 15 % of the stays; banks by their area, meadows by their growth.
  CHECK(presence[0].probability == Approx(0.15 * 0.25));
  CHECK(presence[1].probability == Approx(0.15 * 0.75));
  CHECK(presence[2].probability == Approx(0.85 * 0.2));
  CHECK(presence[3].probability == Approx(0.85 * 0.8));
  CHECK(presence_in_region(scene.web, level, 0, 1).empty());
}

TEST_CASE("a need that nothing meets leaves its share to the others") {
  MovementScene scene(40, 40, 20);
  scene.animal("deer", 1, deer_traits(), {0});
  const AnimalLevel level = scene.level(1, {MovementScene::node(NodeKind::vegetation, 5, 30, 20000, 1000)});
  const auto presence = presence_in_region(scene.web, level, 0, 0);
  REQUIRE(presence.size() == 1);
  CHECK(presence[0].probability == Approx(1));
}

TEST_CASE("onward probabilities weigh presence by inverse travel time and sum to one (eq. 2)") {
  MovementScene scene(100, 20, 10);
  scene.animal("deer", 1, deer_traits(), {0});
  scene.add(scene.level(1, {MovementScene::node(NodeKind::vegetation, 10, 10, 20000, 1000), MovementScene::node(NodeKind::vegetation, 40, 10, 20000, 2000),
                            MovementScene::node(NodeKind::vegetation, 90, 10, 20000, 3000)}));
  const auto& edges = scene.movement[0].edges;
  const auto& onward = scene.movement[0].travel->onward;
  REQUIRE(edges.size() == 6);
  std::map<int, double> sum;
  for (std::size_t i = 0; i < edges.size(); ++i) sum[edges[i].from] += double(onward[i]);
  for (const auto& [node, total] : sum) CHECK(total == Approx(1));
  // From the first: 300 m and 800 m, presence 2 : 3.
  const double near = 2.0 / 300;
  const double far = 3.0 / 800;
  REQUIRE(edges[0].to == 1);
  CHECK(edges[0].seconds == Approx(300 / 1.2).epsilon(0.02));
  CHECK(onward[0] == Approx(near / (near + far)).epsilon(0.02));
}

TEST_CASE("the weight between two nodes is eq. 3") {
  MovementScene scene(100, 20, 10);
  scene.animal("deer", 1, deer_traits(), {0});
  scene.add(scene.level(1, {MovementScene::node(NodeKind::vegetation, 10, 10, 20000, 1000), MovementScene::node(NodeKind::vegetation, 90, 10, 20000, 3000)}, 50));
  const TravelGraph& graph = *scene.movement[0].travel->graphs[0];
  const auto walkers = walkers_of_graph(scene.web, scene.levels, scene.movement, 0, 0);
  const auto weight = walked_weight(graph, graph.cost, walkers);
  // P(v) P(v'|v) + P(v') P(v|v') = 0.25 + 0.75, times 100 kg x 50 animals x 8 walks x 365 days.
  const double expected = 100.0 * 50 * 8 * 365;
  CHECK(*std::max_element(weight.begin(), weight.end()) == Approx(expected));
  for (const double w : weight) CHECK((w == 0 || w == Approx(expected)));
}

TEST_CASE("ways to two resources behind a fork share a trunk") {
  const MovementScene scene = forked_valley();
  const TrailNetwork network = scene.trails();
  REQUIRE(network.routes.size() >= 2);
  // Close to the water one trail carries all; it is worn more than the branches near the meadows.
  const auto column_total = [&](int x) {
    int worn = 0;
    for (int y = 0; y < 80; ++y) worn += network.wear(x, y) > 0;
    return worn;
  };
  CHECK(column_total(20) >= 1);
  CHECK(column_total(20) <= 4);
  const auto worn_near = [&](int x, int y) {
    bool worn = false;
    for (int dy = -3; dy <= 3; ++dy) {
      for (int dx = -3; dx <= 3; ++dx) worn = worn || network.wear(x + dx, y + dy) > 0;
    }
    return worn;
  };
  CHECK(worn_near(5, 40));
  CHECK(worn_near(110, 25));
  CHECK(worn_near(110, 55));
}

TEST_CASE("a route that leaves another begins on it") {
  const TrailNetwork network = forked_valley().trails();
  REQUIRE(network.routes.size() >= 2);
  for (std::size_t r = 1; r < network.routes.size(); ++r) {
    const auto touches = [&](PathPoint end) {
      for (std::size_t q = 0; q < r; ++q) {
        for (const PathPoint& p : network.routes[q].points) {
          if (p.x == end.x && p.y == end.y) return true;
        }
      }
      return false;
    };
    CHECK((touches(network.routes[r].points.front()) || touches(network.routes[r].points.back())));
  }
}

TEST_CASE("trails lead through a gap and never over blocked cells") {
  const double cell_size = GENERATE(10.0, 1.0);
  MovementScene scene(150, 100, cell_size, [](int x, int y) { return 0.2F * std::sin(float(x) * 0.2F) + 0.1F * float(y % 7); });
  for (int y = 0; y < 100; ++y) scene.blocked(70, y) = y < 80 || y > 82;
  for (int i = 0; i < 40; ++i) scene.blocked(20 + i, 30 + (i * 7) % 20) = 1;
  scene.animal("deer", 1, deer_traits(), {0});
  scene.add(scene.level(1, {MovementScene::node(NodeKind::bank, 10, 20, 3000, 0), MovementScene::node(NodeKind::vegetation, 140, 15, 50000, 9000),
                            MovementScene::node(NodeKind::vegetation, 120, 90, 50000, 9000)}));
  const TrailNetwork network = scene.trails();
  REQUIRE(!network.routes.empty());
  bool through_gap = false;
  double length = 0;
  for (const TrailRoute& route : network.routes) {
    REQUIRE(route.points.size() == route.weight.size());
    for (std::size_t i = 0; i < route.points.size(); ++i) {
      const PathPoint p = route.points[i];
      const int x = int(std::lround(p.x));
      const int y = int(std::lround(p.y));
      REQUIRE(scene.blocked(x, y) == 0);
      REQUIRE(route.weight[i] > 0);
      if (i == 0) continue;
      const PathPoint q = route.points[i - 1];
      length += std::hypot(p.x - q.x, p.y - q.y) * cell_size;
      if ((p.x - 70) * (q.x - 70) > 0) continue;
      const double crossing = p.x == q.x ? double(p.y) : double(q.y) + (double(p.y) - double(q.y)) * (70 - double(q.x)) / (double(p.x) - double(q.x));
      through_gap = true;
      CHECK(crossing > 79.4);
      CHECK(crossing < 82.6);
    }
  }
  CHECK(through_gap);
  CHECK(network.total_length() == Approx(length));
}

TEST_CASE("nothing is worn where nobody walks") {
  MovementScene scene(100, 60, 10);
  for (int y = 0; y < 60; ++y) scene.blocked(50, y) = 1;
  scene.animal("deer", 1, deer_traits(), {0});
  AnimalLevel level = scene.level(1, {MovementScene::node(NodeKind::bank, 10, 20, 3000, 0), MovementScene::node(NodeKind::vegetation, 30, 40, 50000, 9000),
                                      MovementScene::node(NodeKind::bank, 60, 20, 3000, 0), MovementScene::node(NodeKind::vegetation, 90, 40, 50000, 9000)});
  level.population[0][1] = 0;
  scene.add(std::move(level));
  const TrailNetwork network = scene.trails();
  float west = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 50; ++x) west = std::max(west, network.wear(x, y));
    for (int x = 50; x < 100; ++x) {
      REQUIRE(network.wear(x, y) == 0);
      REQUIRE(network.carving(x, y) == 0);
    }
  }
  CHECK(west > 0);
  CHECK(west <= 1);
  CHECK(*std::max_element(network.carving.cells().begin(), network.carving.cells().end()) <= 0.3F);
}

TEST_CASE("a trail covers of a coarse cell what its width covers") {
  CHECK(trail_intensity(3e6F) == 1);
  CHECK(trail_intensity(0) == 0);
  CHECK(trail_width(3e6F) == Approx(2.5));
  MovementScene scene(20, 20, 10);
  TrailNetwork network;
  network.routes.push_back({{{2, 10}, {17, 10}}, {3e6F, 3e6F}, 150});
  const std::vector<float> wade{0.5F};
  draw_trails(scene.ground, wade, network);
  // 2.5 m of 10 m, seen from the cell on the line: (half the width + half a cell) of the cell, times the share of the width.
  CHECK(network.wear(10, 10) == Approx(0.25 * 0.625));
  CHECK(network.wear(10, 12) == 0);
  Hydrology hydrology = *scene.ground.hydrology;
  hydrology.water_depth(10, 10) = 0.6F;
  scene.ground.hydrology = std::make_shared<const Hydrology>(std::move(hydrology));
  draw_trails(scene.ground, wade, network);
  CHECK(network.wear(10, 10) == 0);
  CHECK(network.wear(9, 10) > 0);
}

TEST_CASE("trails do not depend on the number of threads") {
  const auto with_threads = [](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return forked_valley().trails();
  };
  const TrailNetwork one = with_threads(1);
  const TrailNetwork two = with_threads(2);
  CHECK(one.wear == two.wear);
  CHECK(one.carving == two.carving);
  REQUIRE(one.routes.size() == two.routes.size());
  for (std::size_t i = 0; i < one.routes.size(); ++i) CHECK(one.routes[i].weight == two.routes[i].weight);
}

TEST_CASE("what a cache holds changes nothing") {
  MovementScene scene = forked_valley();
  const auto same = [](const TrailNetwork& a, const TrailNetwork& b) {
    bool equal = a.wear == b.wear && a.carving == b.carving && a.routes.size() == b.routes.size();
    for (std::size_t i = 0; equal && i < a.routes.size(); ++i) equal = a.routes[i].weight == b.routes[i].weight;
    return equal;
  };
  MovementCache cache;
  const TrailNetwork first = scene.trails();
  CHECK(same(first, scene.trails(&cache)));
  CHECK(same(first, scene.trails(&cache)));
  // The same cache after a rock has fallen on the trail: paths across it are not taken from before.
  for (int y = 10; y < 70; ++y) scene.blocked(40, y) = 1;
  AnimalLevel level = scene.level(1, scene.levels[0]->graph->nodes);
  scene.levels = {std::make_shared<const AnimalLevel>(std::move(level))};
  for (int round = 0; round < 4; ++round) {
    auto cached = compute_level_movement(scene.web, *scene.levels[0], scene.ground, {}, &cache);
    auto fresh = compute_level_movement(scene.web, *scene.levels[0], scene.ground);
    REQUIRE((cached && fresh));
    CHECK(cached->travel->onward == fresh->travel->onward);
    scene.movement = {std::move(*fresh)};
    const TrailNetwork network = scene.trails();
    scene.movement = {std::move(*cached)};
    CHECK(same(network, scene.trails(&cache)));
    CHECK_FALSE(same(network, first));
  }
}

TEST_CASE("a landscape without animals has no trails") {
  MovementScene scene(20, 20, 10);
  const TrailNetwork network = scene.trails();
  CHECK(network.routes.empty());
  CHECK(network.wear.rect() == scene.ground.terrain->height.rect());
}
