#include "core/terrain/shaping.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/terrain/synthetic.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

Hydrology water_on(const Terrain& land, const DrawnWater& drawn) {
  HydrologyOptions options;
  options.inflows = inflows_of(drawn, land, options.runoff);
  return water_of(land, options);
}

/// Largest part of the course's points that lie farther than `cells` from a cell that carries at least `discharge`.
double share_off_channel(const Hydrology& water, const DrawnRiver& river, float discharge, int cells = 2) {
  const auto line = smooth_line(river.course, false);
  int off = 0;
  for (const PathPoint& point : line) {
    const int x = int(std::floor(point.x + 0.5F));
    const int y = int(std::floor(point.y + 0.5F));
    bool found = false;
    for (int dy = -cells; dy <= cells; ++dy) {
      for (int dx = -cells; dx <= cells; ++dx) {
        if (water.discharge.contains(x + dx, y + dy)) found |= water.discharge(x + dx, y + dy) >= discharge;
      }
    }
    off += found ? 0 : 1;
  }
  return double(off) / double(line.size());
}

/// Whether the water of the head cell comes by within so many cells of the last point.
bool head_reaches_end(const Hydrology& water, const DrawnWater& drawn, const Terrain& land, double cells) {
  const Inflow head = inflows_of(drawn, land, 0.3).front();
  const PathPoint end = drawn.rivers.front().course.back();
  const int dx[8] = {1, 1, 0, -1, -1, -1, 0, 1};
  const int dy[8] = {0, 1, 1, 1, 0, -1, -1, -1};
  int x = head.x;
  int y = head.y;
  while (true) {
    if (std::hypot(double(x) - double(end.x), double(y) - double(end.y)) <= cells) return true;
    const std::uint8_t receiver = water.receiver(x, y);
    if (receiver > 7) return false;
    x += dx[receiver];
    y += dy[receiver];
  }
}

DrawnWater one_river(std::vector<PathPoint> course, double discharge) { return {{{std::move(course), discharge}}, {}}; }

/// A river that winds from the north-west to the south-east of a map.
DrawnWater winding_river(float size, double discharge) {
  return one_river({{0.15F * size, 0.1F * size},
                    {0.4F * size, 0.3F * size},
                    {0.3F * size, 0.55F * size},
                    {0.6F * size, 0.6F * size},
                    {0.75F * size, 0.85F * size}},
                   discharge);
}

DrawnWater one_lake(float x, float y, float radius, float depth) {
  DrawnLake lake;
  for (int i = 0; i < 8; ++i) {
    const float angle = float(i) * 0.785398F;
    lake.shore.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  lake.depth = depth;
  return {{}, {lake}};
}

/// How a marked lake compares with the circle that was drawn.
struct LakeCheck {
  int inside_dry = 0;   ///< cells well inside that are not lake
  int outside_wet = 0;  ///< cells outside that are
  float deepest = 0;
};
LakeCheck check_lake(const Hydrology& water, float cx, float cy, float radius) {
  LakeCheck check;
  for (int y = 0; y < water.water.height(); ++y) {
    for (int x = 0; x < water.water.width(); ++x) {
      const float distance = std::hypot(float(x) - cx, float(y) - cy);
      const bool lake = water.water(x, y) == WaterKind::lake;
      if (distance < radius - 3 && !lake) ++check.inside_dry;
      if (distance > radius + 1 && lake) ++check.outside_wet;
      if (lake) check.deepest = std::max(check.deepest, water.water_depth(x, y));
    }
  }
  return check;
}

Terrain plane(int size, double cell) {
  return ground(size, size, cell, [](double, double) { return 100.0; });
}
Terrain slope(int size, double cell, double east, double north) {
  return ground(size, size, cell, [=](double x, double y) { return 100 + east * x + north * y; });
}

/// A slope with cell-sized noise of 40 cm.
Terrain noisy_slope(int size, double cell) {
  return ground(size, size, cell, [=](double x, double y) {
    return 100 + 0.03 * x - 0.02 * y + 0.4 * random_unit({7, std::uint64_t(x / cell + 0.5), std::uint64_t(y / cell + 0.5)});
  });
}

}  // namespace

