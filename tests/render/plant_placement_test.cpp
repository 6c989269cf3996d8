#include "render/plant_placement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/plant_arena.hpp"
#include "render/plant_blocks.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

constexpr int woody_blocks = int(cells * cell_size / woody_block_side);

std::vector<PlantInstance> all_plants(const std::shared_ptr<const MapsSnapshot>& snapshot, Stratum stratum) {
  const PlantPlacement placement(snapshot);
  const int blocks = int(cells * cell_size / PlantPlacement::block_side(stratum));
  std::vector<PlantInstance> out;
  for (int row = 0; row < blocks; ++row) {
    for (int column = 0; column < blocks; ++column) {
      const auto block = placement.block(stratum, column, row);
      out.insert(out.end(), block.begin(), block.end());
    }
  }
  return out;
}

float crown_radius(const MapsSnapshot& snapshot, const PlantInstance& plant) {
  const int species = snapshot.web->levels[0][std::size_t(plant.plant)];
  return 0.5F * snapshot.web->species[std::size_t(species)].plant().shape.crown_diameter * plant.scale;
}

/// Crown area of a species / ground.
double crown_share(const MapsSnapshot& snapshot, const std::vector<PlantInstance>& plants, int index) {
  double area = 0;
  for (const PlantInstance& plant : plants) {
    const double radius = crown_radius(snapshot, plant);
    if (int(plant.plant) == index) area += glm::pi<double>() * radius * radius;
  }
  return area / (cells * cell_size * cells * cell_size);
}

int cell_x(const PlantInstance& plant) { return int(plant.x / cell_size); }
int cell_y(const PlantInstance& plant) { return cells - 1 - int(plant.y / cell_size); }

bool same(const PlantInstance& a, const PlantInstance& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.scale == b.scale && a.turn == b.turn && a.tint == b.tint &&
         a.plant == b.plant;
}

}  // namespace

TEST_CASE("crowns cover as much ground as the cover map says") {
  for (const float wanted : {0.05F, 0.25F, 0.6F}) {
    const auto snapshot = level_landscape();
    cover(*snapshot, 0, wanted);
    CHECK(crown_share(*snapshot, all_plants(snapshot, Stratum::tree), 0) == Approx(wanted).epsilon(wanted < 0.1F ? 0.09 : 0.03));
    cover(*snapshot, 2, wanted);
    CHECK(crown_share(*snapshot, all_plants(snapshot, Stratum::shrub), 2) == Approx(wanted).epsilon(0.02));
  }
}

TEST_CASE("plants per hectare are those of the cover map within 2 %") {
  // 26 ha of a plain; more than full cover would crowd the crowns and change the number.
  for (const std::size_t plant : {std::size_t(0), std::size_t(1), std::size_t(2)}) {
    for (const float wanted : {0.1F, 0.25F, 0.5F}) {
      INFO("plant " << plant << " cover " << wanted);
      const auto snapshot = level_landscape();
      cover(*snapshot, plant, wanted);
      const auto plants = all_plants(snapshot, plant == 2 ? Stratum::shrub : Stratum::tree);
      const double radius =
          0.5 * snapshot->web->species[std::size_t(snapshot->web->levels[0][plant])].plant().shape.crown_diameter;
      const double expected = wanted * cells * cells * cell_size * cell_size / (glm::pi<double>() * radius * radius);
      // Of some hundreds chance moves a few more.
      CHECK(double(plants.size()) == Approx(expected).epsilon(expected < 1000 ? 0.035 : 0.02));
    }
  }
}

TEST_CASE("two species of trees share a wood, each with its own cover, however dense it is") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  cover(*snapshot, 1, 0.5F);
  const auto plants = all_plants(snapshot, Stratum::tree);
  CHECK(crown_share(*snapshot, plants, 0) == Approx(0.3).epsilon(0.06));
  CHECK(crown_share(*snapshot, plants, 1) == Approx(0.5).epsilon(0.06));
}

