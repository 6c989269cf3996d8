#include "core/base/random.hpp"

#include <catch2/catch.hpp>
#include <array>
#include <set>

using namespace biotope;

TEST_CASE("Random values depend on every counter and on nothing else") {
  CHECK(random_bits({1, 2, 3}) == random_bits({1, 2, 3}));
  CHECK(random_bits({1, 2, 3}) != random_bits({1, 3, 2}));
  CHECK(random_bits({1, 2, 3}) != random_bits({2, 2, 3}));
  CHECK(random_bits({1, 2}) != random_bits({1, 2, 0}));
}

TEST_CASE("Unit values are spread evenly over 0..1") {
  std::array<int, 10> counts{};
  double sum = 0;
  constexpr int draws = 100000;
  for (std::uint64_t i = 0; i < draws; ++i) {
    const double value = random_unit({42, i});
    REQUIRE(value >= 0);
    REQUIRE(value < 1);
    ++counts[std::size_t(value * 10)];
    sum += value;
  }
  CHECK(sum / draws == Approx(0.5).margin(0.005));
  for (const int count : counts) CHECK(count == Approx(draws / 10).margin(500));
}

TEST_CASE("Integers reach both ends of their interval") {
  std::set<int> seen;
  for (std::uint64_t i = 0; i < 200; ++i) seen.insert(random_int(-1, 2, {7, i}));
  CHECK(seen == std::set<int>{-1, 0, 1, 2});
}
