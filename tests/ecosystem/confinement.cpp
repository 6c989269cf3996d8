#include "core/ecosystem/confinement.hpp"

#include <catch2/catch.hpp>

#include "animal_scene.hpp"
#include "core/base/random.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

const Mobility plain{0.5F, 0.5F, 0.6F, 3.5F};

}  // namespace

TEST_CASE("a cliff from edge to edge splits the ground into two regions") {
  Landscape land(11, 4);
  land.cliff_column(5);
  const ConfinementRegions regions = confinement_regions(land.ground(), plain);
  REQUIRE(regions.regions.size() == 2);
  CHECK(regions.label(0, 0) == 0);
  CHECK(regions.label(10, 3) == 1);
  CHECK(regions.label(5, 2) == -1);
  CHECK(regions.regions[0].cells == 20);
  CHECK(regions.regions[0].area == Approx(20 * 100 * 100));
  CHECK(regions.regions[1].bounds == Rect{6, 0, 11, 4});
}

TEST_CASE("an animal as steep-footed as the cliff is not confined by it") {
  Landscape land(11, 4);
  land.cliff_column(5, 0.5F);
  CHECK(confinement_regions(land.ground(), plain).regions.size() == 1);
}

TEST_CASE("deep water confines, shallow water does not") {
  Landscape land(11, 4);
  land.river_column(5, 0.9F);
  CHECK(confinement_regions(land.ground(), plain).regions.size() == 2);
  Mobility swimmer = plain;
  swimmer.wade_depth = 1;
  CHECK(confinement_regions(land.ground(), swimmer).regions.size() == 1);
}

TEST_CASE("a ford joins the banks of a river many cells wide") {
  Landscape land(60, 40, 4);
  for (int x = 25; x < 33; ++x) land.river_column(x, 2, 50);
  CHECK(confinement_regions(land.ground(), plain).regions.size() == 2);
  land.hydrology.fords.push_back({28, 20, 0.4F});
  const ConfinementRegions joined = confinement_regions(land.ground(), plain);
  CHECK(joined.regions.size() == 1);
  CHECK(joined.label(29, 20) == 0);
  CHECK(joined.label(29, 0) == -1);
}

TEST_CASE("a ford does not open a cliff") {
  Landscape land(11, 11);
  land.cliff_column(5);
  land.hydrology.fords.push_back({5, 5, 0.1F});
  CHECK(confinement_regions(land.ground(), plain).regions.size() == 2);
}

TEST_CASE("trees denser than the limit confine, and cover at the limit does not") {
  Landscape land(3, 3);
  land.trees(1, 1) = to_cover(0.6F);
  land.trees(2, 2) = Cover(to_cover(0.6F) + 1);
  const Grid<std::uint8_t> blocked = blocked_cells(land.ground(), plain);
  CHECK(blocked(1, 1) == 0);
  CHECK(blocked(2, 2) == 1);
}

TEST_CASE("diagonal neighbours do not connect") {
  Grid<std::uint8_t> blocked(2, 2, 1);
  blocked(0, 0) = 0;
  blocked(1, 1) = 0;
  CHECK(confinement_regions(blocked, 100).regions.size() == 2);
}

TEST_CASE("regions below a hectare hold nobody, and one cell is enough where cells are larger") {
  Grid<std::uint8_t> blocked(12, 10, 0);
  for (int y = 0; y < 10; ++y) blocked(10, y) = 1;
  // 10 m cells: the west is exactly 1 ha, the east 0.1 ha.
  const ConfinementRegions fine = confinement_regions(blocked, 10);
  REQUIRE(fine.regions.size() == 1);
  CHECK(fine.label(11, 0) == -1);
  CHECK(confinement_regions(blocked, 150).regions.size() == 2);
}

TEST_CASE("regions are numbered by their first cell in row order") {
  Grid<std::uint8_t> blocked(5, 3, 0);
  // A region that starts in the second row, another that wraps around it from the first.
  for (const auto& [x, y] : {std::pair{1, 1}, {2, 0}, {3, 1}, {2, 2}}) blocked(x, y) = 1;
  const ConfinementRegions regions = confinement_regions(blocked, 100);
  CHECK(regions.label(0, 0) == 0);
  CHECK(regions.label(3, 0) == 1);
  CHECK(regions.label(2, 1) == 2);
}

