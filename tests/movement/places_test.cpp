#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/movement/movement_cache.hpp"
#include "core/movement/placed_ground.hpp"
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

/// Even ground of 1.2 x 0.8 km with water in the west and a meadow in the east, both in the middle row, and a wall that leaves
/// the given rows open.
MovementScene pasture(int gap_from = 0, int gap_until = 80) {
  MovementScene scene(120, 80, 10);
  for (int y = 0; y < 80; ++y) scene.blocked(60, y) = y < gap_from || y >= gap_until;
  scene.animal("deer", 1, deer_traits(), {0});
  return scene;
}

std::vector<ResourceNode> water_and_meadow() {
  return {MovementScene::node(NodeKind::bank, 10, 40, 3000, 0), MovementScene::node(NodeKind::vegetation, 110, 40, 50000, 9000)};
}

void place(MovementScene& scene, Places places) { scene.ground.places = std::make_shared<const Places>(std::move(places)); }

/// Lays out the level anew, with six herds.
void settle(MovementScene& scene, const std::vector<ResourceNode>& nodes, std::size_t herds = 6) {
  scene.levels.clear();
  scene.movement.clear();
  AnimalLevel level = scene.level(1, nodes);
  for (std::size_t i = 0; i < herds; ++i) level.herds.push_back({1, 0, 10 + int(i)});
  scene.add(std::move(level));
}

double distance_to(const std::vector<PathPoint>& line, PathPoint p) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double dx = double(line[i + 1].x - line[i].x);
    const double dy = double(line[i + 1].y - line[i].y);
    const double t = std::clamp(((double(p.x - line[i].x)) * dx + double(p.y - line[i].y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(double(p.x - line[i].x) - t * dx, double(p.y - line[i].y) - t * dy));
  }
  return nearest;
}

/// Share of the metres that herds walk from stop to stop which are within `cells` of a line.
double share_walked_near(const MovementScene& scene, const std::vector<DailyPlan>& plans, const std::vector<PathPoint>& line,
                         double cells) {
  int walking = 0;
  int near = 0;
  for (const DailyPlan& plan : plans) {
    for (double hour = 0; hour < 24; hour += 0.01) {
      const HerdState state = herd_state(plan, *scene.levels[0]->graph, hour, scene.ground.terrain->cell_size);
      if (state.activity != HerdActivity::walking || state.speed == 0) continue;
      ++walking;
      near += distance_to(line, state.at) <= cells;
    }
  }
  REQUIRE(walking > 50);
  return double(near) / walking;
}

bool same(const TrailNetwork& a, const TrailNetwork& b) {
  bool equal = a.wear == b.wear && a.carving == b.carving && a.routes.size() == b.routes.size();
  for (std::size_t i = 0; equal && i < a.routes.size(); ++i)
    equal = a.routes[i].weight == b.routes[i].weight && a.routes[i].points == b.routes[i].points;
  return equal;
}

const std::vector<PathPoint> southern_bend{{10, 42}, {25, 65}, {60, 70}, {95, 65}, {110, 42}};

}  // namespace

TEST_CASE("a line goes smoothly through its points, in small steps, on the map") {
  const std::vector<PathPoint> points{{2, 2}, {2, 2}, {20, 5}, {22, 30}, {90, 30}};
  const auto line = line_through(points, 2, {0, 0, 60, 40});
  const auto passes = [&](PathPoint p) { return std::find(line.begin(), line.end(), p) != line.end(); };
  CHECK(passes({2, 2}));
  CHECK(passes({20, 5}));
  CHECK(passes({22, 30}));
  CHECK(passes({59, 30}));
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = std::hypot(double(line[i].x - line[i - 1].x), double(line[i].y - line[i - 1].y));
    CHECK(step > 0);
    CHECK(step < 3);
  }
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const double turn =
        std::abs(std::remainder(std::atan2(double(line[i + 1].y - line[i].y), double(line[i + 1].x - line[i].x)) -
                                    std::atan2(double(line[i].y - line[i - 1].y), double(line[i].x - line[i - 1].x)),
                                6.283185307));
    CHECK(turn < 0.6);
  }
  CHECK(line_through(std::vector<PathPoint>{{3, 3}}, 2, {0, 0, 60, 40}).empty());
  CHECK(line_through(std::vector<PathPoint>{{3, 3}, {3, 3}}, 2, {0, 0, 60, 40}).empty());
}

