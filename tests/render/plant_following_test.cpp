// Plants that follow edits while a window draws: found and planted on other threads, they come to the same as at once.
#include <algorithm>
#include <cmath>
#include <random>

#include "render/plant_blocks.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::array<std::pair<Stratum, float>, 3> looked_at{
    {{Stratum::tree, 800.0F}, {Stratum::shrub, 800.0F}, {Stratum::herb, 60.0F}}};

bool same(const PlantInstance& a, const PlantInstance& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.scale == b.scale && a.turn == b.turn && a.plant == b.plant;
}

/// What one frame does, which waits until then.
bool frame(PlantBlocks& blocks, Clock::time_point until) {
  bool complete = true;
  for (const auto& [stratum, reach] : looked_at) complete = blocks.build(stratum, 256, 256, reach, until) && complete;
  return complete;
}

/// Whether every block is planted as the snapshot has it, and none is missing.
void check_planted(const PlantBlocks& blocks, const std::shared_ptr<const MapsSnapshot>& maps) {
  CHECK(blocks.placement().snapshot() == maps.get());
  const PlantPlacement fresh(PlantGround{maps, nullptr, nullptr, blocks.placement().ground().grazing});
  for (const auto& [stratum, reach] : looked_at) {
    CHECK(blocks.blocks(stratum).size() >= (stratum == Stratum::herb ? 40 : 64));
    CHECK(blocks.whole_to(stratum) == reach);
    for (const auto& [place, block] : blocks.blocks(stratum)) {
      const auto plants = fresh.block(stratum, place.second, place.first);
      CHECK_FALSE(block.stale);
      CHECK(std::equal(block.plants.begin(), block.plants.end(), plants.begin(), plants.end(), same));
    }
  }
}

std::shared_ptr<MapsSnapshot> wood() {
  auto maps = level_landscape();
  for (std::size_t i = 0; i < 4; ++i) cover(*maps, i, 0.3F);
  return maps;
}

}  // namespace

TEST_CASE("plants that follow edits frame by frame stand, in the end, as the last snapshot has them") {
  std::shared_ptr<const MapsSnapshot> maps = wood();
  PlantBlocks blocks;
  blocks.follow(maps, nullptr);
  std::mt19937 random(5);
  for (int edit = 0; edit < 30; ++edit) {
    const auto next = std::make_shared<MapsSnapshot>(*maps);
    const int x = int(random() % 120);
    const int y = int(random() % 120);
    cover(*next, std::size_t(random() % 4), {x, y, x + 8, y + 8}, 0.1F * float(random() % 9));
    maps = next;
    blocks.follow(maps, nullptr);
    // Some edits are answered by several frames, others are overtaken by the next.
    for (unsigned frames = random() % 4; frames > 0; --frames) (void)frame(blocks, Clock::now() + std::chrono::milliseconds(1));
  }
  REQUIRE(frame(blocks, Clock::now() + std::chrono::minutes(1)));
  CHECK_FALSE(blocks.following());
  check_planted(blocks, maps);
}

TEST_CASE("until it is known what an edit changed all plants stay as they are") {
  const auto before = wood();
  PlantBlocks blocks;
  blocks.set_snapshot(before);
  REQUIRE(frame(blocks, Clock::now() + std::chrono::minutes(1)));
  const std::size_t trees = blocks.blocks(Stratum::tree).size();
  const auto after = std::make_shared<MapsSnapshot>(*before);
  cover(*after, 0, {0, 0, 20, 20}, 0.0F);
  blocks.follow(after, nullptr);
  CHECK(blocks.blocks(Stratum::tree).size() == trees);
  const MapsSnapshot* shown = blocks.placement().snapshot();
  CHECK((shown == before.get() || shown == after.get()));
  REQUIRE(frame(blocks, Clock::now() + std::chrono::minutes(1)));
  check_planted(blocks, after);
}

TEST_CASE("no plant of one landscape is left in the next, though it comes while an edit is being followed") {
  const auto first = wood();
  PlantBlocks blocks;
  blocks.set_snapshot(first);
  REQUIRE(frame(blocks, Clock::now() + std::chrono::minutes(1)));
  const auto edited = std::make_shared<MapsSnapshot>(*first);
  cover(*edited, 1, 0.5F);
  const auto elsewhere = std::make_shared<MapsSnapshot>(*first);
  elsewhere->document.seed = 8;
  blocks.follow(edited, nullptr);
  blocks.follow(elsewhere, nullptr);
  for (const auto& [stratum, reach] : looked_at) CHECK(blocks.blocks(stratum).empty());
  REQUIRE(frame(blocks, Clock::now() + std::chrono::minutes(1)));
  check_planted(blocks, elsewhere);
}

TEST_CASE("Along a way of small steps every block within reach is there, though blocks are not looked for at every step") {
  const auto maps = wood();
  PlantBlocks blocks;
  blocks.set_snapshot(maps);
  constexpr float reach = 120;
  double x = 100;
  double y = 90;
  for (int step = 0; step < 120; ++step) {
    x += 2.1;
    y += 1.3 * ((step / 20) % 2 == 0 ? 1 : -1);
    for (const Stratum stratum : {Stratum::tree, Stratum::herb}) {
      REQUIRE(blocks.build(stratum, x, y, reach, Clock::now() + std::chrono::minutes(1)));
      CHECK(blocks.whole_to(stratum) == reach);
      const double side = PlantPlacement::block_side(stratum);
      const auto across = int(512 / side);
      int lacking = 0;
      for (int row = 0; row < across; ++row) {
        for (int column = 0; column < across; ++column) {
          const double dx = std::max({column * side - x, x - (column + 1) * side, 0.0});
          const double dy = std::max({row * side - y, y - (row + 1) * side, 0.0});
          lacking += std::hypot(dx, dy) <= double(reach) && !blocks.blocks(stratum).contains({row, column}) ? 1 : 0;
        }
      }
      CHECK(lacking == 0);
    }
  }
}