TEST_CASE("regions agree with a flood fill on random ground, and blocked cells with the ground they come from") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Landscape land(57, 43);
    for (int y = 0; y < 43; ++y) {
      for (int x = 0; x < 57; ++x) land.derivatives.slope(x, y) = float(random_unit({seed, std::uint64_t(x), std::uint64_t(y)}));
    }
    Mobility mobility = plain;
    mobility.max_slope = 0.6F;
    const Grid<std::uint8_t> blocked = blocked_cells(land.ground(), mobility);
    const ConfinementRegions regions = confinement_regions(blocked, 100);
    CHECK(regions.label == confinement_regions(land.ground(), mobility).label);
    Grid<std::int32_t> expected(57, 43, -1);
    std::int32_t next = 0;
    for (int y = 0; y < 43; ++y) {
      for (int x = 0; x < 57; ++x) {
        if (blocked(x, y) != 0 || expected(x, y) >= 0) continue;
        std::vector<std::pair<int, int>> open{{x, y}};
        expected(x, y) = next;
        while (!open.empty()) {
          const auto [cx, cy] = open.back();
          open.pop_back();
          for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            if (!blocked.contains(cx + dx, cy + dy) || blocked(cx + dx, cy + dy) != 0 || expected(cx + dx, cy + dy) >= 0)
              continue;
            expected(cx + dx, cy + dy) = next;
            open.emplace_back(cx + dx, cy + dy);
          }
        }
        ++next;
      }
    }
    REQUIRE(regions.label == RunMap(expected));
    std::size_t cells = 0;
    for (const auto& region : regions.regions) cells += region.cells;
    CHECK(cells == std::size_t(std::count(blocked.cells().begin(), blocked.cells().end(), 0)));
  }
}

TEST_CASE("the obstacle named at a cell is the one that blocks it") {
  Landscape land(4, 1);
  land.derivatives.slope(0, 0) = 1;
  land.hydrology.water_depth(1, 0) = 1;
  land.trees(2, 0) = full_cover;
  const Ground ground = land.ground();
  CHECK(obstacle_at(ground, plain, 0, 0) == Obstacle::slope);
  CHECK(obstacle_at(ground, plain, 1, 0) == Obstacle::deep_water);
  CHECK(obstacle_at(ground, plain, 2, 0) == Obstacle::trees);
  CHECK(obstacle_at(ground, plain, 3, 0) == Obstacle::none);
}

TEST_CASE("regions that take over rows of an earlier ground are those found anew") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Landscape land(90, 70, 20);
    const auto chance = [&](std::uint64_t step, std::uint64_t what, int most) { return random_int(0, most, {seed, step, what}); };
    for (int x = 40; x < 47; ++x) land.river_column(x, 2, 30);
    Ground before = land.ground();
    auto regions = std::make_shared<const ConfinementRegions>(confinement_regions(before, plain));
    int kept = 0;
    for (std::uint64_t step = 0; step < 20; ++step) {
      const int x = chance(step, 1, 89);
      const int y = chance(step, 2, 69);
      const int kind = chance(step, 3, 5);
      for (int cx = std::max(0, x - 9); cx < std::min(90, x + 9); ++cx) {
        if (kind == 0) land.derivatives.slope(cx, y) = 2;
        if (kind == 1) land.hydrology.water_depth(cx, y) = 0;
        if (kind == 2) land.trees(cx, y) = full_cover;
        if (kind == 3) land.terrain.height(cx, y) += 5;
      }
      if (kind == 4) land.hydrology.fords.push_back({43, y, 0.3F});
      if (kind == 5 && !land.hydrology.fords.empty()) land.hydrology.fords.pop_back();
      const Ground now = land.ground();
      const auto next = confinement_regions(now, plain, rows_of_other_obstacles(before, now), regions);
      const ConfinementRegions anew = confinement_regions(now, plain);
      INFO("seed " << seed << ", step " << step);
      REQUIRE(next->label == anew.label);
      REQUIRE(*next->passable == *anew.passable);
      REQUIRE(next->regions.size() == anew.regions.size());
      kept += next == regions;
      regions = next;
      before = now;
    }
    CHECK(kept > 0);
    CHECK(kept < 20);
  }
}
