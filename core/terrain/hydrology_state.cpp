#include "core/terrain/hydrology_state.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/tile_changes.hpp"
#include "core/terrain/water_marking.hpp"
#include "core/terrain/water_updates.hpp"

namespace biotope {

bool HydrologyCopy::fork(const Hydrology& from, Hydrology& to) {
  return fork_of(from.filled, to.filled) && fork_of(from.catchment_area, to.catchment_area) &&
         fork_of(from.water_depth, to.water_depth) && fork_of(from.discharge, to.discharge) && fork_of(from.water, to.water) &&
         fork_of(from.receiver, to.receiver);
}

Hydrology HydrologyCopy::value(const Hydrology& from) {
  Hydrology copy;
  copy.filled = copy_of(from.filled);
  copy.catchment_area = copy_of(from.catchment_area);
  copy.water_depth = copy_of(from.water_depth);
  copy.discharge = copy_of(from.discharge);
  copy.water = copy_of(from.water);
  copy.receiver = copy_of(from.receiver);
  copy.reaches = from.reaches;
  copy.fords = from.fords;
  return copy;
}

void HydrologyCopy::tiles(const Hydrology& from, Hydrology& to, const TileSet& tiles) {
  copy_tiles(from.filled, to.filled, tiles);
  copy_tiles(from.catchment_area, to.catchment_area, tiles);
  copy_tiles(from.water_depth, to.water_depth, tiles);
  copy_tiles(from.discharge, to.discharge, tiles);
  copy_tiles(from.water, to.water, tiles);
  copy_tiles(from.receiver, to.receiver, tiles);
  to.reaches = from.reaches;
  to.fords = from.fords;
}

namespace {

Status check_inflows(const Terrain& terrain, const HydrologyOptions& options) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  if (width == 0 || height == 0) return fail("hydrology: the terrain has no cells");
  for (const Inflow& inflow : options.inflows) {
    if (!terrain.height.contains(inflow.x, inflow.y)) {
      return fail("hydrology: a river enters at cell (" + std::to_string(inflow.x) + ", " + std::to_string(inflow.y) +
                  "), which is outside the terrain of " + std::to_string(width) + " x " + std::to_string(height) + " cells");
    }
  }
  return {};
}

/// Whether everything but the inflows is the same.
bool same_setting(const HydrologyOptions& a, const HydrologyOptions& b) {
  return a.runoff == b.runoff && a.channel_discharge == b.channel_discharge && a.lake_depth == b.lake_depth &&
         a.lake_area == b.lake_area && a.sea_level == b.sea_level;
}

bool same_inflows(const std::vector<Inflow>& a, const std::vector<Inflow>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Inflow& one, const Inflow& other) {
    return one.x == other.x && one.y == other.y && one.catchment_area == other.catchment_area;
  });
}

/// Tiles with a cell that is of a drawn lake in one setting alone.
TileSet differing_lakes(const HydrologyOptions& a, const HydrologyOptions& b, const Grid<float>& height) {
  TileSet tiles(height.width(), height.height());
  if (a.lake_cells == b.lake_cells) return tiles;
  std::vector<std::uint32_t> cells;
  std::ranges::set_symmetric_difference(a.lake_cells, b.lake_cells, std::back_inserter(cells));
  for (const std::uint32_t cell : cells) tiles.insert_cell(cell);
  return tiles;
}

bool same_fords(const std::vector<Ford>& a, const std::vector<Ford>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Ford& one, const Ford& other) {
    return one.x == other.x && one.y == other.y && one.depth == other.depth;
  });
}

}  // namespace

Result<Hydrology> HydrologyState::compute(const Terrain& terrain, const HydrologyOptions& options, const TaskContext& context) {
  if (Status usable = check_inflows(terrain, options); !usable) return tl::unexpected<Error>(usable.error());
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Hydrology result;
  context.report("depressions", 0);
  sea_ = find_sea(terrain.height, options.sea_level);
  const Grid<std::uint8_t>& sea = sea_;
  inlets_ = find_inlets(terrain, options);
  result.filled = depressions_.restart(terrain.height, sea, options.sea_level, inlets_);
  if (context.stopped()) return fail("stopped");
  context.report("flow directions", 0.35);
  result.receiver = flow_directions(result.filled, sea, inlets_);
  result.water_depth = Grid<float>::shareable(width, height);
  result.discharge = Grid<float>::shareable(width, height);
  static_assert(int(WaterKind::dry) == 0);
  result.water = Grid<WaterKind>::shareable(width, height);
  if (context.stopped()) return fail("stopped");
  context.report("flow accumulation", 0.5);
  tbb::parallel_invoke(
      [&] { result.catchment_area = catchments_.restart(result.filled, result.receiver, terrain.cell_area(), options.inflows); },
      [&] {
        mark_standing_water(terrain, sea, options, result);
        upstream_ = mark_discharge(terrain, options, result);
      });
  if (context.stopped()) return fail("stopped");
  context.report("rivers", 0.9);
  trace_reaches(result);
  mark_rivers(terrain, result);
  find_fords(terrain, result);
  return result;
}

