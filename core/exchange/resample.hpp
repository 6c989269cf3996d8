#pragma once

#include "core/base/grid.hpp"

namespace biotope {

/// A copy on cells `ratio` times as large, `width` x `height` of them from the same north-west corner: area means when
/// ratio > 1, bilinear otherwise. Cells that reach beyond the source take its border.
[[nodiscard]] Grid<float> resampled_grid(const Grid<float>& source, double ratio, int width, int height);

}  // namespace biotope
