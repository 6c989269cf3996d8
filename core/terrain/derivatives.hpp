#pragma once

#include "core/base/grid.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// First and second derivatives of the ground.
struct Derivatives {
  /// dz/dx toward the east and dz/dy toward the north, dimensionless (rise / run).
  Grid<float> east;
  Grid<float> north;
  /// Gradient magnitude, rise / run: 1 is 45 degrees.
  Grid<float> slope;
  /// Mean curvature as the Laplacian of height, 1/m; positive in hollows.
  Grid<float> curvature;
};

/// Central differences (Horn's 3 x 3 weights), one-sided at the border. Parallel, O(cells).
[[nodiscard]] Derivatives compute_derivatives(const Terrain& terrain);

/// Direction the slope faces, radians clockwise from north, 0..2 pi; 0 on flat ground.
[[nodiscard]] float aspect(float east, float north);

}  // namespace biotope