bool HydrologyState::can_follow(const Terrain& terrain, const TileSet& changed, const HydrologyOptions& options) const {
  if (!land_ || changed.every() || !same_setting(options_, options)) return false;
  if (!catchments_.can_follow(terrain.cell_area(), options.inflows)) return false;
  return same_inflows(options_.inflows, options.inflows) || find_inlets(terrain, options) == inlets_;
}

Status HydrologyState::update(const std::shared_ptr<const Terrain>& land, const TileSet& changed, const HydrologyOptions& options,
                              const TaskContext& context) {
  if (Status usable = check_inflows(*land, options); !usable) return usable;
  if (can_follow(*land, changed, options)) {
    follow(*land, changed, options);
  } else {
    land_ = nullptr;
    auto made = compute(*land, options, context);
    if (!made) return tl::unexpected<Error>(made.error());
    hydrology_.restart(std::make_shared<Hydrology>(std::move(*made)));
    changes_.note_all(land->height.width(), land->height.height());
  }
  land_ = land;
  options_ = options;
  return {};
}

TileSet HydrologyState::update_sea(const Terrain& terrain, const TileSet& heights, float sea_level) {
  const Grid<float>& before = land_->height;
  const Grid<float>& now = terrain.height;
  const TileSet crossed = changed_tiles(heights, [&](const Rect& rect) {
    bool any = false;
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) any = any || (before(x, y) < sea_level) != (now(x, y) < sea_level);
    }
    return any;
  });
  if (!crossed.any()) return crossed;
  Grid<std::uint8_t> sea = find_sea(now, sea_level);
  if (sea.empty() && sea_.empty()) return TileSet(now.width(), now.height());
  const Grid<std::uint8_t> none(now.width(), now.height());
  TileSet coast = differing_tiles_of(sea.empty() ? none : sea, sea_.empty() ? none : sea_);
  sea_ = std::move(sea);
  return coast;
}

void HydrologyState::follow(const Terrain& terrain, const TileSet& heights, const HydrologyOptions& options) {
  const TileSet drawn = differing_lakes(options_, options, terrain.height);
  if (!heights.any() && !drawn.any() && same_inflows(options_.inflows, options.inflows)) return;
  const auto before = hydrology_.newest();
  auto next = hydrology_.copy();
  const TileSet coast = update_sea(terrain, heights, options.sea_level);
  const TileSet ground = heights | coast;
  const TileSet filled = coast | depressions_.update(terrain.height, sea_, options.sea_level, inlets_, ground, next->filled);
  const TileSet moved = filled | update_flow_directions(next->filled, sea_, inlets_, filled, before->receiver, next->receiver);
  const FlowGround flow_before{before->filled, before->receiver};
  const FlowGround flow_now{next->filled, next->receiver};
  TileSet changed = moved | catchments_.update(flow_before, flow_now, moved, options.inflows, next->catchment_area);
  std::vector<std::uint32_t> other_flow = update_upstream_cells(flow_before, flow_now, moved, upstream_);
  TileSet watered = clear_rivers(*next);
  const auto lakes = update_standing_water({*land_, *before}, terrain, sea_, ground | filled | drawn, options, *next);
  for (const std::uint32_t cell : lakes) watered.insert_cell(cell);
  other_flow.insert(other_flow.end(), lakes.begin(), lakes.end());
  changed |= update_discharge(terrain, options, upstream_, *before, {std::move(other_flow), options_.inflows}, *next);
  next->reaches.clear();
  next->fords.clear();
  trace_reaches(*next);
  mark_rivers(terrain, *next);
  find_fords(terrain, *next);
  watered |= ground | tiles_of_rivers(terrain, *next);
  changed |= changed_tiles(watered, [&](const Rect& rect) {
    return !same_cells(next->water, before->water, rect) || !same_cells(next->water_depth, before->water_depth, rect);
  });
  // Fords look at the ground beside them too.
  if (!same_fords(next->fords, before->fords)) changed |= heights;
  hydrology_.put(std::move(next), changed);
  if (changed.any()) changes_.note(changed);
}

}  // namespace biotope