TEST_CASE("where nothing is painted or drawn the ground is the terrain") {
  const Terrain rough = rough_ground(70, 50, 5, 3);
  const PaintLayer bare(70, 50);
  CHECK(shaped_terrain(rough, nullptr, {}).height == rough.height);
  CHECK(shaped_terrain(rough, &bare, {}).height == rough.height);
  CHECK(inflows_of({}, rough, 0.3).empty());
}

TEST_CASE("painted heights lie over the terrain by their coverage") {
  const Terrain flat = plane(80, 5);
  PaintLayer paint(80, 80);
  paint.set(70, 3, {120, 1});
  paint.set(71, 3, {120, 0.25F});
  const Terrain land = shaped_terrain(flat, &paint, {});
  CHECK(land.height(70, 3) == 120);
  CHECK(land.height(71, 3) == 105);
  CHECK(land.height(72, 3) == 100);
}

TEST_CASE("a smooth line goes through its points in small steps, and a closed one comes back") {
  const std::vector<PathPoint> points{{0, 0}, {10, 0}, {10, 10}, {40, 12}};
  for (const bool closed : {false, true}) {
    const auto line = smooth_line(points, closed);
    for (const PathPoint& point : points) CHECK(std::find(line.begin(), line.end(), point) != line.end());
    CHECK(line.front() == points.front());
    CHECK(line.back() == (closed ? points.front() : points.back()));
    for (std::size_t i = 1; i < line.size(); ++i) CHECK(std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y) <= 0.6F);
  }
  CHECK(smooth_line({}, true).empty());
  CHECK(smooth_line(std::vector<PathPoint>{{1, 1}, {1, 1}}, false).size() == 1);
}

TEST_CASE("a drawn river runs from its head to its last point: on a plane, up, down and across a slope, on noisy ground") {
  for (const double discharge : {0.3, 5.0, 40.0}) {
    for (const double cell : {2.0, 10.0}) {
      const std::vector<Terrain> grounds{plane(120, cell),           slope(120, cell, 0, 0.05),      slope(120, cell, 0.1, 0.02),
                                         slope(120, cell, -0.05, 0), slope(120, cell, -0.02, -0.05), noisy_slope(120, cell)};
      for (std::size_t i = 0; i < grounds.size(); ++i) {
        const DrawnWater drawn = winding_river(120, discharge);
        const Terrain land = shaped_terrain(grounds[i], nullptr, drawn);
        const Hydrology water = water_on(land, drawn);
        INFO("discharge " << discharge << ", cell " << cell << ", ground " << i);
        const double half = double(river_width(float(discharge))) / 2 / cell;
        CHECK(share_off_channel(water, drawn.rivers[0], float(discharge) * 0.999F, int(half) + 2) == 0);
        CHECK(head_reaches_end(water, drawn, land, half + 2));
        CHECK(std::none_of(water.water.cells().begin(), water.water.cells().end(),
                           [](WaterKind kind) { return kind == WaterKind::lake; }));
      }
    }
  }
}

TEST_CASE("a bed never rises along the course and is as wide as its river") {
  const Terrain land = shaped_terrain(slope(100, 2, 0, 0.03), nullptr, one_river({{20, 10}, {60, 50}, {50, 90}}, 10));
  const std::vector<PathPoint> points{{20, 10}, {60, 50}, {50, 90}};
  float before = 1e9F;
  for (const PathPoint& point : smooth_line(points, false)) {
    const float bed = land.height(int(std::floor(point.x + 0.5F)), int(std::floor(point.y + 0.5F)));
    CHECK(bed <= before + 0.12F);
    before = bed;
  }
  // Across a straight canal in the plane: 14.2 m of bed, then banks of 45 degrees.
  const DrawnWater canal = one_river({{5, 50}, {95, 50}}, 10);
  const Terrain dug = shaped_terrain(plane(100, 1), nullptr, canal);
  const float depth = river_depth(10);
  int bed_cells = 0;
  for (int y = 0; y < 100; ++y) bed_cells += dug.height(30, y) < 100 - 0.8F * depth ? 1 : 0;
  CHECK(bed_cells == Approx(double(river_width(10))).margin(2));
  CHECK(dug.height(30, 50) <= 100 - depth);
  CHECK(dug.height(30, 50) > 100 - depth - 0.05F);
}

