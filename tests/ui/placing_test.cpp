#include "ui/placing.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "ui/chain_changes.hpp"
#include "ui/herd_day.hpp"

using namespace biotope;

namespace {

Terrain plain(int side) {
  Terrain terrain;
  terrain.height = Grid<float>(side, side, 100.0F);
  terrain.cell_size = 4;
  return terrain;
}

TrailRoute straight_route() {
  TrailRoute route;
  for (int i = 0; i <= 100; ++i) {
    route.points.push_back({float(i), 50});
    route.weight.push_back(2000);
  }
  return route;
}

}  // namespace

TEST_CASE("a placed thing is found at its point and removed with it") {
  const Terrain terrain = plain(64);
  PlacedThings things;
  for (int kind = 0; kind < placed_kinds; ++kind) {
    const auto placed = PlacedKind(kind);
    std::vector<PathPoint> points;
    for (std::size_t i = 0; i < least_points(placed); ++i) points.push_back({float(5 + 6 * kind), float(5 + 9 * i)});
    const PlacedItem item = add_thing(things, placed, points, terrain);
    CAPTURE(placed_name(placed));
    CHECK(count_of(things, placed) == 1);
    const auto handle = handle_near(things, points[0], 1);
    REQUIRE(handle);
    CHECK(handle->item == item);
  }
  for (int kind = 0; kind < placed_kinds; ++kind) remove_thing(things, {PlacedKind(kind), 0});
  CHECK(things.placements == Placements{});
  CHECK(things.inflows.empty());
}

TEST_CASE("a point moved off the map stays at its border") {
  const Terrain terrain = plain(64);
  PlacedThings things;
  const PlacedItem item = add_thing(things, PlacedKind::waypoint, {{10, 10}}, terrain);
  move_point(things, {item, 0, {10, 10}}, {-40, 200}, terrain);
  CHECK(points_of(things, item).front() == PathPoint{0, 63});
}

TEST_CASE("a line that loses too many points is gone; an added point lies between its neighbours") {
  const Terrain terrain = plain(64);
  PlacedThings things;
  const PlacedItem item = add_thing(things, PlacedKind::river, {{5, 5}, {25, 5}, {45, 5}}, terrain);
  insert_point(things, item, {35, 8});
  CHECK(points_of(things, item) == std::vector<PathPoint>{{5, 5}, {25, 5}, {35, 8}, {45, 5}});
  remove_point(things, {item, 2, {}});
  remove_point(things, {item, 1, {}});
  CHECK(points_of(things, item) == std::vector<PathPoint>{{5, 5}, {45, 5}});
  remove_point(things, {item, 0, {}});
  CHECK(count_of(things, PlacedKind::river) == 0);
}

TEST_CASE("a bent trail goes through the pointer and leaves the rest of the way as it was") {
  const TrailRoute route = straight_route();
  TrailNetwork trails;
  trails.routes.push_back(route);
  const TrailBend bend = bent(stretch_around(trails, {0, 50}, 4, 120), {50, 40}, 4, 120);
  REQUIRE(bend.after.size() == bend.before.size());
  CHECK(bend.after.front() == bend.before.front());
  CHECK(bend.after.back() == bend.before.back());
  bool through = false;
  for (const PathPoint& point : bend.after) through |= point == PathPoint{50, 40};
  CHECK(through);

  PlacedThings things;
  place_bend(things, bend, 4);
  REQUIRE(things.placements.places.pinned_trails.size() == 1);
  REQUIRE(things.placements.places.forbidden_trails.size() == 1);
  // The new way's middle is free of the forbidden corridor.
  const ForbiddenTrail& forbidden = things.placements.places.forbidden_trails.front();
  for (const PathPoint& old : forbidden.points) CHECK(std::hypot(old.x - 50, old.y - 40) * 4 > forbidden.radius);
}

TEST_CASE("a bend at the end of a route goes on along the one that continues it") {
  TrailNetwork trails;
  trails.routes.push_back(straight_route());
  TrailRoute on;
  TrailRoute aside;
  for (int i = 0; i <= 60; ++i) {
    on.points.push_back({100 + float(i), 50 + 0.1F * float(i)});
    aside.points.push_back({100, 50 + float(i)});
  }
  trails.routes.push_back(aside);
  trails.routes.push_back(on);
  const TrailStretch stretch = stretch_around(trails, {0, 98}, 4, 120);
  CHECK(stretch.points[stretch.grip] == PathPoint{98, 50});
  CHECK(stretch.points.back() == on.points.back());
}

TEST_CASE("the hours of a stop stay between its neighbours") {
  PlanEdit day{"deer", {0, 0}, 0, {{{1, 1}, 6, 8}, {{5, 5}, 10, 12}, {{9, 9}, 15, 20}}};
  set_hours(day, 1, 3, 30);
  CHECK(day.stops[1].arrive == 8);
  CHECK(day.stops[1].leave == 15);
  add_stop(day, {3, 3}, 16);
  REQUIRE(day.stops.size() == 4);
  CHECK(day.stops[3].arrive == 16);
  for (std::size_t i = 1; i < day.stops.size(); ++i) CHECK(day.stops[i].arrive >= day.stops[i - 1].leave);
  const PlanEdit before = day;
  swap_stops(day, 0, 2);
  CHECK(day.stops[0].at == before.stops[2].at);
  CHECK(day.stops[0].arrive == before.stops[0].arrive);
}

TEST_CASE("an edit is told against what was before it, however many answers come in between") {
  const auto figures = [](double amount) { return std::vector<SpeciesFigures>{{amount, 10, 4, 0, 0, 1, 1}}; };
  ChainChanges changes;
  CHECK_FALSE(changes.follow(figures(100), 1, 1, false));
  CHECK_FALSE(changes.follow(figures(90), 2, 3, true));
  CHECK(changes.changes().front().amount == Approx(-0.1));
  CHECK(changes.follow(figures(82), 3, 3, false));
  CHECK(changes.changes().front().amount == Approx(-0.18));
  CHECK(format_change(changes.changes().front().amount) == "-18 %");
  CHECK(changes.follow(figures(82), 4, 4, false));
  CHECK(changes.changes().empty());
}

TEST_CASE("a change of surplus is told against what grew, however little was left over") {
  const std::vector<SpeciesFigures> before{{100, 1000, 999, 0, 0, 1, 1}};
  const std::vector<SpeciesFigures> after{{100, 1000, 960, 0, 0, 1, 1}};
  const auto changes = changes_between(before, after);
  REQUIRE(changes.size() == 1);
  CHECK(changes.front().surplus == Approx(0.039));
}
