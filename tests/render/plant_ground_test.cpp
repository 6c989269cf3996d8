// What plants heed of trails and of maps that change, on ground one can count by hand.
#include "render/plant_ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>
#include <tuple>

#include "render/plant_blocks.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// One straight trail along a row of cells, as heavy as can be, and one a hundredth of it along a column.
std::shared_ptr<const TrailNetwork> two_trails(int row, int column) {
  auto trails = std::make_shared<TrailNetwork>();
  trails->wear = Grid<float>(cells, cells, 0);
  trails->carving = Grid<float>(cells, cells, 0);
  trails->routes.push_back({{{0, float(row)}, {float(cells - 1), float(row)}}, {1000, 1000}, 0, -1});
  trails->routes.push_back({{{float(column), 0}, {float(column), float(cells - 1)}}, {10, 10}, 0, -1});
  return trails;
}

std::shared_ptr<MapsSnapshot> wood() {
  auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  cover(*snapshot, 1, 0.3F);
  cover(*snapshot, 2, 0.4F);
  cover(*snapshot, 3, 0.6F);
  return snapshot;
}

bool same(const PlantInstance& a, const PlantInstance& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.scale == b.scale && a.turn == b.turn && a.tint == b.tint &&
         a.plant == b.plant;
}
bool same(const std::vector<PlantInstance>& a, const std::vector<PlantInstance>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) { return same(one, other); });
}

std::vector<PlantInstance> all_of(const PlantPlacement& placement, Stratum stratum) {
  const int blocks = int(cells * cell_size / double(PlantPlacement::block_side(stratum)));
  std::vector<PlantInstance> out;
  for (int row = 0; row < blocks; ++row) {
    for (int column = 0; column < blocks; ++column) {
      const auto block = placement.block(stratum, column, row);
      out.insert(out.end(), block.begin(), block.end());
    }
  }
  return out;
}

/// Those of the first list that the second has not.
std::vector<PlantInstance> without(const std::vector<PlantInstance>& all, const std::vector<PlantInstance>& others) {
  const auto before = [](const PlantInstance& a, const PlantInstance& b) {
    return std::tuple(a.x, a.y, a.scale, a.plant) < std::tuple(b.x, b.y, b.scale, b.plant);
  };
  std::vector<PlantInstance> a = all;
  std::vector<PlantInstance> b = others;
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  std::vector<PlantInstance> out;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out), before);
  return out;
}

}  // namespace

TEST_CASE("a trail is as wide as it is used, and told within five metres of its edge") {
  const auto snapshot = wood();
  const TrailLines lines(snapshot->terrain(), *two_trails(64, 20), 0.5F);
  // The middle of row 64 lies 63.5 cells from the south.
  const auto south = float((cells - 64.5) * cell_size);
  CHECK(lines.inside(300, south) == Approx(1));
  CHECK(lines.inside(300, south + 1) == Approx(0).margin(1e-4));
  CHECK(lines.inside(300, south - 4) == Approx(-3));
  CHECK(lines.inside(300, south + 40) == -TrailLines::reach);
  CHECK(lines.worn(300, south) == Approx(1));
  CHECK(lines.worn(300, south + 1.25F) == Approx(0.5).epsilon(0.01));
  CHECK(lines.worn(300, south + 2) == 0);
  // A hundredth of the weight: use 0.01^0.3 = 0.25 in steps of 1/32.
  const auto east = float(20.5 * cell_size);
  CHECK(lines.inside(east, 100) == Approx(0.25 + 0.75 * 0.25));
  CHECK(lines.none_within(400, 400, 64));
  CHECK_FALSE(lines.none_within(64, 64, 64));
  CHECK(lines.same_within(TrailLines(snapshot->terrain(), *two_trails(64, 90), 0.5F), 384, 16, 16));
  CHECK_FALSE(lines.same_within(TrailLines(snapshot->terrain(), *two_trails(64, 90), 0.5F), 80, 16, 16));
}

