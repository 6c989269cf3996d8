#include <catch2/catch.hpp>
#include <map>

#include "core/base/random.hpp"
#include "core/ecosystem/confinement.hpp"

using namespace biotope;

namespace {

std::shared_ptr<const ConfinementRegions> regions_of(const Grid<std::uint8_t>& blocked) {
  return std::make_shared<const ConfinementRegions>(confinement_regions(blocked, 100));
}

}  // namespace

TEST_CASE("the pieces of two species are the pairs of their regions") {
  // The first species is stopped by a wall at column 2, the second by one at column 4.
  Grid<std::uint8_t> first(6, 2);
  Grid<std::uint8_t> second(6, 2);
  for (int y = 0; y < 2; ++y) {
    first(2, y) = 1;
    second(4, y) = 1;
  }
  const std::vector regions{regions_of(first), regions_of(second)};
  const Partition partition = finest_partition(regions, 100);
  REQUIRE(partition.pieces.size() == 5);
  CHECK(partition.pieces[0].region == std::vector{0, 0});
  CHECK(partition.pieces[1].region == std::vector{-1, 0});
  CHECK(partition.pieces[2].region == std::vector{1, 0});
  CHECK(partition.pieces[3].region == std::vector{1, -1});
  CHECK(partition.pieces[4].region == std::vector{1, 1});
  CHECK(partition.pieces[0].cells == 4);
  CHECK(partition.pieces[0].area == Approx(40000));
  CHECK(partition.label(3, 1) == 2);
}

TEST_CASE("cells where no species can be belong to no piece") {
  Grid<std::uint8_t> blocked(3, 1);
  blocked(1, 0) = 1;
  const std::vector regions{regions_of(blocked), regions_of(blocked)};
  const Partition partition = finest_partition(regions, 100);
  CHECK(partition.label(1, 0) == -1);
  CHECK(partition.pieces.size() == 2);
}

TEST_CASE("species that share their regions share the pieces") {
  const auto shared = regions_of(Grid<std::uint8_t>(4, 4));
  const std::vector regions{shared, shared, shared};
  const Partition partition = finest_partition(regions, 100);
  REQUIRE(partition.pieces.size() == 1);
  CHECK(partition.pieces[0].region == std::vector{0, 0, 0});
}

TEST_CASE("two cells are in one piece exactly when every species has them in the same region") {
  std::vector<std::shared_ptr<const ConfinementRegions>> regions;
  for (std::uint64_t species = 0; species < 3; ++species) {
    Grid<std::uint8_t> blocked(70, 90);
    for (std::size_t i = 0; i < blocked.size(); ++i) blocked[i] = random_unit({species, i}) < 0.42;
    regions.push_back(regions_of(blocked));
  }
  const Partition partition = finest_partition(regions, 100);
  std::map<std::vector<int>, std::int32_t> piece_of_tuple;
  std::vector<std::size_t> cells(partition.pieces.size());
  for (std::size_t i = 0; i < partition.label.size(); ++i) {
    std::vector<int> tuple;
    for (const auto& own : regions) tuple.push_back(own->label[i]);
    const std::int32_t piece = partition.label[i];
    if (piece < 0) {
      REQUIRE(tuple == std::vector{-1, -1, -1});
      continue;
    }
    REQUIRE(partition.pieces[std::size_t(piece)].region == tuple);
    REQUIRE(piece_of_tuple.try_emplace(tuple, piece).first->second == piece);
    // Numbered in order of appearance.
    REQUIRE(std::size_t(piece) < piece_of_tuple.size());
    ++cells[std::size_t(piece)];
  }
  REQUIRE(piece_of_tuple.size() == partition.pieces.size());
  for (std::size_t i = 0; i < cells.size(); ++i) CHECK(cells[i] == partition.pieces[i].cells);
}
