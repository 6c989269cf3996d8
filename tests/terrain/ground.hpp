#pragma once

#include <cmath>

#include "core/base/random.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope::test {

/// Ground from a formula height(x, y): metres east and north of the south-west cell's centre.
template <class Formula>
Terrain ground(int width, int height, double cell_size, const Formula& formula) {
  Terrain terrain;
  terrain.cell_size = cell_size;
  terrain.height = Grid<float>(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) terrain.height(x, y) = float(formula(x * cell_size, (height - 1 - y) * cell_size));
  }
  return terrain;
}

/// Hills of several sizes and cell-sized noise, `base` metres up: full of pits and passes.
inline Terrain rough_ground(int width, int height, double cell_size, std::uint64_t seed, double base = 100) {
  const auto wave = [&](double x, double y, std::uint64_t n) {
    const double angle = 6.283185307 * random_unit({seed, n, 0});
    const double phase = 6.283185307 * random_unit({seed, n, 1});
    const double length = cell_size * (4 + 60 * random_unit({seed, n, 2}));
    return length * 0.05 * std::sin(6.283185307 * (x * std::cos(angle) + y * std::sin(angle)) / length + phase);
  };
  return ground(width, height, cell_size, [&](double x, double y) {
    double z = base + cell_size * 0.1 * random_unit({seed, 1000, std::uint64_t(x / cell_size + 0.5), std::uint64_t(y / cell_size + 0.5)});
    for (std::uint64_t n = 0; n < 8; ++n) z += wave(x, y, n);
    return z;
  });
}

/// Hydrology that cannot fail here.
inline Hydrology water_of(const Terrain& terrain, const HydrologyOptions& options = {}) {
  return compute_hydrology(terrain, options).value();
}

}  // namespace biotope::test