TEST_CASE("no trunk stands on a trail, and herbs grow sparser toward it") {
  const auto snapshot = wood();
  const auto trails = two_trails(64, 20);
  snapshot->trails = trails;
  const auto lines = std::make_shared<const TrailLines>(snapshot->terrain(), *trails, 1.5F);
  const PlantPlacement placement(PlantGround{snapshot, nullptr, lines, nullptr});
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    int beside = 0;
    for (const PlantInstance& plant : all_of(placement, stratum)) {
      const float inside = lines->inside(plant.x, plant.y);
      CHECK(inside <= -placement.trunk_radius(plant) + 1e-4F);
      beside += inside > -3 ? 1 : 0;
    }
    CHECK(beside > 20);
  }
  // Tufts by metres from the edge of the heavy trail; what grows beyond its end, in line with it, is none of them.
  std::array<int, 4> tufts{};
  const auto south = float((cells - 64.5) * cell_size);
  int on_trail = 0;
  for (const PlantInstance& plant : all_of(placement, Stratum::herb)) {
    on_trail += lines->inside(plant.x, plant.y) > 0 ? 1 : 0;
    const float away = std::abs(plant.y - south) - 1;
    if (plant.x > 120 && away >= 0 && away < 2) ++tufts[std::size_t(away / 0.5F)];
  }
  CHECK(on_trail == 0);
  CHECK(tufts[0] < tufts[3] / 10);
  CHECK(tufts[1] < 0.7 * tufts[2]);
  CHECK(tufts[3] > 100);
}

TEST_CASE("a wood has many small trees and few large ones, and their crowns are on average those of the species") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.4F);
  const auto trees = all_of(PlantPlacement(snapshot), Stratum::tree);
  REQUIRE(trees.size() > 500);
  double squares = 0;
  std::array<int, 4> ages{};
  for (const PlantInstance& tree : trees) {
    squares += double(tree.scale) * double(tree.scale);
    ++ages[tree.scale < 0.6F ? 0 : tree.scale < 0.9F ? 1 : tree.scale < 1.25F ? 2 : 3];
    CHECK(tree.scale > 0.35F);
    CHECK(tree.scale < 1.8F);
  }
  CHECK(squares / double(trees.size()) == Approx(1).epsilon(0.04));
  CHECK(double(ages[0]) > 0.2 * double(trees.size()));
  CHECK(ages[0] > ages[3]);
  CHECK(ages[3] > 0.15 * double(trees.size()));
}

TEST_CASE("a plant changes only where a map changed within its neighbourhood") {
  const auto before = wood();
  std::mt19937 random(5);
  for (int round = 0; round < 6; ++round) {
    const auto after = std::make_shared<MapsSnapshot>(*before);
    const int x = int(random() % (cells - 12));
    const int y = int(random() % (cells - 12));
    const Rect edit{x, y, x + 4 + int(random() % 9), y + 4 + int(random() % 9)};
    cover(*after, std::size_t(round % 3), edit, round % 2 == 0 ? 0.0F : 0.8F);
    const double west = edit.x0 * cell_size;
    const double east = edit.x1 * cell_size;
    const double south = (cells - edit.y1) * cell_size;
    const double north = (cells - edit.y0) * cell_size;
    int moved = 0;
    for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
      const PlantPlacement then(before);
      const PlantPlacement now(after);
      const glm::vec2 reach = now.neighbourhood(stratum);
      CHECK(reach.x <= (stratum == Stratum::tree ? 16.0F : 4.0F));
      const auto old_plants = all_of(then, stratum);
      const auto new_plants = all_of(now, stratum);
      for (const auto& list : {without(old_plants, new_plants), without(new_plants, old_plants)}) {
        for (const PlantInstance& plant : list) {
          // The cell of the neighbourhood that it stands in meets the edit.
          const double cell_west = std::floor(plant.x / reach.x) * double(reach.x);
          const double cell_south = std::floor(plant.y / reach.y) * double(reach.y);
          CHECK((cell_west < east && cell_west + double(reach.x) > west && cell_south < north &&
                 cell_south + double(reach.y) > south));
          ++moved;
        }
      }
    }
    CHECK(moved > 0);
  }
}

