#include "core/terrain/hydrology.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <string>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/water_marking.hpp"

namespace biotope {

Result<Hydrology> compute_hydrology(const Terrain& terrain, const HydrologyOptions& options, const TaskContext& context) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  if (width == 0 || height == 0) return fail("hydrology: the terrain has no cells");
  for (const Inflow& inflow : options.inflows) {
    if (!terrain.height.contains(inflow.x, inflow.y)) {
      return fail("hydrology: a river enters at cell (" + std::to_string(inflow.x) + ", " + std::to_string(inflow.y) +
                  "), which is outside the terrain of " + std::to_string(width) + " x " + std::to_string(height) + " cells");
    }
  }
  Hydrology result;
  context.report("depressions", 0);
  const Grid<std::uint8_t> sea = find_sea(terrain.height, options.sea_level);
  const Grid<std::uint8_t> inlets = find_inlets(terrain, options);
  result.filled = fill_depressions(terrain.height, sea, options.sea_level, inlets);
  if (context.stopped()) return fail("stopped");
  context.report("flow directions", 0.35);
  result.receiver = flow_directions(result.filled, sea, inlets);
  result.water_depth = Grid<float>(width, height);
  result.discharge = Grid<float>(width, height);
  result.water = Grid<WaterKind>(width, height, WaterKind::dry);
  if (context.stopped()) return fail("stopped");
  context.report("flow accumulation", 0.5);
  tbb::parallel_invoke(
      [&] { result.catchment_area = multiple_flow_area(result.filled, result.receiver, terrain.cell_area(), options.inflows); },
      [&] {
        mark_standing_water(terrain, sea, options, result);
        mark_discharge(terrain, options, result);
      });
  if (context.stopped()) return fail("stopped");
  context.report("rivers", 0.9);
  trace_reaches(result);
  mark_rivers(terrain, result);
  find_fords(terrain, result);
  return result;
}

}  // namespace biotope
