#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

// Flow on a ground that changed in some tiles. Each of these equals, to the bit, what the stage of the same name in
// flow_routing.hpp makes of the whole ground.

/// Directions after the filled ground or the sea changed in some tiles: `receiver` holds those of before and gets those of now;
/// returns the tiles in which they differ.
[[nodiscard]] TileSet update_flow_directions(const Grid<float>& filled, const Grid<std::uint8_t>& sea,
                                             const Grid<std::uint8_t>& inlets, const TileSet& changed,
                                             const Grid<std::uint8_t>& before, Grid<std::uint8_t>& receiver);

/// Filled heights and the directions of flow on them.
struct FlowGround {
  const Grid<float>& filled;
  const Grid<std::uint8_t>& receiver;
};

/// Cells upstream after directions changed in some tiles; returns the cells that were looked at, some of them more than once: in
/// all others the number is the same.
[[nodiscard]] std::vector<std::uint32_t> update_upstream_cells(const FlowGround& before, const FlowGround& after,
                                                               const TileSet& moved, Grid<std::uint32_t>& cells);

/// Upslope areas (see multiple_flow_area). Water is counted in whole units, so that where and how much of it flows does not
/// depend on the order of sums, and a change is carried downstream to where it no longer counts.
class CatchmentField {
 public:
  using Units = std::int64_t;

  [[nodiscard]] Grid<float> restart(const Grid<float>& filled, const Grid<std::uint8_t>& receiver, double cell_area,
                                    std::span<const Inflow> inflows);
  /// Whether water would be counted in the same units.
  [[nodiscard]] bool can_follow(double cell_area, std::span<const Inflow> inflows) const;
  /// After heights or directions changed in some tiles, or the inflows did: `area` holds the areas of before and gets those of
  /// now; returns the tiles in which they differ.
  [[nodiscard]] TileSet update(const FlowGround& before, const FlowGround& after, const TileSet& moved,
                               std::span<const Inflow> inflows, Grid<float>& area);

 private:
  [[nodiscard]] float area_of(Units water) const { return float(double(water) * unit_); }

  double unit_ = 0;
  std::vector<Inflow> inflows_;
  Grid<Units> water_;
};

}  // namespace biotope
