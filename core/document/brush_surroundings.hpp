#pragma once

#include <vector>

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"

namespace biotope {

/// What lies around each cell of a rectangle, row by row: mean, least and greatest final value of the square of
/// (2 reach + 1)^2 cells. Beyond the map's border its nearest cell counts.
struct Surroundings {
  std::vector<float> mean;
  std::vector<float> least;     ///< empty unless asked for
  std::vector<float> greatest;  ///< empty unless asked for
};

/// `layer` may be null: nothing is painted. Running sums, O(cells + border); a flat map has exactly its own value as mean.
[[nodiscard]] Surroundings surroundings(const PaintLayer* layer, const Grid<float>& computed, Rect cells, int reach,
                                        bool extremes);

}  // namespace biotope
