#pragma once

#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

enum class WaterKind : std::uint8_t { dry, river, lake, sea };

/// A river that enters the map: water from a catchment that lies outside. On the border, no water leaves through the cells beside
/// it.
struct Inflow {
  /// Cell where it enters.
  int x = 0;
  int y = 0;
  /// Area of the catchment upstream, m2.
  double catchment_area = 0;
};

/// A place where a river is shallow between passable banks.
struct Ford {
  int x = 0;
  int y = 0;
  /// Water depth, m.
  float depth = 0;
};

/// One reach of a river from a source or junction to the next junction, lake or border.
struct RiverReach {
  /// Cells from upstream to downstream.
  std::vector<std::uint32_t> cells;
  /// Mean yearly discharge at the downstream end, m3/s.
  float discharge = 0;
  /// Width and depth at the downstream end, m.
  float width = 0;
  float depth = 0;
};

/// Where water goes and stands.
struct Hydrology {
  /// Height of the ground with every depression filled to its spill level, m; equals the water surface of a lake.
  Grid<float> filled;
  /// Upslope area by multiple-flow-direction (FD8, exponent 1.1), m2, own cell and inflows included.
  Grid<float> catchment_area;
  /// Standing or flowing water above the ground, m; 0 where dry.
  Grid<float> water_depth;
  /// Mean yearly discharge of the channel through the cell, m3/s (D8); 0 where no channel runs.
  Grid<float> discharge;
  Grid<WaterKind> water;
  /// D8 receiver 0..7 clockwise from east (E, SE, S, SW, W, NW, N, NE); 8 where water leaves the map.
  Grid<std::uint8_t> receiver;
  std::vector<RiverReach> reaches;
  std::vector<Ford> fords;
};

struct HydrologyOptions {
  /// Water that runs off the ground in a year, m (precipitation less evaporation).
  double runoff = 0.3;
  /// A channel begins where its mean discharge reaches this, m3/s. Our choice: a brook one steps over.
  double channel_discharge = 0.01;
  /// Depressions shallower or smaller than these are noise of the DEM, not lakes. Our choice.
  float lake_depth = 0.5F;
  double lake_area = 2500;
  /// Cells below this height connected to the border are sea, m.
  float sea_level = 0;
  std::vector<Inflow> inflows;
  /// Cells, in ascending order, where a person drew a lake: a depression with one of them is a lake however small it is.
  std::vector<std::uint32_t> lake_cells = {};
};

/// Depressions (priority-flood), FD8 accumulation, D8 channels, width = 4.5 Q^0.5 m and depth = 0.3 Q^0.4 m,
/// lakes, sea and fords. Water is conserved: what leaves at the border and into the sea is what fell and entered.
/// Deterministic for any thread count. O(n log n); nothing when stopped.
[[nodiscard]] Result<Hydrology> compute_hydrology(const Terrain& terrain, const HydrologyOptions& options,
                                                  const TaskContext& context = {});

/// Mean yearly discharge (m3/s) of a catchment (m2) from which `runoff` metres of water run off in a year.
[[nodiscard]] float mean_discharge(double catchment_area, double runoff);
/// Width (m) of a river of mean discharge Q (m3/s): 4.5 Q^0.5 (downstream hydraulic geometry).
[[nodiscard]] float river_width(float discharge);
/// Depth (m) of a river of mean discharge Q (m3/s): 0.3 Q^0.4.
[[nodiscard]] float river_depth(float discharge);

}  // namespace biotope
