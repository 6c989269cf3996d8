#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/base/random.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

const Mobility plain{0.5F, 0.5F, 0.6F, 3.5F};

Ground with_passage(Ground ground, const Rect& rect, float value, float coverage = 1) {
  const auto& height = ground.terrain->height;
  ground.passage = paint_rect(height.width(), height.height(), rect, value, coverage);
  return ground;
}

Ground with_places(Ground ground, Places places) {
  ground.places = std::make_shared<const Places>(std::move(places));
  return ground;
}

}  // namespace

TEST_CASE("a wall painted across a plane makes two regions, and a passage painted through it joins them") {
  const Ground open = Landscape(70, 20).ground();
  const Ground walled = with_passage(open, {30, 0, 33, 20}, 1);
  const ConfinementRegions two = confinement_regions(walled, plain);
  REQUIRE(two.regions.size() == 2);
  CHECK(two.label(31, 5) == -1);
  Ground gate = walled;
  PaintLayer paint = *walled.passage;
  for (int x = 30; x < 33; ++x) paint.set(x, 7, {0, 0});
  gate.passage = std::make_shared<const PaintLayer>(paint);
  CHECK(confinement_regions(gate, plain).regions.size() == 1);
}

TEST_CASE("a painted passage opens cliffs, deep water and dense wood; half-hearted paint does nothing") {
  Landscape land(70, 20);
  land.cliff_column(20);
  land.river_column(21, 3);
  for (int y = 0; y < 20; ++y) land.trees(22, y) = full_cover;
  const Ground ground = land.ground();
  CHECK(confinement_regions(ground, plain).regions.size() == 2);
  CHECK(confinement_regions(with_passage(ground, {20, 4, 23, 5}, -1), plain).regions.size() == 1);
  CHECK(confinement_regions(with_passage(ground, {20, 4, 23, 5}, -1, 0.4F), plain).regions.size() == 2);
  CHECK(confinement_regions(with_passage(Landscape(70, 20).ground(), {20, 0, 23, 20}, 1, 0.4F), plain).regions.size() == 1);
}

TEST_CASE("a ford placed in a deep river joins the banks, but opens neither cliff nor wood") {
  Landscape land(60, 30, 5);
  for (int x = 28; x < 32; ++x) land.river_column(x, 2, 50);
  const Places ford{{{{29.5F, 12}, 12}}, {}, {}, {}, {}};
  CHECK(confinement_regions(land.ground(), plain).regions.size() == 2);
  const ConfinementRegions joined = confinement_regions(with_places(land.ground(), ford), plain);
  CHECK(joined.regions.size() == 1);
  CHECK(joined.label(29, 12) == 0);
  CHECK(joined.label(29, 20) == -1);
  for (int y = 0; y < 30; ++y) land.trees(30, y) = full_cover;
  CHECK(confinement_regions(with_places(land.ground(), ford), plain).regions.size() == 2);
  land.trees = Grid<Cover>(60, 30);
  land.cliff_column(30);
  CHECK(confinement_regions(with_places(land.ground(), ford), plain).regions.size() == 2);
}

TEST_CASE("within an exit nothing blocks, not even paint") {
  Landscape land(60, 30, 5);
  land.cliff_column(30);
  Ground ground = with_passage(land.ground(), {28, 0, 33, 30}, 1);
  CHECK(obstacle_at(ground, plain, 30, 15) == Obstacle::painted);
  ground = with_places(ground, {{}, {{{30, 15}, 20}}, {}, {}, {}});
  CHECK(obstacle_at(ground, plain, 30, 15) == Obstacle::none);
  CHECK(obstacle_at(ground, plain, 30, 20) == Obstacle::painted);
  CHECK(confinement_regions(ground, plain).regions.size() == 1);
}

TEST_CASE("a place smaller than a cell opens the cell it lies in, one outside the map opens nothing") {
  Landscape land(20, 20, 100);
  land.river_column(10, 2);
  CHECK(confinement_regions(with_places(land.ground(), {{{{10.4F, 5.4F}, 3}}, {}, {}, {}, {}}), plain).regions.size() == 1);
  CHECK(confinement_regions(with_places(land.ground(), {{{{10, -50}, 3}, {{1000, 1e9F}, 100}}, {}, {}, {}, {}}), plain)
            .regions.size() == 2);
}

TEST_CASE("the obstacle at a cell, blocked cells and regions tell the same of any ground") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Landscape land(150, 70, 20);
    PaintLayer paint(150, 70);
    for (int y = 0; y < 70; ++y) {
      for (int x = 0; x < 150; ++x) {
        const auto chance = [&](std::uint64_t what) {
          return float(random_unit({seed, what, std::uint64_t(x / 3), std::uint64_t(y / 3)}));
        };
        land.derivatives.slope(x, y) = chance(1);
        land.hydrology.water_depth(x, y) = chance(2) > 0.7F ? 2.0F : 0.0F;
        land.trees(x, y) = to_cover(chance(3));
        if (x < 100 && chance(4) > 0.7F) paint.set(x, y, {2 * chance(5) - 1, chance(6)});
      }
    }
    land.hydrology.fords.push_back({40, 40, 0.3F});
    Ground ground = land.ground();
    ground.passage = std::make_shared<const PaintLayer>(paint);
    ground = with_places(ground, {{{{20.5F, 30}, 90}}, {{{60, 10}, 70}, {{149, 69}, 50}}, {}, {}, {}});
    const Grid<std::uint8_t> blocked = blocked_cells(ground, plain);
    CHECK(confinement_regions(ground, plain).label == confinement_regions(blocked, 20).label);
    for (int y = 0; y < 70; y += 2) {
      for (int x = 0; x < 150; x += 3) CHECK((obstacle_at(ground, plain, x, y) != Obstacle::none) == (blocked(x, y) != 0));
    }
  }
}

TEST_CASE("changes of passages, fords and exits are noticed, and only those that bar or open a way") {
  const Ground ground = Landscape(200, 20).ground();
  const Ground walled = with_passage(ground, {30, 0, 33, 20}, 1);
  CHECK_FALSE(same_blocked_cells(ground, walled, plain));
  CHECK_FALSE(same_blocked_cells(walled, ground, plain));
  Ground touched = walled;
  PaintLayer paint = *walled.passage;
  paint.set(150, 3, {0.3F, 1});
  paint.set(31, 3, {0.9F, 1});
  touched.passage = std::make_shared<const PaintLayer>(paint);
  CHECK(same_blocked_cells(walled, touched, plain));
  paint.set(150, 3, {-0.6F, 1});
  touched.passage = std::make_shared<const PaintLayer>(paint);
  CHECK_FALSE(same_blocked_cells(walled, touched, plain));
  CHECK(same_blocked_cells(ground, with_places(ground, {{}, {}, {{{3, 3}, 1}}, {}, {}}), plain));
  CHECK_FALSE(same_blocked_cells(ground, with_places(ground, {{{{3, 3}, 12}}, {}, {}, {}, {}}), plain));
  CHECK_FALSE(same_blocked_cells(ground, with_places(ground, {{}, {{{3, 3}, 12}}, {}, {}, {}}), plain));
}
