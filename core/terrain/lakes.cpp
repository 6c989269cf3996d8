#include <algorithm>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/water_marking.hpp"

namespace biotope {
namespace {

/// Gathers the depressed cells that connect to `start` at the same water level, and marks them as seen.
void gather_depression(const Terrain& terrain, const Grid<float>& filled, std::uint32_t start, Grid<std::uint8_t>& seen,
                       std::vector<std::uint32_t>& cells) {
  cells.assign(1, start);
  seen[start] = 1;
  const int width = filled.width();
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const int x = int(cells[next] % std::uint32_t(width));
    const int y = int(cells[next] / std::uint32_t(width));
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!filled.contains(nx, ny)) continue;
      const std::size_t n = filled.index(nx, ny);
      if (seen[n] != 0 || filled[n] != filled[start] || !(filled[n] > terrain.height[n])) continue;
      seen[n] = 1;
      cells.push_back(std::uint32_t(n));
    }
  }
}

}  // namespace

void mark_standing_water(const Terrain& terrain, const Grid<std::uint8_t>& sea, const HydrologyOptions& options,
                         Hydrology& hydrology) {
  const Grid<float>& filled = hydrology.filled;
  Grid<std::uint8_t> seen(filled.width(), filled.height());
  for (std::size_t cell = 0; cell < sea.size(); ++cell) {
    if (sea[cell] == 0) continue;
    seen[cell] = 1;
    hydrology.water[cell] = WaterKind::sea;
    hydrology.water_depth[cell] = options.sea_level - terrain.height[cell];
  }
  std::vector<std::uint32_t> cells;
  for (std::size_t start = 0; start < filled.size(); ++start) {
    if (seen[start] != 0 || !(filled[start] > terrain.height[start])) continue;
    gather_depression(terrain, filled, std::uint32_t(start), seen, cells);
    float deepest = 0;
    for (const std::uint32_t cell : cells) deepest = std::max(deepest, filled[cell] - terrain.height[cell]);
    if (deepest < options.lake_depth || double(cells.size()) * terrain.cell_area() < options.lake_area) continue;
    for (const std::uint32_t cell : cells) {
      hydrology.water[cell] = WaterKind::lake;
      hydrology.water_depth[cell] = filled[cell] - terrain.height[cell];
    }
  }
}

}  // namespace biotope
