#pragma once

#include <array>
#include <cstdint>

#include "core/base/grid.hpp"

namespace biotope {

/// Coherent noise for brushes: gradient noise (Perlin 2002, 'Improving noise') of values -1..1 that depends on (seed, size, cell)
/// only. Made for a rectangle of cells, so that the lattice is drawn once.
class BrushNoise {
 public:
  /// `size`: distance of the lattice's points, cells; at least 1.
  BrushNoise(std::uint64_t seed, float size, Rect cells);
  [[nodiscard]] float operator()(int x, int y) const;

 private:
  float inverse_size_;
  int first_x_;
  int first_y_;
  Grid<std::array<float, 2>> gradients_;
};

}  // namespace biotope
