#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/rect.hpp"

namespace biotope {

/// GDAL's affine transform from (column, row) to coordinates.
using AffineTransform = std::array<double, 6>;

struct PlanePoint {
  double x = 0;
  double y = 0;
};

[[nodiscard]] PlanePoint apply(const AffineTransform& transform, PlanePoint cell);
/// The inverse transform; the determinant must not be 0.
[[nodiscard]] AffineTransform inverse(const AffineTransform& transform);

/// Moves points from the target CRS to the source CRS, in place; a point that cannot be moved becomes NaN.
using MovePoints = std::function<void(std::vector<PlanePoint>&)>;

/// A target grid over a source.
struct WarpPlan {
  int width = 0;
  int height = 0;
  AffineTransform target_transform{};
  AffineTransform source_transform{};
  /// Empty when both share a CRS.
  MovePoints to_source;
};

/// A warped grid: NaN where the source has no data, and the largest part found without cells outside the source.
struct WarpedHeights {
  Grid<float> height;
  /// Target cells of the plan that were kept.
  Rect kept;
};

/// Bilinear resampling of `source` (NaN: no data) on the plan's grid. Coordinates are exact every 16 cells and linear between.
[[nodiscard]] WarpedHeights warp_heights(const Grid<float>& source, const WarpPlan& plan);

}  // namespace biotope
