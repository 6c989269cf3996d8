#pragma once

#include <cstdint>

#include "core/base/grid.hpp"

namespace biotope {

/// 1 where a height is NaN.
[[nodiscard]] Grid<std::uint8_t> missing_cells(const Grid<float>& height);

/// Gives every cell marked in `missing` a height that continues its surroundings smoothly: the pyramid of means of known cells
/// gives a first guess from coarse to fine, and a few relaxations toward the mean of the four neighbours remove its
/// steps. Known cells keep their height to the bit. O(cells). At least one cell must be known.
void fill_missing(Grid<float>& height, const Grid<std::uint8_t>& missing);

}  // namespace biotope
