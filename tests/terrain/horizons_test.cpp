#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/terrain/sun.hpp"
#include "tests/terrain/ground.hpp"

using namespace biotope;
using namespace biotope::test;

namespace {

/// Tangent of the horizon by looking at every place along a line, `step` cells apart (x east, y south).
double marched(const Terrain& terrain, int x, int y, double dx, double dy) {
  double tangent = 0;
  const double here = double(terrain.height(x, y));
  for (int k = 1;; ++k) {
    const double px = x + k * dx;
    const double py = y + k * dy;
    if (px < 0 || py < 0 || px > terrain.height.width() - 1 || py > terrain.height.height() - 1) return tangent;
    const double run = k * std::hypot(dx, dy) * terrain.cell_size;
    tangent = std::max(tangent, (double(sample_bilinear(terrain.height, px, py)) - here) / run);
  }
}

}  // namespace

TEST_CASE("horizons toward the eight winds are those of marching cell by cell") {
  const Terrain rough = rough_ground(43, 37, 5, 11);
  const Horizons horizons = compute_horizons(rough, 8, 1);
  REQUIRE(horizons.sectors.size() == 8);
  CHECK(horizons.stride == 1);
  for (std::size_t s = 0; s < 8; ++s) {
    const double azimuth = double(s) * std::numbers::pi / 4;
    const double dx = std::round(std::sin(azimuth) * 1.1);
    const double dy = -std::round(std::cos(azimuth) * 1.1);
    for (int y = 0; y < 37; ++y) {
      for (int x = 0; x < 43; ++x) REQUIRE(horizons.sectors[s](x, y) == Approx(marched(rough, x, y, dx, dy)).margin(1e-4));
    }
  }
}

TEST_CASE("horizons in between are close to those of marching along the true direction") {
  const Terrain hills = ground(60, 50, 10, [](double x, double y) {
    return 100 + 40 * std::sin(x / 90) * std::cos(y / 70) + 15 * std::sin((x + 2 * y) / 60);
  });
  const Horizons horizons = compute_horizons(hills, 16, 1);
  for (std::size_t s = 1; s < 16; s += 2) {
    const double azimuth = double(s) * std::numbers::pi / 8;
    double error = 0;
    double sum = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 60; ++x) {
        const double expected = marched(hills, x, y, 0.5 * std::sin(azimuth), -0.5 * std::cos(azimuth));
        const double difference = std::abs(double(horizons.sectors[s](x, y)) - expected);
        error += difference;
        sum += expected;
      }
    }
    // Lines run from cell to cell, so that a horizon is up to half a cell beside the true direction.
    CHECK(error < 0.12 * sum);
  }
}

TEST_CASE("a wall stands as high as its height over its distance, on one side only") {
  const Terrain wall = ground(31, 31, 2, [](double, double y) { return y > 39 && y < 41 ? 10.0 : 0.0; });  // row 10
  const Horizons horizons = compute_horizons(wall, 16, 1);
  CHECK(horizons.sectors[0](15, 20) == Approx(0.5));
  CHECK(horizons.sectors[0](15, 15) == Approx(1));
  CHECK(horizons.sectors[8](15, 20) == 0);
  CHECK(horizons.sectors[8](15, 5) == Approx(1));
  CHECK(horizons.sectors[0](15, 10) == 0);
  CHECK(horizons.sectors[4](15, 20) == 0);
}

TEST_CASE("a coarser horizon grid sees the same far ridge") {
  const Terrain ridge = ground(130, 101, 10, [](double x, double) { return x > 1000 ? 200.0 : 0.0; });
  const Horizons fine = compute_horizons(ridge, 16, 1);
  const Horizons coarse = compute_horizons(ridge, 16, 4);
  CHECK(coarse.stride == 4);
  CHECK(coarse.sectors[4].width() == 33);
  CHECK(coarse.sectors[4].height() == 26);
  for (const int x : {0, 8, 20, 40}) CHECK(coarse.sectors[4](x / 4, 10) == Approx(fine.sectors[4](x + 2, 42)).epsilon(0.1));
}