TEST_CASE("banks of a canyon rise at most 1 : 1") {
  // A ridge across the course: the bed cuts through 30 m of it.
  const Terrain ridge = ground(120, 80, 2, [](double x, double) { return 100 + 30 * std::exp(-(x - 120) * (x - 120) / 3000); });
  const Terrain land = shaped_terrain(ridge, nullptr, one_river({{5, 40}, {115, 40}}, 4));
  CHECK(land.height(60, 40) < 100);
  for (int y = 1; y < 80; ++y) CHECK(std::abs(land.height(60, y) - land.height(60, y - 1)) <= 2.01F);
}

TEST_CASE("water enters at the head with the discharge that was drawn") {
  const DrawnWater drawn = one_river({{30, 30}, {60, 60}}, 3);
  const Terrain land = shaped_terrain(slope(100, 5, 0, 0.05), nullptr, drawn);
  const auto inflows = inflows_of(drawn, land, 0.4);
  REQUIRE(inflows.size() == 1);
  CHECK(inflows[0].x == 30);
  CHECK(inflows[0].y == 30);
  CHECK(mean_discharge(inflows[0].catchment_area, 0.4) == Approx(3));
  CHECK(inflows_of(drawn, land, 0).empty());
  // A head outside the map: the water enters where the course does.
  const auto outside = inflows_of(one_river({{50, -20}, {50, 80}}, 3), land, 0.4);
  REQUIRE(outside.size() == 1);
  CHECK(outside[0].y == 0);
}

TEST_CASE("a drawn lake is a lake with its shore and depth: on a plane, a slope and noisy ground") {
  const std::vector<Terrain> grounds{plane(120, 5), slope(120, 5, 0.05, 0.02), slope(120, 5, -0.2, 0), noisy_slope(120, 5)};
  for (std::size_t i = 0; i < grounds.size(); ++i) {
    const DrawnWater drawn = one_lake(60, 55, 30, 4);
    const Terrain land = shaped_terrain(grounds[i], nullptr, drawn);
    const Hydrology water = water_on(land, drawn);
    const LakeCheck check = check_lake(water, 60, 55, 30);
    INFO("ground " << i);
    CHECK(check.inside_dry == 0);
    CHECK(check.outside_wet == 0);
    CHECK(check.deepest == Approx(4).margin(0.1));
  }
}

TEST_CASE("a pond that a person drew is a lake, however small and shallow") {
  const DrawnWater drawn = one_lake(60, 55, 4, 0.3F);
  const Terrain land = shaped_terrain(noisy_slope(120, 5), nullptr, drawn);
  HydrologyOptions options;
  CHECK(check_lake(*compute_hydrology(land, options), 60, 55, 4).deepest == 0);
  options.lake_cells = cells_of_lakes(drawn.lakes, land.height.rect());
  const LakeCheck check = check_lake(*compute_hydrology(land, options), 60, 55, 4);
  CHECK(check.inside_dry == 0);
  CHECK(check.outside_wet == 0);
  CHECK(check.deepest > 0.1F);
  CHECK(check.deepest <= 0.301F);
}

TEST_CASE("the floor of a lake falls gently from its shore") {
  const Terrain land = shaped_terrain(plane(120, 5), nullptr, one_lake(60, 60, 20, 30));
  // Too small for 30 m at 1 : 2.
  float lowest = 100;
  for (int y = 1; y < 120; ++y) {
    for (int x = 1; x < 120; ++x) {
      lowest = std::min(lowest, land.height(x, y));
      CHECK(std::abs(land.height(x, y) - land.height(x - 1, y)) <= 2.55F);
    }
  }
  CHECK(lowest < 80);
  CHECK(lowest > 65);
}

