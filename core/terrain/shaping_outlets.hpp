#pragma once

#include <span>
#include <vector>

#include "core/terrain/shaping_parts.hpp"

namespace biotope {

/// Where a carved bed ends.
struct BedEnd {
  int x = 0;
  int y = 0;
  float bed = 0;     ///< height, m
  float ground = 0;  ///< before it was carved, m
  /// Half the river's width, cells.
  double half_width = 0;
};

/// A narrow channel from the end of a bed, which lies below the ground around it, to where the ground is as low: without one the
/// river would stand in its own bed. The way of least digging, never through ground higher than at the end itself; none where
/// there is no such way, as in a hollow. `bed` are the river's own cells: they are crossed at the end only.
[[nodiscard]] std::vector<CutCell> lead_out(const Terrain& terrain, const BedEnd& end, std::span<const CutCell> bed,
                                            std::span<const LakeBasin> lakes, TouchedTiles& touched);

}  // namespace biotope