TEST_CASE("a forbidden corridor holds the cells within its radius, but for pinned lines and their ends") {
  MovementScene scene(60, 60, 10);
  place(scene, {{}, {}, {}, {{{{10, 5}, {10, 55}}, 1000}}, {{{{5, 30}, {50, 30}, {50, 50}}, 35}}});
  const PlacedGround placed(scene.ground);
  const std::vector<PathPoint> corridor{{5, 30}, {50, 30}, {50, 50}};
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      const double away = distance_to(corridor, {float(x), float(y)});
      if (x == 10 && y >= 5 && y <= 55) {
        CHECK(placed.at(x, y) == PlacedGround::pinned);
      } else if (std::abs(away - 3.5) > 0.01) {
        CHECK((placed.at(x, y) == PlacedGround::forbidden) == (away < 3.5));
      }
    }
  }
  place(scene, {{}, {}, {}, {{{{30, 30}, {30, 10}}, 1000}}, {{{{10, 30}, {50, 30}}, 35}}});
  const PlacedGround bent(scene.ground);
  CHECK(bent.at(25, 30) == PlacedGround::forbidden);
  CHECK(bent.at(28, 30) == PlacedGround::none);
  CHECK(bent.at(30, 32) == PlacedGround::none);
}

TEST_CASE("a pinned trail is a route, worn and carved at least as asked, whoever lives there") {
  MovementScene scene = pasture();
  place(scene, {{}, {}, {}, {{southern_bend, 2e6F}}, {}});
  SECTION("nobody lives there") {}
  SECTION("nobody walks there") { settle(scene, {MovementScene::node(NodeKind::vegetation, 110, 10, 50000, 9000)}); }
  SECTION("others walk there") { settle(scene, water_and_meadow()); }
  SECTION("across what is blocked for all") {
    for (int y = 0; y < 80; ++y) scene.blocked(60, y) = 1;
    settle(scene, water_and_meadow());
  }
  const TrailNetwork network = scene.trails();
  REQUIRE(!network.routes.empty());
  const TrailRoute& route = network.routes.front();
  CHECK(route.pinned == 0);
  REQUIRE(route.points.size() == route.weight.size());
  CHECK(route.points.front() == southern_bend.front());
  CHECK(route.points.back() == southern_bend.back());
  for (const PathPoint& p : southern_bend) CHECK(std::find(route.points.begin(), route.points.end(), p) != route.points.end());
  for (const float weight : route.weight) CHECK(weight >= 2e6F);
  for (const PathPoint& p : route.points) {
    CHECK(network.wear(int(std::lround(p.x)), int(std::lround(p.y))) > 0);
    CHECK(network.carving(int(std::lround(p.x)), int(std::lround(p.y))) > 0);
  }
  CHECK(std::count_if(network.routes.begin(), network.routes.end(), [](const TrailRoute& r) { return r.pinned >= 0; }) == 1);
}

TEST_CASE("herds walk on a pinned trail, and wear it more") {
  MovementScene scene = pasture();
  settle(scene, water_and_meadow());
  const TrailNetwork before = scene.trails();
  const double by_itself = share_walked_near(scene, scene.plans_on(before), southern_bend, 3);
  CHECK(by_itself < 0.3);
  place(scene, {{}, {}, {}, {{southern_bend, 50000}}, {}});
  settle(scene, water_and_meadow());
  const TrailNetwork network = scene.trails();
  CHECK(share_walked_near(scene, scene.plans_on(network), network.routes.front().points, 1.5) > 0.8);
  CHECK(network.routes.front().weight[network.routes.front().weight.size() / 2] > 1e6F);
  // Nothing is left of the straight way.
  CHECK(network.wear(60, 40) == 0);
  CHECK(before.wear(60, 40) + before.wear(60, 39) + before.wear(60, 41) + before.wear(60, 42) + before.wear(60, 38) > 0);
}

TEST_CASE("a pinned trail over blocked cells is there, but herds never enter them") {
  MovementScene scene = pasture(5, 15);
  place(scene, {{}, {}, {}, {{southern_bend, 50000}}, {}});
  settle(scene, water_and_meadow());
  const TrailNetwork network = scene.trails();
  REQUIRE(network.routes.front().pinned == 0);
  for (std::size_t r = 1; r < network.routes.size(); ++r) {
    for (const PathPoint& p : network.routes[r].points) CHECK(scene.blocked(int(std::lround(p.x)), int(std::lround(p.y))) == 0);
  }
  int through = 0;
  for (const DailyPlan& plan : scene.plans_on(network)) {
    for (const auto& point : plan.way) {
      REQUIRE(scene.blocked(int(std::lround(point.at.x)), int(std::lround(point.at.y))) == 0);
      through += point.at.x > 58 && point.at.x < 62;
    }
  }
  CHECK(through > 0);
}