TEST_CASE("where animals ate most of the growth herbs are lower and fewer") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 3, 0.6F);
  // One level of animals in two pieces: the west is eaten bare, nothing of the east.
  auto partition = std::make_shared<Partition>();
  Grid<std::int32_t> label(cells, cells, 0);
  for (int y = 0; y < cells; ++y) {
    for (int x = cells / 2; x < cells; ++x) label(x, y) = 1;
  }
  partition->label = RunMap(label);
  partition->pieces.resize(2);
  auto level = std::make_shared<AnimalLevel>();
  level->partition = partition;
  level->eaten.assign(4, {0, 0});
  level->available.assign(4, {1000, 1000});
  const auto grass = std::size_t(snapshot->web->levels[0][3]);
  level->eaten[grass] = {1000, 0};
  snapshot->animals.push_back(level);

  const PlantPlacement placement(snapshot, nullptr, std::make_shared<const Grazing>(*snapshot));
  const int last = int(cells * cell_size / herb_block_side) - 1;
  const auto mean_height = [](const std::vector<PlantInstance>& plants) {
    double sum = 0;
    for (const PlantInstance& plant : plants) sum += plant.scale;
    return sum / double(plants.size());
  };
  const auto eaten = placement.block(Stratum::herb, 2, 5);
  const auto left = placement.block(Stratum::herb, last - 2, 5);
  REQUIRE(eaten.size() > 500);
  CHECK(mean_height(eaten) < 0.5 * mean_height(left));
  CHECK(double(eaten.size()) < 0.8 * double(left.size()));
  // What nobody eats is as it would be without animals.
  const auto untouched = PlantPlacement(snapshot).block(Stratum::herb, last - 2, 5);
  CHECK(std::equal(left.begin(), left.end(), untouched.begin(), untouched.end(), same));

  // When more is eaten, herbs are made anew, trees are not.
  cover(*snapshot, 0, 0.2F);
  PlantBlocks blocks;
  blocks.set_snapshot(snapshot);
  blocks.build_all(Stratum::herb, 256, 256, 40);
  blocks.build_all(Stratum::tree, 256, 256, 100);
  const auto after = std::make_shared<MapsSnapshot>(*snapshot);
  auto hungrier = std::make_shared<AnimalLevel>(*level);
  hungrier->eaten[grass] = {1000, 600};
  after->animals = {hungrier};
  after->complete = true;
  blocks.set_snapshot(after);
  for (const auto& [place, block] : blocks.blocks(Stratum::herb)) {
    if (place.second != 15) CHECK(block.stale == (place.second > 15));  // the east begins at 256 m; what touches it may be stale
  }
  for (const auto& [place, block] : blocks.blocks(Stratum::tree)) CHECK_FALSE(block.stale);
}

TEST_CASE("no two trunks stand closer than 0.4 times the sum of their crowns' radii") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.5F);
  cover(*snapshot, 1, 0.5F);
  auto plants = all_plants(snapshot, Stratum::tree);
  REQUIRE(plants.size() > 1000);
  std::sort(plants.begin(), plants.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  double closest = 10;
  for (std::size_t i = 0; i < plants.size(); ++i) {
    for (std::size_t j = i + 1; j < plants.size() && plants[j].x - plants[i].x < 12; ++j) {
      const double distance = std::hypot(plants[j].x - plants[i].x, plants[j].y - plants[i].y);
      closest = std::min(closest, distance / (crown_radius(*snapshot, plants[i]) + crown_radius(*snapshot, plants[j])));
    }
  }
  CHECK(closest >= 0.399);
}

TEST_CASE("nothing grows where its cover is zero, in water, or on a worn trail") {
  const auto snapshot = level_landscape();
  const Rect wood{32, 0, 96, cells};
  for (std::size_t i = 0; i < 4; ++i) cover(*snapshot, i, wood, 0.25F);
  snapshot->hydrology = river(60, 64);
  auto trails = std::make_shared<TrailNetwork>();
  trails->wear = Grid<float>(cells, cells, 0);
  trails->carving = Grid<float>(cells, cells, 0);
  for (int x = 0; x < cells; ++x) trails->wear(x, 50) = 0.8F;
  for (int x = 0; x < cells; ++x) trails->wear(x, 52) = 0.2F;
  snapshot->trails = trails;
  bool on_faint_trail = false;
  for (int s = 0; s < strata; ++s) {
    const auto plants = all_plants(snapshot, Stratum(s));
    CHECK(plants.size() > 50);
    for (const PlantInstance& plant : plants) {
      CHECK(wood.contains(cell_x(plant), cell_y(plant)));
      CHECK((cell_x(plant) < 60 || cell_x(plant) >= 64));
      CHECK(cell_y(plant) != 50);
      on_faint_trail = on_faint_trail || cell_y(plant) == 52;
    }
  }
  CHECK(on_faint_trail);
}

