#include "render/animal_surroundings.hpp"

#include <algorithm>

#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

const Place whole{cells * double(cell_size), cells* double(cell_size)};

std::vector<Stem> all_stems(const AnimalSurroundings& around) {
  std::vector<Stem> stems;
  around.stems({0, 0}, whole, stems);
  return stems;
}

std::shared_ptr<const AnimalSurroundings> around(const std::shared_ptr<const MapsSnapshot>& maps,
                                                 std::shared_ptr<const AnimalSurroundings> before = nullptr) {
  return std::make_shared<const AnimalSurroundings>(nullptr, maps->terrain().cell_size, PlantPlacement(maps), std::move(before));
}

}  // namespace

TEST_CASE("Animals know of a trunk under every tree, and of none elsewhere; a part of the ground has its part of them") {
  const auto maps = level_landscape();
  cover(*maps, 0, 0.3F);
  const auto surroundings = around(maps);
  const std::vector<Stem> stems = all_stems(*surroundings);
  std::size_t trees = 0;
  const PlantPlacement placement(maps);
  for (int row = 0; row < int(whole.y / double(woody_block_side)); ++row) {
    for (int column = 0; column < int(whole.x / double(woody_block_side)); ++column) {
      for (const PlantInstance& tree : placement.block(Stratum::tree, column, row)) {
        ++trees;
        CHECK(std::any_of(stems.begin(), stems.end(), [&](const Stem& stem) {
          return stem.at == Place{double(tree.x), double(tree.y)} && stem.radius > 0.02 && stem.radius < 1;
        }));
      }
    }
  }
  CHECK(stems.size() == trees);
  REQUIRE(trees > 20);
  std::vector<Stem> parts;
  for (const double x : {0.0, 0.37}) {
    for (const double y : {0.0, 0.61}) {
      surroundings->stems({x * whole.x, y * whole.y}, {x > 0 ? whole.x : 0.37 * whole.x, y > 0 ? whole.y : 0.61 * whole.y},
                          parts);
    }
  }
  CHECK(parts.size() == trees);
  const AnimalSurroundings bare(nullptr, 10, PlantPlacement());
  CHECK(all_stems(bare).empty());
}

TEST_CASE("Trees that an edit leaves are known to be the same, those that it changed are not") {
  const auto before = level_landscape();
  cover(*before, 0, 0.3F);
  const auto first = around(before);
  static_cast<void>(all_stems(*first));
  // Felled in the south-west corner: the cell there has no trees any more.
  auto edited = std::make_shared<MapsSnapshot>(*before);
  CoverMap map = *edited->cover[0];
  for (int y = cells - 8; y < cells; ++y) {
    for (int x = 0; x < 8; ++x) map.set(x, y, 0);
  }
  edited->cover[0] = std::make_shared<const CoverMap>(std::move(map));
  const auto second = around(edited, first);
  const double felled = 8 * double(cell_size);
  CHECK(!second->same_within(*first, {0, 0}, {felled, felled}));
  CHECK(second->same_within(*first, whole * 0.6, whole * 0.9));
  const std::vector<Stem> now = all_stems(*second);
  CHECK(now.size() < all_stems(*first).size());
  // Taken over or made anew, they are the same trees.
  CHECK(now == all_stems(*around(edited)));
  CHECK(std::none_of(now.begin(), now.end(), [&](const Stem& stem) { return stem.at.x < felled && stem.at.y < felled; }));
}
