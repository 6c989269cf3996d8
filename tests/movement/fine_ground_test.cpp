#include <catch2/catch.hpp>

#include "core/base/random.hpp"
#include "core/movement/fine_path.hpp"
#include "tests/movement/movement_scene.hpp"

using namespace biotope;
using biotope::test::MovementScene;

namespace {

/// Level ground with some blocked cells, and its travel graph.
struct Blocked {
  MovementScene scene{40, 40, 10};
  TravelGraph graph;

  explicit Blocked(const std::vector<PathCell>& cells) {
    for (const PathCell& cell : cells) scene.blocked(cell.x, cell.y) = 1;
    const Mobility mobility{1, 1, 1, 3};
    graph = build_travel_graph(scene.ground, confinement_regions(scene.blocked, 10), mobility, 8);
  }
  [[nodiscard]] FineGround ground() const { return {scene.ground, {&graph}, WalkCost(graph.mobility), plan_step}; }
  /// Whether a line enters a blocked cell, by very many samples.
  [[nodiscard]] bool enters(PathPoint a, PathPoint b) const {
    constexpr int samples = 400;
    for (int i = 0; i <= samples; ++i) {
      const float t = float(i) / float(samples);
      const PathCell cell = cell_at({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
      if (scene.blocked(cell.x, cell.y)) return true;
    }
    return false;
  }
};

std::vector<PathCell> scattered(std::uint64_t seed, int count) {
  std::vector<PathCell> cells;
  for (int i = 0; i < count; ++i)
    cells.push_back({random_int(2, 37, {seed, std::uint64_t(i), 1}), random_int(2, 37, {seed, std::uint64_t(i), 2})});
  return cells;
}

}  // namespace

TEST_CASE("a line that clips the corner of a blocked cell is not clear, one beside it is") {
  const Blocked land({{10, 10}});
  const FineGround ground = land.ground();
  // The cell reaches from 9.5 to 10.5; this line is in it for a tenth of a cell.
  CHECK_FALSE(ground.clear({9.3F, 10.35F}, {9.9F, 10.65F}));
  CHECK_FALSE(ground.clear({9.9F, 10.65F}, {9.3F, 10.35F}));
  CHECK(ground.clear({9.3F, 10.55F}, {9.9F, 10.85F}));
  CHECK(ground.clear({9, 9}, {9, 12}));
  CHECK_FALSE(ground.clear({8, 10}, {12, 10}));
  CHECK_FALSE(ground.clear({10, 10}, {12, 10}));
}

TEST_CASE("between two blocked cells that touch at a corner nobody walks") {
  const Blocked land({{10, 10}, {11, 11}});
  CHECK_FALSE(land.ground().clear({10, 11}, {11, 10}));
  CHECK(land.ground().clear({10, 11}, {8, 13}));
}

TEST_CASE("a line is clear exactly where it enters no blocked cell") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Blocked land(scattered(seed, 90));
    const FineGround ground = land.ground();
    int clear = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
      const auto unit = [&](std::uint64_t what) { return float(random_unit({seed, i, what})); };
      const PathPoint a{39 * unit(3), 39 * unit(4)};
      const PathPoint b{std::clamp(a.x + 10 * (unit(5) - 0.5F), 0.0F, 39.0F),
                        std::clamp(a.y + 10 * (unit(6) - 0.5F), 0.0F, 39.0F)};
      if (!ground.clear(a, b)) continue;
      ++clear;
      REQUIRE_FALSE(land.enters(a, b));
    }
    CHECK(clear > 50);
  }
}

TEST_CASE("smoothed paths never cross an obstacle, whatever corner they would cut") {
  int found = 0;
  for (std::uint64_t seed = 20; seed < 40; ++seed) {
    const Blocked land(scattered(seed, 220));
    const FineGround ground = land.ground();
    const PathCell from{0, 0};
    const PathCell to{39, 39};
    const std::array over{from, PathCell{20, 20}, to};
    const auto cells = fine_path(ground, over, from, to);
    if (cells.empty()) continue;
    ++found;
    const auto line = smooth_path(ground, points_of(cells));
    for (std::size_t i = 0; i + 1 < line.size(); ++i) REQUIRE_FALSE(land.enters(line[i], line[i + 1]));
  }
  CHECK(found > 5);
}
