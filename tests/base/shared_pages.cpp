#include <catch2/catch.hpp>
#include <numeric>

#include "core/base/grid.hpp"

using namespace biotope;

namespace {

Grid<int> counted(int width, int height) {
  auto grid = Grid<int>::shareable(width, height);
  std::iota(grid.cells().begin(), grid.cells().end(), 0);
  return grid;
}

}  // namespace

TEST_CASE("a new shareable raster holds zeros") {
  const auto grid = Grid<float>::shareable(37, 5);
  CHECK(grid.rect() == Rect{0, 0, 37, 5});
  for (const float cell : grid.cells()) CHECK(cell == 0);
}

TEST_CASE("a fork is equal, and what is written to it is seen by nobody else") {
  const Grid<int> first = counted(300, 200);
  Grid<int> one = first.fork();
  const Grid<int> other = first.fork();
  if (one.empty()) return;  // Where the system cannot share pages.
  REQUIRE(one == first);
  one(299, 199) = -7;
  one(0, 0) = -1;
  CHECK(first == counted(300, 200));
  CHECK(other == first);
  CHECK(one(299, 199) == -7);
  CHECK(one(1, 0) == 1);
}

TEST_CASE("a fork of a fork shows the first raster") {
  const Grid<int> first = counted(300, 200);
  Grid<int> one = first.fork();
  if (one.empty()) return;
  one(5, 5) = -1;
  CHECK(one.fork() == first);
}

TEST_CASE("a fork lives on without the raster it came from") {
  Grid<int> fork;
  {
    const Grid<int> first = counted(64, 64);
    fork = first.fork();
  }
  if (fork.empty()) return;
  CHECK(fork == counted(64, 64));
  const Grid<int> again = fork.fork();
  CHECK(again == fork);
}

TEST_CASE("copies of rasters that share pages are their own") {
  Grid<int> first = counted(20, 20);
  const Grid<int> copy = first;
  const Grid<int> moved = std::move(first);
  CHECK(copy == moved);
  CHECK(copy.fork().empty());
  Grid<int> assigned(3, 3, 9);
  assigned = copy;
  assigned(0, 0) = 5;
  CHECK(copy(0, 0) == 0);
}
