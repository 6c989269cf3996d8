#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/terrain/neighbours.hpp"
#include "core/terrain/tile_changes.hpp"
#include "core/terrain/water_marking.hpp"
#include "core/terrain/water_updates.hpp"

namespace biotope {
namespace {

/// Riffles and pools: at the same discharge and width, depth goes as slope^-0.3 (Manning's equation for a wide channel), so a
/// stretch steeper than its surroundings is shallower. Bounds are our choice.
constexpr float riffle_exponent = -0.3F;
constexpr float shallowest_riffle = 0.6F;
constexpr float deepest_pool = 1.5F;
/// Slope below which water no longer feels the bed's, rise / run. Our choice.
constexpr float least_bed_slope = 2e-4F;
/// A bank steeper than this is not under water however near the channel, rise / run. Our choice.
constexpr float flooded_bank_slope = 0.25F;

/// Lengths along a reach from its upstream end, m.
std::vector<float> distances_along(const RiverReach& reach, int width, float cell_size) {
  std::vector<float> along(reach.cells.size(), 0.0F);
  for (std::size_t i = 1; i < along.size(); ++i) {
    const std::uint32_t step =
        reach.cells[i] > reach.cells[i - 1] ? reach.cells[i] - reach.cells[i - 1] : reach.cells[i - 1] - reach.cells[i];
    const bool straight = step == 1 || step == std::uint32_t(width);
    along[i] = along[i - 1] + cell_size * (straight ? 1.0F : 1.41421356F);
  }
  return along;
}

/// Mean fall within `reach_out` metres up and down of each point.
std::vector<float> bed_slopes(const RiverReach& reach, const Grid<float>& filled, std::span<const float> along, float reach_out) {
  std::vector<float> slopes(along.size(), 0.0F);
  std::size_t up = 0;
  std::size_t down = 0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    while (along[i] - along[up] > reach_out) ++up;
    while (down + 1 < along.size() && along[down] - along[i] < reach_out) ++down;
    const float run = along[down] - along[up];
    if (run > 0) slopes[i] = (filled[reach.cells[up]] - filled[reach.cells[down]]) / run;
  }
  return slopes;
}

/// Puts water of the channel on the cells within half its width that do not rise above it; deepest in the middle.
void flood_width(const Terrain& terrain, std::uint32_t cell, float width, float depth, Hydrology& hydrology) {
  const float radius = width / 2 / float(terrain.cell_size);
  const int reach = int(radius);
  const int cx = int(cell % std::uint32_t(terrain.height.width()));
  const int cy = int(cell / std::uint32_t(terrain.height.width()));
  const float bed = terrain.height[cell];
  for (int y = cy - reach; y <= cy + reach; ++y) {
    for (int x = cx - reach; x <= cx + reach; ++x) {
      if (!terrain.height.contains(x, y)) continue;
      const auto square = float((x - cx) * (x - cx) + (y - cy) * (y - cy));
      if (square > radius * radius && square > 0) continue;
      const WaterKind kind = hydrology.water(x, y);
      if (kind == WaterKind::lake || kind == WaterKind::sea) continue;
      const float rise = terrain.height(x, y) - bed;
      if (rise > std::max(depth, std::sqrt(square) * float(terrain.cell_size) * flooded_bank_slope)) continue;
      const float share = square > 0 ? 1 - 0.75F * square / (radius * radius) : 1.0F;
      hydrology.water(x, y) = WaterKind::river;
      hydrology.water_depth(x, y) = std::max(hydrology.water_depth(x, y), depth * share);
    }
  }
}

}  // namespace

void mark_rivers(const Terrain& terrain, Hydrology& hydrology) {
  const auto cell_size = float(terrain.cell_size);
  for (const RiverReach& reach : hydrology.reaches) {
    if (reach.width < narrowest_channel * cell_size) continue;
    const std::vector<float> along = distances_along(reach, terrain.height.width(), cell_size);
    // Riffles and pools follow each other every five to seven widths (Leopold, Wolman and Miller 1964).
    const float near = std::max(3 * reach.width, 2 * cell_size);
    const std::vector<float> slopes = bed_slopes(reach, hydrology.filled, along, near);
    const std::vector<float> means = bed_slopes(reach, hydrology.filled, along, 8 * near);
    for (std::size_t i = 0; i < reach.cells.size(); ++i) {
      const float discharge = hydrology.discharge[reach.cells[i]];
      const float width = river_width(discharge);
      if (width < narrowest_channel * cell_size) continue;
      const float ratio = (slopes[i] + least_bed_slope) / (means[i] + least_bed_slope);
      const float riffle = std::clamp(std::pow(ratio, riffle_exponent), shallowest_riffle, deepest_pool);
      flood_width(terrain, reach.cells[i], width, river_depth(discharge) * riffle, hydrology);
    }
  }
}

TileSet clear_rivers(Hydrology& water) {
  return changed_tiles(TileSet::all(water.water.width(), water.water.height()), [&](const Rect& rect) {
    bool any = false;
    for (int y = rect.y0; y < rect.y1; ++y) {
      const auto row = water.water.row(y).subspan(std::size_t(rect.x0), std::size_t(rect.width()));
      if (std::find(row.begin(), row.end(), WaterKind::river) == row.end()) continue;
      any = true;
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] != WaterKind::river) continue;
        row[i] = WaterKind::dry;
        water.water_depth(rect.x0 + int(i), y) = 0;
      }
    }
    return any;
  });
}

TileSet tiles_of_rivers(const Terrain& terrain, const Hydrology& water) {
  TileSet tiles(water.water.width(), water.water.height());
  for (const RiverReach& reach : water.reaches) {
    for (const std::uint32_t cell : reach.cells) {
      const int radius = int(river_width(water.discharge[cell]) / 2 / float(terrain.cell_size)) + 1;
      const int x = int(cell % std::uint32_t(tiles.width()));
      const int y = int(cell / std::uint32_t(tiles.width()));
      tiles.insert(grown({x, y, x + 1, y + 1}, radius));
    }
  }
  return tiles;
}

}  // namespace biotope
