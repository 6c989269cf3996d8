// What lies and grows on the floor of a wood beside the plants of the maps.
#include "render/plant_undergrowth.hpp"

#include "render/plant_blocks.hpp"
#include "tests/render/sample_plants.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// How many of each kind lie on the whole landscape.
std::array<int, undergrowth_kinds> counted(const PlantPlacement& placement) {
  std::array<int, undergrowth_kinds> out{};
  const int blocks = int(cells * cell_size / herb_block_side);
  for (int row = 0; row < blocks; ++row) {
    for (int column = 0; column < blocks; ++column) {
      for (const PlantInstance& one : placement.undergrowth(column, row)) {
        ++out[std::size_t(int(one.plant) - first_undergrowth_kind)];
      }
    }
  }
  return out;
}

int of(const std::array<int, undergrowth_kinds>& counts, Undergrowth kind) { return counts[std::size_t(kind)]; }

}  // namespace

TEST_CASE("ferns, saplings and dead wood are under trees, and only there") {
  auto open = level_landscape();
  cover(*open, 3, 0.8F);
  const auto meadow = counted(PlantPlacement(open));
  for (const Undergrowth kind :
       {Undergrowth::fern, Undergrowth::shade_herb, Undergrowth::sapling, Undergrowth::fallen_branch, Undergrowth::log}) {
    CHECK(of(meadow, kind) == 0);
  }
  CHECK(of(meadow, Undergrowth::stone) > 0);
  auto wooded = level_landscape();
  cover(*wooded, 0, 0.7F);
  const auto wood = counted(PlantPlacement(wooded));
  for (const int count : wood) CHECK(count > 100);
}

TEST_CASE("under pines lie fewer ferns and herbs than under oaks, and damp ground bears more") {
  ForestFloor oaks;
  oaks.canopy = 0.7F;
  ForestFloor pines = oaks;
  pines.evergreen = 1;
  ForestFloor damp = oaks;
  damp.moisture = 8;
  for (const auto kind : {std::size_t(Undergrowth::fern), std::size_t(Undergrowth::shade_herb)}) {
    CHECK(undergrowth_density(pines)[kind] < 0.6F * undergrowth_density(oaks)[kind]);
    CHECK(undergrowth_density(damp)[kind] > undergrowth_density(oaks)[kind]);
  }
  // As many as one in a place of the lattice at most.
  float sum = 0;
  for (const float each : undergrowth_density({1, 0, 1, 9, 1})) sum += each;
  CHECK(sum < 1.3F);
}

TEST_CASE("where herbs were painted away few others come up") {
  ForestFloor with;
  with.canopy = 0.6F;
  with.herbs = 0.5F;
  ForestFloor without = with;
  without.herbs = 0;
  CHECK(undergrowth_density(without)[std::size_t(Undergrowth::shade_herb)] <
        0.3F * undergrowth_density(with)[std::size_t(Undergrowth::shade_herb)]);
}

TEST_CASE("undergrowth stands where it stood after an edit elsewhere, and not in water") {
  auto before = level_landscape();
  cover(*before, 0, 0.6F);
  before->hydrology = river(60, 64);
  auto after = std::make_shared<MapsSnapshot>(*before);
  cover(*after, 0, {0, 0, 30, 128}, 0.1F);
  const PlantPlacement one(before);
  const PlantPlacement other(after);
  for (int row = 0; row < 32; ++row) {
    for (int column = 8; column < 32; ++column) {
      const auto a = one.undergrowth(column, row);
      const auto b = other.undergrowth(column, row);
      REQUIRE(a.size() == b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(a[i].x == b[i].x);
        REQUIRE(a[i].rank == b[i].rank);
        const float wet = std::abs(a[i].x - 248);
        REQUIRE(wet >= 8);
      }
    }
  }
}

TEST_CASE("every kind of undergrowth has a small whole mesh that lies on the ground") {
  for (int i = 0; i < undergrowth_kinds; ++i) {
    INFO(i);
    const PlantMesh mesh = undergrowth_mesh(Undergrowth(i), 4);
    CHECK(mesh.triangles() > 10);
    CHECK(mesh.triangles() <= 130);
    for (const auto index : mesh.indices) REQUIRE(index < mesh.vertices.size());
    const PlantExtent extent = extent_of(mesh);
    CHECK(extent.height < 2.2F);
    CHECK(extent.radius < 2);
    float lowest = 1;
    for (const PlantVertex& vertex : mesh.vertices) {
      REQUIRE(glm::length(vertex.normal) == Approx(1).epsilon(1e-3));
      lowest = std::min(lowest, vertex.position.z);
    }
    CHECK(lowest < 0.15F);
  }
}
