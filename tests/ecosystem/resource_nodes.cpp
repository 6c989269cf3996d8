#include "core/ecosystem/resource_nodes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "animal_scene.hpp"
#include "core/base/random.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// One grazer on one grass.
WebBuilder grazer_web() {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  return builder;
}

std::vector<ResourceNode> nodes_of(const GraphLevel& graph, NodeKind kind) {
  std::vector<ResourceNode> nodes;
  for (const ResourceNode& node : graph.nodes) {
    if (node.kind == kind) nodes.push_back(node);
  }
  return nodes;
}

}  // namespace

TEST_CASE("a meadow is one node with its area, centroid and yearly growth") {
  Landscape land(20, 20);
  Scene scene(land, grazer_web().web);
  Grid<Cover> grass(20, 20);
  for (int y = 2; y < 5; ++y) {
    for (int x = 3; x < 7; ++x) grass(x, y) = full_cover / 2;
  }
  scene.cover(0, grass);
  const auto level = scene.solve(1);
  const auto meadows = nodes_of(*level->graph, NodeKind::vegetation);
  REQUIRE(meadows.size() == 1);
  CHECK(meadows[0].cells == 12);
  CHECK(meadows[0].area == Approx(120000));
  CHECK(meadows[0].centroid_x == Approx(4.5));
  CHECK(meadows[0].centroid_y == Approx(3));
  CHECK(meadows[0].group == int(Stratum::herb));
  REQUIRE(meadows[0].quantities.size() == 1);
  // 12 cells of 1 ha, half covered, 0.1 kg / m2 and year.
  CHECK(meadows[0].quantities[0].kilograms_per_year == Approx(12 * 10000 * 0.5 * 0.1));
  CHECK(meadows[0].quantities[0].available == meadows[0].quantities[0].kilograms_per_year);
  const auto& node_of_cell = *level->graph->node_of_cell[std::size_t(Stratum::herb)];
  CHECK(node_of_cell(3, 2) >= 0);
  CHECK(node_of_cell(2, 2) == -1);
}

TEST_CASE("grass below a fifth of cover, or on less than a hectare, is no meadow") {
  Landscape land(20, 20, 10);
  Scene scene(land, grazer_web().web);
  scene.cover(0, full_cover / 5 - 1);
  CHECK(nodes_of(*scene.solve(1)->graph, NodeKind::vegetation).empty());
  Grid<Cover> grass(20, 20);
  for (int i = 0; i < 99; ++i) grass(i % 11, i / 11) = full_cover;
  scene.cover(0, grass);
  CHECK(nodes_of(*scene.solve(1)->graph, NodeKind::vegetation).empty());
  grass(0, 9) = full_cover;
  scene.cover(0, grass);
  CHECK(nodes_of(*scene.solve(1)->graph, NodeKind::vegetation).size() == 1);
}

TEST_CASE("a node stands on the passable cell of its own area nearest to the centroid") {
  // A meadow around a cliff: the centroid is a cell where nobody can stand.
  Landscape land(3, 3);
  land.derivatives.slope(1, 1) = 2;
  Scene scene(land, grazer_web().web);
  const auto meadows = nodes_of(*scene.solve(1)->graph, NodeKind::vegetation);
  REQUIRE(meadows.size() == 1);
  CHECK(meadows[0].centroid_x == Approx(1));
  CHECK(std::abs(meadows[0].x - 1) + std::abs(meadows[0].y - 1) == 1);
}

TEST_CASE("plants that no species of the level eats make no nodes") {
  WebBuilder builder;
  const int grass = builder.plant("grass", 0.1F);
  builder.plant("tree", 1, Stratum::tree);
  builder.animal("grazer", 1, walker(), {{"grass", {grass}}});
  const auto level = Scene(Landscape(5, 5), builder.web).solve(1);
  REQUIRE(level->graph->nodes.size() == 1);
  CHECK(level->graph->nodes[0].group == int(Stratum::herb));
  CHECK((*level->graph->node_of_cell[std::size_t(Stratum::tree)])(2, 2) == -1);
}

TEST_CASE("a wide meadow is cut into compact patches that cover it exactly") {
  Scene scene(Landscape(200, 200, 20), grazer_web().web);
  const auto level = scene.solve(1);
  const auto meadows = nodes_of(*level->graph, NodeKind::vegetation);
  CHECK(meadows.size() >= 50);
  CHECK(meadows.size() <= 200);
  std::size_t cells = 0;
  double kilograms = 0;
  for (const ResourceNode& meadow : meadows) {
    cells += meadow.cells;
    kilograms += meadow.quantities[0].kilograms_per_year;
    CHECK(std::max(meadow.bounds.width(), meadow.bounds.height()) <= 40);
    CHECK(meadow.bounds.contains(meadow.x, meadow.y));
  }
  CHECK(cells == 200 * 200);
  CHECK(kilograms == Approx(200 * 200 * 400 * 0.1));
}