TEST_CASE("trails and herds go around a forbidden corridor") {
  const std::vector<PathPoint> corridor{{60, 25}, {60, 60}};
  MovementScene scene = pasture();
  settle(scene, water_and_meadow());
  const TrailNetwork before = scene.trails();
  const auto points_within = [&](const TrailNetwork& network) {
    std::size_t within = 0;
    for (const TrailRoute& route : network.routes) {
      within += std::size_t(
          std::count_if(route.points.begin(), route.points.end(), [&](PathPoint p) { return distance_to(corridor, p) < 2.4; }));
    }
    return within;
  };
  CHECK(points_within(before) > 0);
  place(scene, {{}, {}, {}, {}, {{corridor, 25}}});
  settle(scene, water_and_meadow());
  const TrailNetwork network = scene.trails();
  CHECK(points_within(network) == 0);
  // The whole way around is one trail.
  REQUIRE(!network.routes.empty());
  CHECK(network.routes.front().length > 1050);
  for (const DailyPlan& plan : scene.plans_on(network)) {
    for (const auto& point : plan.way) CHECK(distance_to(corridor, point.at) >= 2.4);
  }
}

TEST_CASE("a forbidden corridor across the only gap is crossed by herds, without a trail") {
  const std::vector<PathPoint> corridor{{60, 30}, {60, 50}};
  MovementScene scene = pasture(35, 45);
  place(scene, {{}, {}, {}, {}, {{corridor, 25}}});
  settle(scene, water_and_meadow());
  const TrailNetwork network = scene.trails();
  bool west = false;
  bool east = false;
  for (const TrailRoute& route : network.routes) {
    for (const PathPoint& p : route.points) {
      CHECK(distance_to(corridor, p) >= 2.4);
      west = west || p.x < 55;
      east = east || p.x > 65;
    }
  }
  CHECK(west);
  CHECK(east);
  int crossings = 0;
  for (const DailyPlan& plan : scene.plans_on(network)) {
    for (std::size_t i = 1; i < plan.way.size(); ++i) crossings += (plan.way[i - 1].at.x < 60) != (plan.way[i].at.x < 60);
  }
  CHECK(crossings >= 12);
}

TEST_CASE("a bent trail: the new line is walked, the old one is gone, and both join") {
  MovementScene scene = pasture();
  settle(scene, water_and_meadow());
  const TrailNetwork before = scene.trails();
  const auto& old = before.routes.front().points;
  const std::size_t third = old.size() / 3;
  const std::vector<PathPoint> stretch(old.begin() + std::ptrdiff_t(third), old.begin() + std::ptrdiff_t(2 * third));
  const PathPoint middle = stretch[stretch.size() / 2];
  const std::vector<PathPoint> bend{stretch.front(), {middle.x, middle.y + 18}, stretch.back()};
  place(scene, {{}, {}, {}, {{bend, 50000}}, {{stretch, 25}}});
  settle(scene, water_and_meadow());
  const TrailNetwork network = scene.trails();
  REQUIRE(network.routes.front().pinned == 0);
  CHECK(network.routes.front().weight[network.routes.front().weight.size() / 2] > 1e6F);
  CHECK(network.wear(int(std::lround(middle.x)), int(std::lround(middle.y))) == 0);
  // On both sides a trail begins on the line that was drawn.
  int joined = 0;
  for (std::size_t r = 1; r < network.routes.size(); ++r) {
    for (const PathPoint end : {network.routes[r].points.front(), network.routes[r].points.back()}) {
      joined += distance_to(network.routes.front().points, end) < 0.5;
    }
  }
  CHECK(joined >= 2);
  CHECK(share_walked_near(scene, scene.plans_on(network), network.routes.front().points, 1.5) > 0.25);
}

TEST_CASE("waypoints get their attraction, together at most half, and the rest is as it was (eq. 1)") {
  MovementScene scene = pasture();
  auto nodes = water_and_meadow();
  const auto without = presence_in_region(scene.web, scene.level(1, nodes), 0, 0);
  nodes.push_back(MovementScene::node(NodeKind::waypoint, 60, 10, 100, 0));
  nodes.push_back(MovementScene::node(NodeKind::waypoint, 60, 70, 100, 0));
  nodes[2].attraction = 0.2F;
  nodes[3].attraction = 0.1F;
  auto presence = presence_in_region(scene.web, scene.level(1, nodes), 0, 0);
  REQUIRE(presence.size() == 4);
  CHECK(presence[2].probability == Approx(0.2));
  CHECK(presence[3].probability == Approx(0.1));
  CHECK(presence[0].probability == Approx(0.7 * double(without[0].probability)));
  CHECK(presence[1].probability == Approx(0.7 * double(without[1].probability)));
  nodes[2].attraction = 0.9F;
  nodes[3].attraction = 0.3F;
  presence = presence_in_region(scene.web, scene.level(1, nodes), 0, 0);
  CHECK(presence[2].probability == Approx(0.375));
  CHECK(presence[3].probability == Approx(0.125));
  CHECK(presence[0].probability == Approx(0.5 * double(without[0].probability)));
}

