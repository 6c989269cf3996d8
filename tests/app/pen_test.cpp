#include <catch2/catch.hpp>

#include "app/pen.hpp"

using namespace biotope;

TEST_CASE("pressure is the share of the pen's axis, and whole for an axis without a range") {
  CHECK(axis_share(0, 0, 2048) == 0);
  CHECK(axis_share(512, 0, 2048) == Approx(0.25));
  CHECK(axis_share(4096, 0, 2048) == 1);
  CHECK(axis_share(-5, 0, 2048) == 0);
  CHECK(axis_share(7, 3, 3) == 1);
}
