#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/terrain/drawn_water.hpp"
#include "core/terrain/terrain.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// The stages of shaped_terrain after paint, in order.

/// A lake that was dug.
struct LakeBasin {
  enum Part : std::uint8_t { outside, rim, basin };
  /// Cells of the map that `parts` covers.
  Rect bounds;
  /// Rim cells lie inside the shore beside cells outside; they keep the water in.
  Grid<std::uint8_t> parts;
  /// Height of the water, m.
  float surface = 0;

  [[nodiscard]] Part part(int x, int y) const {
    return bounds.contains(x, y) ? Part(parts(x - bounds.x0, y - bounds.y0)) : outside;
  }
};

/// Which of the tiles (small_side) of a map a lake or river has to do with: those with cells whose height it read or changed, or
/// that its outline covers. What happens to the ground elsewhere does not concern it.
using TouchedTiles = TileSet;

/// Digs a lake and appends it to those dug before it, where it has a place and holds water.
void dig_lake(Terrain& terrain, const DrawnLake& drawn, std::vector<LakeBasin>& lakes, TouchedTiles& touched);

/// Carves the beds of rivers, one after the other; through lakes they keep to the water's surface.
void carve_rivers(Terrain& terrain, std::span<const DrawnRiver* const> rivers, std::span<const LakeBasin> lakes,
                  std::span<TouchedTiles> touched);

/// A cell and the height it is cut down to, if it is higher.
struct CutCell {
  std::size_t cell = 0;
  float level = 0;
};

/// Cuts cells down and gives the cuts banks that rise at most 1 : 1 to where they meet the ground. Banks cut nothing of lakes
/// below their surface.
void cut_with_banks(Grid<float>& height, double cell_size, std::span<const CutCell> cells, std::span<const LakeBasin> lakes,
                    TouchedTiles& touched);

}  // namespace biotope
