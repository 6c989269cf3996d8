#include "core/terrain/derivatives.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {
constexpr float pi = std::numbers::pi_v<float>;
}

TEST_CASE("a plane has the same slope everywhere, borders and corners included") {
  for (const double cell : {1.0, 30.0, 180.0}) {
    const Terrain plane = ground(7, 5, cell, [](double x, double y) { return 50 + 0.3 * x - 0.4 * y; });
    const Derivatives d = compute_derivatives(plane);
    for (std::size_t i = 0; i < d.slope.size(); ++i) {
      CHECK(d.east[i] == Approx(0.3).epsilon(1e-4));
      CHECK(d.north[i] == Approx(-0.4).epsilon(1e-4));
      CHECK(d.slope[i] == Approx(0.5).epsilon(1e-4));
      CHECK(d.curvature[i] * cell == Approx(0).margin(1e-4));
    }
  }
}

TEST_CASE("ground faces where it falls: clockwise from north") {
  CHECK(aspect(0, -1) == Approx(0).margin(1e-6));
  CHECK(aspect(-1, 0) == Approx(pi / 2));
  CHECK(aspect(0, 1) == Approx(pi));
  CHECK(aspect(1, 0) == Approx(1.5F * pi));
  CHECK(aspect(-1, -1) == Approx(pi / 4));
  CHECK(aspect(0, 0) == 0);
}

TEST_CASE("a cone is equally steep all round and faces away from its top") {
  const double middle = 100;
  const Terrain cone = ground(101, 101, 2, [&](double x, double y) { return 200 - 0.6 * std::hypot(x - middle, y - middle); });
  const Derivatives d = compute_derivatives(cone);
  for (int y = 5; y < 96; ++y) {
    for (int x = 5; x < 96; ++x) {
      const double east = x - 50.0;
      const double north = 50.0 - y;
      if (std::hypot(east, north) < 10) continue;
      REQUIRE(d.slope(x, y) == Approx(0.6).epsilon(0.01));
      const double away = std::atan2(east, north);
      REQUIRE(std::cos(double(aspect(d.east(x, y), d.north(x, y))) - away) == Approx(1).margin(1e-3));
    }
  }
}

TEST_CASE("a bowl curves up by its Laplacian, a dome down, a saddle not at all") {
  const auto curvature = [](double a, double b) {
    const Terrain surface = ground(9, 9, 3, [&](double x, double y) { return a * (x - 12) * (x - 12) + b * (y - 12) * (y - 12); });
    return compute_derivatives(surface).curvature(4, 4);
  };
  CHECK(curvature(0.01, 0.02) == Approx(0.06).epsilon(1e-4));
  CHECK(curvature(-0.01, -0.02) == Approx(-0.06).epsilon(1e-4));
  CHECK(curvature(0.01, -0.01) == Approx(0).margin(1e-6));
}

TEST_CASE("the bottom line of a V-shaped valley is level across and a hollow") {
  const Terrain valley = ground(21, 11, 5, [](double x, double y) { return 0.4 * std::abs(x - 50) + 0.1 * y; });
  const Derivatives d = compute_derivatives(valley);
  for (int y = 1; y < 10; ++y) {
    CHECK(d.east(10, y) == Approx(0).margin(1e-5));
    CHECK(d.slope(10, y) == Approx(0.1).epsilon(1e-3));
    CHECK(d.curvature(10, y) == Approx(2 * 0.4 / 5).epsilon(1e-3));
    CHECK(d.curvature(4, y) == Approx(0).margin(1e-5));
    CHECK(d.east(4, y) == Approx(-0.4).epsilon(1e-3));
    CHECK(d.east(16, y) == Approx(0.4).epsilon(1e-3));
  }
}

TEST_CASE("terrain of one row, one column or one cell has no slope across it") {
  const auto slope = [](double x, double y) { return x + 2 * y; };
  const Derivatives cell = compute_derivatives(ground(1, 1, 10, slope));
  CHECK(cell.slope(0, 0) == 0);
  const Derivatives row = compute_derivatives(ground(4, 1, 10, slope));
  const Derivatives column = compute_derivatives(ground(1, 4, 10, slope));
  for (int i = 0; i < 4; ++i) {
    CHECK(row.east(i, 0) == Approx(1));
    CHECK(row.north(i, 0) == 0);
    CHECK(column.east(0, i) == 0);
    CHECK(column.north(0, i) == Approx(2));
  }
}