TEST_CASE("patches are connected, and scattered growth joins the patch beside it") {
  // A ragged meadow: a disk whose rim is frayed.
  Landscape land(160, 160, 20);
  Scene scene(land, grazer_web().web);
  Grid<Cover> grass(160, 160);
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) {
      const double distance = std::hypot(x - 80.0, y - 80.0);
      const double limit = 55 + 20 * random_unit({3, std::uint64_t(x), std::uint64_t(y)});
      grass(x, y) = distance < limit ? full_cover : 0;
    }
  }
  scene.cover(0, grass);
  const auto level = scene.solve(1);
  const auto& node_of_cell = *level->graph->node_of_cell[std::size_t(Stratum::herb)];
  for (std::size_t n = 0; n < level->graph->nodes.size(); ++n) {
    const ResourceNode& node = level->graph->nodes[n];
    if (node.kind != NodeKind::vegetation) continue;
    Grid<std::uint8_t> outside(160, 160, 1);
    for (std::size_t i = 0; i < outside.size(); ++i) outside[i] = node_of_cell[i] != int(n);
    CHECK(confinement_regions(outside, 1e6).regions.size() == 1);
    CHECK(node.cells >= 20);
    CHECK(node_of_cell(node.x, node.y) == int(n));
  }
}

TEST_CASE("a meadow across three pieces of the partition is three nodes") {
  Landscape land(5, 5);
  land.cliff_column(2);
  // The second grazer climbs the cliff, so that cells on it belong to a piece of its own.
  WebBuilder builder = grazer_web();
  AnimalTraits climber = walker();
  climber.max_slope = 3;
  builder.animal("climber", 1, climber, {{"grass", {0}}});
  Scene scene(land, builder.web);
  const auto level = scene.solve(1);
  CHECK(level->partition->pieces.size() == 3);
  CHECK(nodes_of(*level->graph, NodeKind::vegetation).size() == 3);
}

TEST_CASE("banks are where fresh water is beside ground that can be reached; the sea is no drink") {
  Landscape land(9, 5);
  land.river_column(4, 2);
  Scene scene(land, grazer_web().web);
  const auto level = scene.solve(1);
  const auto& banks = *level->graph->node_of_cell[3];
  for (int y = 0; y < 5; ++y) {
    CHECK(banks(2, y) == -1);
    CHECK(banks(3, y) >= 0);
    CHECK(banks(4, y) == -1);
    CHECK(banks(5, y) >= 0);
  }
  Landscape coast(9, 5);
  coast.river_column(4, 2);
  for (int y = 0; y < 5; ++y) coast.hydrology.water(4, y) = WaterKind::sea;
  Scene by_the_sea(coast, grazer_web().web);
  CHECK(nodes_of(*by_the_sea.solve(1)->graph, NodeKind::bank).empty());
}

TEST_CASE("a stretch of bank is at most 300 m long") {
  for (const double cell_size : {4.0, 10.0, 30.0}) {
    Landscape land(300, 60, cell_size);
    land.brook_row(30);
    Scene scene(land, grazer_web().web);
    const auto banks = nodes_of(*scene.solve(1)->graph, NodeKind::bank);
    REQUIRE(!banks.empty());
    for (const ResourceNode& bank : banks) {
      CHECK(std::hypot(bank.bounds.width(), bank.bounds.height()) * cell_size <= 300);
      CHECK(std::abs(bank.y - 30) * cell_size <= std::max(20.0, cell_size));
    }
  }
}

TEST_CASE("every region with food keeps a bank where it has one, however many there are") {
  // 40 x 40 compartments, each with its pond.
  Landscape land(200, 200, 50);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (x % 10 == 0 || y % 10 == 0) land.derivatives.slope(x, y) = 2;
      if (x % 10 == 5 && y % 10 == 5) land.hydrology.water(x, y) = WaterKind::lake;
    }
  }
  Scene scene(land, grazer_web().web);
  const auto level = scene.solve(1);
  std::vector<int> banks(level->regions[0]->regions.size());
  std::vector<int> meadows(banks.size());
  for (const ResourceNode& node : level->graph->nodes) {
    const int region = level->partition->pieces[std::size_t(node.piece)].region[0];
    ++(node.kind == NodeKind::bank ? banks : meadows)[std::size_t(region)];
  }
  int fed = 0;
  for (std::size_t i = 0; i < banks.size(); ++i) {
    if (meadows[i] == 0) continue;
    ++fed;
    CHECK(banks[i] >= 1);
  }
  CHECK(fed > 100);
  CHECK(level->graph->nodes.size() <= 2 * node_limits(1).vegetation + 20);
}

TEST_CASE("animals drink across a narrow fringe of trees, but not across a wood or down a cliff") {
  const auto drinks = [](int fringe, float slope) {
    Landscape land(120, 60, 4);
    land.river_column(60, 2);
    for (int y = 0; y < 60; ++y) {
      for (int x = 60 - fringe; x < 60; ++x) {
        land.trees(x, y) = full_cover;
        land.derivatives.slope(x, y) = slope;
      }
      // Only the western bank has land.
      for (int x = 61; x < 120; ++x) land.trees(x, y) = full_cover;
    }
    const auto level = Scene(land, grazer_web().web).solve(1);
    return !nodes_of(*level->graph, NodeKind::bank).empty();
  };
  CHECK(drinks(0, 0));
  CHECK(drinks(4, 0));
  CHECK(!drinks(8, 0));
  CHECK(!drinks(4, 2));
}