TEST_CASE("a waypoint in an empty meadow gets a trail, and herds call there as often as it attracts them") {
  MovementScene scene = pasture();
  auto nodes = water_and_meadow();
  nodes.push_back(MovementScene::node(NodeKind::waypoint, 70, 72, 100, 0));
  nodes.back().attraction = 0.3F;
  settle(scene, nodes, 60);
  const TrailNetwork network = scene.trails();
  double nearest = 1e9;
  for (const TrailRoute& route : network.routes) {
    for (const PathPoint& p : route.points) nearest = std::min(nearest, std::hypot(double(p.x) - 70, double(p.y) - 72));
  }
  CHECK(nearest < 3);
  int calling = 0;
  for (const DailyPlan& plan : scene.plans_on(network)) {
    for (const PlanStop& stop : plan.stops) {
      if (stop.node != 2) continue;
      ++calling;
      CHECK(double(stop.leave - stop.arrive) > 0.24);
      CHECK(double(stop.leave - stop.arrive) < 0.51);
      const HerdState there = herd_state(plan, *scene.levels[0]->graph, 0.5 * double(stop.arrive + stop.leave), 10);
      CHECK(there.activity == HerdActivity::resting);
      CHECK(std::hypot(double(there.at.x) - 70, double(there.at.y) - 72) < 1);
    }
  }
  // 60 draws of 0.3: 18, within three deviations.
  CHECK(calling >= 8);
  CHECK(calling <= 28);
}

TEST_CASE("whatever is placed, a cache changes nothing, nor does the number of threads") {
  MovementScene scene = pasture(20, 60);
  auto nodes = water_and_meadow();
  nodes.push_back(MovementScene::node(NodeKind::vegetation, 90, 15, 40000, 4000));
  MovementCache cache;
  Places places;
  for (std::uint64_t round = 0; round < 14; ++round) {
    const auto point = [&](std::uint64_t i) {
      return PathPoint{float(random_int(-5, 125, {round, i, 1})), float(random_int(-5, 85, {round, i, 2}))};
    };
    switch (random_int(0, 4, {round, 3})) {
      case 0:
        places.pinned_trails.push_back({{point(1), point(2), point(3)}, 60000});
        break;
      case 1:
        places.forbidden_trails.push_back({{point(1), point(2)}, float(random_int(1, 60, {round, 4}))});
        break;
      case 2:
        if (!places.pinned_trails.empty()) places.pinned_trails.erase(places.pinned_trails.begin());
        break;
      case 3:
        if (!places.forbidden_trails.empty()) places.forbidden_trails.pop_back();
        break;
      default:
        nodes.push_back(
            MovementScene::node(NodeKind::waypoint, random_int(1, 58, {round, 5}), random_int(1, 78, {round, 6}), 100, 0));
        nodes.back().attraction = 0.2F;
    }
    place(scene, places);
    settle(scene, nodes);
    const auto cached = compute_level_movement(scene.web, *scene.levels[0], scene.ground, {}, &cache);
    REQUIRE(cached);
    CHECK(cached->travel->onward == scene.movement[0].travel->onward);
    CHECK(cached->travel->placed_cost == scene.movement[0].travel->placed_cost);
    REQUIRE(cached->edges.size() == scene.movement[0].edges.size());
    for (std::size_t i = 0; i < cached->edges.size(); ++i)
      REQUIRE(cached->edges[i].seconds == scene.movement[0].edges[i].seconds);
    TrailNetwork fresh;
    {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
      fresh = scene.trails();
    }
    scene.movement = {*cached};
    CHECK(same(fresh, scene.trails(&cache)));
    std::size_t pinned = 0;
    for (const PinnedTrail& trail : places.pinned_trails) pinned += line_through(trail.points, 1, {0, 0, 120, 80}).size() > 1;
    CHECK(std::size_t(std::count_if(fresh.routes.begin(), fresh.routes.end(),
                                    [](const TrailRoute& r) { return r.pinned >= 0; })) == pinned);
  }
}
