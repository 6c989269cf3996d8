#include <catch2/catch.hpp>
#include <cmath>

#include "ui/gesture_overlay.hpp"

using namespace biotope;

TEST_CASE("a line laid on the ground begins and ends where it was drawn, and no piece is longer than the step") {
  const auto places = along_ground({10, 20}, {40, -20}, 7);
  REQUIRE(places.size() > 2);
  CHECK(places.front() == PathPoint{10, 20});
  CHECK(places.back() == PathPoint{40, -20});
  for (std::size_t i = 1; i < places.size(); ++i) {
    CHECK(std::hypot(places[i].x - places[i - 1].x, places[i].y - places[i - 1].y) <= 7.001F);
  }
}

TEST_CASE("a line without length is still both of its ends") { CHECK(along_ground({3, 4}, {3, 4}, 1).size() == 2); }
