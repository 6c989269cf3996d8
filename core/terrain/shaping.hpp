#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/paint.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/terrain/drawn_water.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// The ground as it is computed with: the terrain with painted heights (m, final = lerp(height, value, coverage); null: none),
/// then lakes dug and river beds carved. A bed falls monotonically from head to end, is as wide and deep as its discharge asks
/// (river_width, river_depth) and has banks no steeper than 1 : 1 (our choice). A lake's basin lies inside its shore, its surface
/// at the lowest ground along the shore. Everything else of the terrain is kept. Deterministic for any thread count.
[[nodiscard]] Terrain shaped_terrain(const Terrain& terrain, const PaintLayer* heights, const DrawnWater& water);

/// What flows into the ground at the heads of drawn rivers: the catchment areas that give their discharge at this runoff (m /
/// year).
[[nodiscard]] std::vector<Inflow> inflows_of(const DrawnWater& water, const Terrain& terrain, double runoff);

/// Cells of a map, in ascending order, that lie in the basins of drawn lakes: water stands there however little it is.
[[nodiscard]] std::vector<std::uint32_t> cells_of_lakes(std::span<const DrawnLake> lakes, const Rect& map);

/// The smooth curve through points that rivers and shores follow (a centripetal Catmull-Rom spline), as points at most `step`
/// cells apart; closed curves end where they begin.
[[nodiscard]] std::vector<PathPoint> smooth_line(std::span<const PathPoint> points, bool closed, float step = 0.5F);

}  // namespace biotope