TEST_CASE("a river through a lake leaves the lake its level, and one that ends there ends") {
  DrawnWater drawn = one_lake(60, 60, 25, 4);
  drawn.rivers.push_back({{{60, 5}, {60, 60}, {62, 115}}, 6});
  const Terrain land = shaped_terrain(slope(120, 5, 0, 0.03), nullptr, drawn);
  const LakeCheck through = check_lake(water_on(land, drawn), 60, 60, 25);
  CHECK(through.inside_dry == 0);
  CHECK(through.deepest == Approx(4).margin(0.1));
  drawn.rivers[0].course = {{60, 5}, {60, 60}};
  const Terrain ended = shaped_terrain(slope(120, 5, 0, 0.03), nullptr, drawn);
  const LakeCheck into = check_lake(water_on(ended, drawn), 60, 60, 25);
  CHECK(into.inside_dry == 0);
  CHECK(into.outside_wet == 0);
}

TEST_CASE("a tributary joins the bed of the river it runs into") {
  DrawnWater drawn;
  drawn.rivers.push_back({{{60, 5}, {60, 115}}, 8});
  drawn.rivers.push_back({{{10, 30}, {60, 70}}, 1});
  const Terrain land = shaped_terrain(slope(120, 5, 0, 0.02), nullptr, drawn);
  const Hydrology water = water_on(land, drawn);
  CHECK(share_off_channel(water, drawn.rivers[0], 7.9F) == 0);
  CHECK(share_off_channel(water, drawn.rivers[1], 0.99F) == 0);
  float most = 0;
  for (int x = 0; x < 120; ++x) most = std::max(most, water.discharge(x, 100));
  CHECK(most == Approx(9).epsilon(0.02));
}

TEST_CASE("only the ground near what is drawn changes") {
  const Terrain rough = rough_ground(200, 200, 5, 7);
  DrawnWater drawn = one_lake(60, 60, 15, 3);
  drawn.rivers.push_back({{{100, 100}, {140, 130}}, 2});
  const Terrain land = shaped_terrain(rough, nullptr, drawn);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < land.height.size(); ++i) {
    changed += land.height[i] != rough.height[i] ? 1 : 0;
    CHECK(land.height[i] <= rough.height[i]);
  }
  CHECK(changed > 500);
  CHECK(changed < 6000);
  CHECK(land.height(5, 195) == rough.height(5, 195));
}

TEST_CASE("drawings outside the map, of one point or without water change nothing and do no harm") {
  const Terrain flat = plane(40, 5);
  DrawnWater drawn;
  drawn.rivers = {{{}, 1}, {{{5, 5}}, 1}, {{{-50, -50}, {-20, -70}}, 1}, {{{3, 3}, {3, 3}}, 1}};
  drawn.lakes = {{{}, 3}, {{{1, 1}, {5, 5}}, 3}, {{{100, 100}, {120, 100}, {110, 130}}, 3}, {{{10, 10}, {11, 10}, {11, 11}}, 3}};
  CHECK(shaped_terrain(flat, nullptr, drawn).height == flat.height);
  CHECK(inflows_of(drawn, flat, 0.3).size() == 2);
}

TEST_CASE("rivers and lakes drawn in the sample valley are there") {
  const auto sample = sample_landscape("valley");
  REQUIRE(sample);
  DrawnWater drawn;
  drawn.rivers.push_back({{{150, 200}, {260, 330}, {330, 450}, {420, 520}}, 0.8});
  drawn.lakes.push_back({{{700, 300}, {760, 290}, {790, 350}, {740, 390}, {690, 360}}, 5});
  const Terrain land = shaped_terrain(sample->terrain, nullptr, drawn);
  HydrologyOptions options;
  options.inflows = sample->inflows;
  const auto entering = inflows_of(drawn, land, options.runoff);
  options.inflows.insert(options.inflows.end(), entering.begin(), entering.end());
  const Hydrology water = water_of(land, options);
  CHECK(share_off_channel(water, drawn.rivers[0], 0.79F) == 0);
  CHECK(water.water(740, 340) == WaterKind::lake);
  int wet = 0;
  for (int y = 280; y < 400; ++y) {
    for (int x = 680; x < 800; ++x) wet += water.water(x, y) == WaterKind::lake ? 1 : 0;
  }
  CHECK(wet > 6000);
  CHECK(wet < 9000);
}
