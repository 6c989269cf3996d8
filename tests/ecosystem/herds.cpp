#include "core/ecosystem/herds.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

using namespace biotope;

TEST_CASE("herd sizes lie in the species' range and add up to the population") {
  for (int smallest = 1; smallest <= 12; ++smallest) {
    for (const int largest : {smallest, smallest + 1, 2 * smallest, 5 * smallest}) {
      for (int herds = 1; herds <= 40; ++herds) {
        const std::vector<int> sizes = herd_sizes(herds * smallest, smallest, largest, 7, std::uint64_t(herds));
        REQUIRE(std::accumulate(sizes.begin(), sizes.end(), 0) == herds * smallest);
        REQUIRE(std::all_of(sizes.begin(), sizes.end(), [&](int size) { return size >= smallest && size <= largest; }));
      }
    }
  }
}

TEST_CASE("herds of a species differ in size, and the seed changes them") {
  const std::vector<int> sizes = herd_sizes(600, 5, 25, 1, 3);
  CHECK(std::set<int>(sizes.begin(), sizes.end()).size() > 8);
  CHECK(sizes.size() > 25);
  CHECK(sizes.size() < 60);
  CHECK(sizes == herd_sizes(600, 5, 25, 1, 3));
  CHECK(sizes != herd_sizes(600, 5, 25, 2, 3));
  CHECK(sizes != herd_sizes(600, 5, 25, 1, 4));
}

TEST_CASE("numbers that no herd size divides still add up") {
  CHECK(herd_sizes(0, 5, 9, 1, 1).empty());
  CHECK(herd_sizes(3, 5, 9, 1, 1) == std::vector{3});
  const std::vector<int> between = herd_sizes(15, 10, 12, 1, 1);
  CHECK(std::accumulate(between.begin(), between.end(), 0) == 15);
}
