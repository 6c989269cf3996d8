#include "core/movement/travel_blocks.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"

using namespace biotope;

namespace {

Terrain hills(int width, int height) {
  Terrain terrain;
  terrain.cell_size = 5;
  terrain.height = Grid<float>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) terrain.height(x, y) = float(20 * std::sin(x * 0.11) * std::cos(y * 0.07) + 0.3 * y);
  }
  return terrain;
}

/// A ground of its own water, so that depths can be changed.
Ground ground_of(const Terrain& terrain) {
  auto water = std::make_shared<Hydrology>();
  water->water_depth = Grid<float>(terrain.height.width(), terrain.height.height());
  for (int y = 0; y < terrain.height.height(); ++y) water->water_depth(terrain.height.width() / 3, y) = 0.3F;
  return {std::make_shared<const Terrain>(terrain), nullptr, water, nullptr};
}

/// Regions by paper and pencil: blocked discs anywhere, what is left of one region or of another.
ConfinementRegions regions_of(int width, int height, std::uint64_t number, int discs) {
  Grid<std::int32_t> label(width, height, random_int(0, 2, {number, 9}));
  for (int i = 0; i < discs; ++i) {
    const auto disc = std::uint64_t(i);
    const int x = random_int(0, width, {number, disc, 1});
    const int y = random_int(0, height, {number, disc, 2});
    const int radius = random_int(1, 9, {number, disc, 3});
    for (int cy = 0; cy < height; ++cy) {
      for (int cx = 0; cx < width; ++cx) {
        if (std::hypot(cx - x, cy - y) <= radius) label(cx, cy) = -1;
      }
    }
  }
  ConfinementRegions regions;
  regions.label = RunMap(label);
  return regions;
}

/// A cell of the regions is blocked.
void block_cell(ConfinementRegions& regions, int x, int y) {
  Grid<std::int32_t> label = numbers_of(regions.label.runs());
  label(x, y) = -1;
  regions.label = RunMap(label);
}

bool same_graph(const TravelGraph& a, const TravelGraph& b) {
  const auto same_vertex = [](const auto& p, const auto& q) { return p.x == q.x && p.y == q.y && p.region == q.region; };
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), same_vertex) &&
         a.first_edge == b.first_edge && a.target == b.target && a.cost == b.cost && a.edge == b.edge &&
         a.edge_count == b.edge_count && a.mean_cost == b.mean_cost && a.longest_cost == b.longest_cost &&
         a.vertex_of_cell == b.vertex_of_cell && a.open_cells == b.open_cells;
}

}  // namespace

TEST_CASE("a graph that takes over the blocks of another is the one that is built anew") {
  const int width = 130;
  const int height = 97;
  const Mobility mobility{0.7F, 0.5F, 0.8F, 3};
  Terrain terrain = hills(width, height);
  Ground ground = ground_of(terrain);
  ConfinementRegions regions = regions_of(width, height, 1, 12);
  TravelBlocks blocks;
  TravelGraph graph = build_travel_graph(ground, regions, mobility, 10, nullptr, blocks);
  for (std::uint64_t step = 0; step < 12; ++step) {
    Ground next_ground = ground;
    if (step % 3 == 1) {
      // A hill somewhere, and no other ground anywhere else.
      const int x = random_int(5, width - 6, {step, 5});
      const int y = random_int(5, height - 6, {step, 6});
      for (int cy = y - 4; cy <= y + 4; ++cy) {
        for (int cx = x - 4; cx <= x + 4; ++cx) terrain.height(cx, cy) += 7;
      }
      next_ground.terrain = std::make_shared<const Terrain>(terrain);
    }
    ConfinementRegions next = step % 3 == 0 ? regions_of(width, height, step + 2, 10) : regions;
    if (step % 4 == 2) block_cell(next, random_int(0, width - 1, {step, 7}), random_int(0, height - 1, {step, 8}));
    const KnownGraph known{graph, blocks, regions.label, blocks_of_same_ground(ground, next_ground, 10)};
    TravelBlocks made;
    TravelGraph taken = build_travel_graph(next_ground, next, mobility, 10, &known, made);
    INFO("step " << step);
    REQUIRE(same_graph(taken, build_travel_graph(next_ground, next, mobility, 10)));
    graph = std::move(taken);
    blocks = std::move(made);
    regions = std::move(next);
    ground = next_ground;
  }
}