TEST_CASE("an edit moves no plant elsewhere, and rebuilds only the blocks under its tiles") {
  const auto before = level_landscape();
  cover(*before, 0, 0.4F);
  cover(*before, 1, 0.2F);
  const auto after = std::make_shared<MapsSnapshot>(*before);
  cover(*after, 1, {0, 0, 20, 20}, 0.5F);
  const PlantPlacement old_places(before);
  const PlantPlacement new_places(after);
  int changed = 0;
  for (int row = 0; row < woody_blocks; ++row) {
    for (int column = 0; column < woody_blocks; ++column) {
      const auto then = old_places.block(Stratum::tree, column, row);
      const auto now = new_places.block(Stratum::tree, column, row);
      const bool equal = std::equal(then.begin(), then.end(), now.begin(), now.end(), same);
      changed += equal ? 0 : 1;
      if (!equal) CHECK((column < 2 && row >= woody_blocks - 2));  // 20 cells from the north-western corner are 80 m
    }
  }
  CHECK(changed > 0);

  PlantBlocks blocks;
  blocks.set_snapshot(before);
  blocks.build_all(Stratum::tree, 256, 256, 1000);
  REQUIRE(blocks.blocks(Stratum::tree).size() == std::size_t(woody_blocks * woody_blocks));
  blocks.set_snapshot(after);
  int stale = 0;
  for (const auto& [place, block] : blocks.blocks(Stratum::tree)) stale += block.stale ? 1 : 0;
  CHECK(stale == 4);  // 80 m from the corner: 2 x 2 blocks of 64 m
}

TEST_CASE("the order of building and its budget do not matter") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  cover(*snapshot, 2, 0.2F);
  PlantBlocks at_once;
  at_once.set_snapshot(snapshot);
  at_once.build_all(Stratum::shrub, 100, 100, 1000);
  PlantBlocks by_and_by;
  by_and_by.set_snapshot(snapshot);
  int frames = 0;
  while (!by_and_by.build(Stratum::shrub, 400, 300, 1000, std::chrono::steady_clock::now() + std::chrono::milliseconds(1)))
    ++frames;
  CHECK(frames < 1000);
  REQUIRE(at_once.blocks(Stratum::shrub).size() == by_and_by.blocks(Stratum::shrub).size());
  for (const auto& [place, block] : at_once.blocks(Stratum::shrub)) {
    const auto& other = by_and_by.blocks(Stratum::shrub).at(place);
    CHECK(std::equal(block.plants.begin(), block.plants.end(), other.plants.begin(), other.plants.end(), same));
  }
}

TEST_CASE("a block's plants come by rising rank, so that the first of them stand for all") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.4F);
  cover(*snapshot, 3, 0.4F);
  for (const Stratum stratum : {Stratum::tree, Stratum::herb}) {
    const auto plants = PlantPlacement(snapshot).block(stratum, 2, 2);
    REQUIRE(plants.size() > 5);
    CHECK(std::is_sorted(plants.begin(), plants.end(), [](const auto& a, const auto& b) { return a.rank < b.rank; }));
  }
}

TEST_CASE("slots are taken where there is room and given back") {
  SlotRuns slots;
  REQUIRE(slots.take(10, 100) == 0U);
  REQUIRE(slots.take(20, 100) == 10U);
  REQUIRE(slots.take(30, 100) == 30U);
  CHECK(slots.end() == 60);
  CHECK_FALSE(slots.take(50, 100));
  slots.give_back({10, 20});
  CHECK(slots.take(15, 100) == 10U);
  CHECK(slots.take(5, 100) == 25U);
  slots.give_back({0, 10});
  slots.give_back({25, 5});
  slots.give_back({10, 15});
  // Three neighbours are one run again.
  CHECK(slots.take(30, 100) == 0U);
  CHECK(slots.end() == 60);
}

TEST_CASE("another seed makes another wood") {
  const auto snapshot = level_landscape();
  cover(*snapshot, 0, 0.3F);
  const auto other = std::make_shared<MapsSnapshot>(*snapshot);
  other->document.seed = 8;
  const auto a = PlantPlacement(snapshot).block(Stratum::tree, 3, 3);
  const auto b = PlantPlacement(other).block(Stratum::tree, 3, 3);
  CHECK_FALSE(std::equal(a.begin(), a.end(), b.begin(), b.end(), same));
}