TEST_CASE("after any edits the blocks that were kept are those that would be planted now") {
  auto maps = wood();
  auto terrain = std::make_shared<Terrain>(maps->terrain());
  maps->hydrology = river(40, 42);
  maps->trails = two_trails(64, 20);
  const auto lines_of = [](const MapsSnapshot& snapshot) {
    auto lines = std::make_shared<GroundLines>();
    lines->shore = std::make_shared<const ShoreMap>(ShoreMap{2, shore_field(snapshot.terrain(), *snapshot.hydrology, 2)});
    lines->trails = std::make_shared<const TrailLines>(snapshot.terrain(), *snapshot.trails, 1.5F);
    return std::shared_ptr<const GroundLines>(lines);
  };
  std::shared_ptr<const MapsSnapshot> shown = maps;
  PlantBlocks blocks;
  blocks.set_snapshot(shown, lines_of(*shown));
  const auto build = [&] {
    for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) blocks.build_all(stratum, 256, 256, 800);
    blocks.build_all(Stratum::herb, 200, 250, 40);
  };
  build();
  std::mt19937 random(11);
  for (int round = 0; round < 14; ++round) {
    const auto next = std::make_shared<MapsSnapshot>(*shown);
    const int x = int(random() % 100);
    const int y = int(random() % 100);
    switch (round % 5) {
      case 0:
      case 1:
        cover(*next, std::size_t(random() % 4), {x, y, x + 6, y + 6}, 0.1F * float(random() % 9));
        break;
      case 2:
        for (int i = 0; i < 8; ++i) terrain->height(x + i, y + i) += 2;
        next->document.terrain = std::make_shared<const Terrain>(*terrain);
        break;
      case 3:
        next->hydrology = river(x, x + 2);
        break;
      default:
        next->trails = two_trails(x, y);
    }
    shown = next;
    const auto lines = lines_of(*next);
    blocks.set_snapshot(shown, lines);
    int stale = 0;
    int all = 0;
    const PlantPlacement fresh(PlantGround{shown, lines->shore, lines->trails, blocks.placement().ground().grazing});
    for (int s = 0; s < strata; ++s) {
      for (const auto& [place, block] : blocks.blocks(Stratum(s))) {
        ++all;
        stale += block.stale ? 1 : 0;
        if (block.stale) continue;
        CHECK(same(block.plants, fresh.block(Stratum(s), place.second, place.first)));
      }
    }
    INFO("round " << round);
    // A dab of 24 m touches four blocks of 64 m at most, and some of 16 m; a river or a trail lies along all of the map.
    CHECK(stale < (round % 5 < 3 ? 30 : all * 3 / 4));
    build();
  }
}

TEST_CASE("browsed shrubs are small") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 2, 0.4F);
  auto partition = std::make_shared<Partition>();
  partition->label = RunMap(Grid<std::int32_t>(cells, cells, 0));
  partition->pieces.resize(1);
  auto level = std::make_shared<AnimalLevel>();
  level->partition = partition;
  level->eaten.assign(4, {0});
  level->available.assign(4, {1000});
  level->eaten[std::size_t(snapshot->web->levels[0][2])] = {1000};
  const auto whole = all_of(PlantPlacement(snapshot), Stratum::shrub);
  snapshot->animals.push_back(level);
  const auto browsed = all_of(PlantPlacement(snapshot, nullptr, std::make_shared<const Grazing>(*snapshot)), Stratum::shrub);
  REQUIRE(whole.size() == browsed.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CHECK(browsed[i].x == whole[i].x);
    CHECK(browsed[i].scale == Approx(0.6 * double(whole[i].scale)));
  }
}
