#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/cell_marks.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/water_marking.hpp"
#include "core/terrain/water_updates.hpp"

namespace biotope {
namespace {

/// A ground and what its depressions are filled to.
struct FilledGround {
  const Grid<float>& height;
  const Grid<float>& filled;
  [[nodiscard]] bool depressed(std::size_t cell) const { return filled[cell] > height[cell]; }
};

/// Gathers the depressed cells that connect to `start` at the same water level; `mark(cell)` says whether one is new.
template <class Mark>
void gather_depression(const FilledGround& ground, std::uint32_t start, const Mark& mark, std::vector<std::uint32_t>& cells) {
  const Grid<float>& filled = ground.filled;
  cells.assign(1, start);
  const int width = filled.width();
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const int x = int(cells[next] % std::uint32_t(width));
    const int y = int(cells[next] / std::uint32_t(width));
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!filled.contains(nx, ny)) continue;
      const std::size_t n = filled.index(nx, ny);
      if (filled[n] == filled[start] && ground.depressed(n) && mark(n)) cells.push_back(std::uint32_t(n));
    }
  }
}

/// Marks a depression as a lake if it is deep and large enough, or drawn by a person.
void mark_lake(const Terrain& terrain, const HydrologyOptions& options, const std::vector<std::uint32_t>& cells,
               Hydrology& hydrology) {
  const Grid<float>& filled = hydrology.filled;
  float deepest = 0;
  for (const std::uint32_t cell : cells) deepest = std::max(deepest, filled[cell] - terrain.height[cell]);
  const bool small = deepest < options.lake_depth || double(cells.size()) * terrain.cell_area() < options.lake_area;
  const auto drawn = [&](std::uint32_t cell) { return std::ranges::binary_search(options.lake_cells, cell); };
  if (small && (options.lake_cells.empty() || std::none_of(cells.begin(), cells.end(), drawn))) return;
  for (const std::uint32_t cell : cells) {
    hydrology.water[cell] = WaterKind::lake;
    hydrology.water_depth[cell] = filled[cell] - terrain.height[cell];
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
  const FilledGround ground{terrain.height, filled};
  const auto mark = [&](std::size_t cell) { return std::exchange(seen[cell], std::uint8_t(1)) == 0; };
  for (std::size_t start = 0; start < filled.size(); ++start) {
    if (!ground.depressed(start) || !mark(start)) continue;
    gather_depression(ground, std::uint32_t(start), mark, cells);
    mark_lake(terrain, options, cells, hydrology);
  }
}

namespace {

/// Marks the sea of some tiles; returns the cells that it took or left.
std::vector<std::uint32_t> update_sea(const Terrain& terrain, const Grid<std::uint8_t>& sea, const TileSet& tiles,
                                      float sea_level, Hydrology& water) {
  std::vector<std::uint32_t> other;
  for (const std::size_t tile : tiles.list()) {
    const Rect rect = tiles.rect(tile);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const std::size_t cell = terrain.height.index(x, y);
        const bool is_sea = !sea.empty() && sea[cell] != 0;
        const bool was_sea = water.water[cell] == WaterKind::sea;
        if (!is_sea && !was_sea) continue;
        if (is_sea != was_sea) other.push_back(std::uint32_t(cell));
        water.water[cell] = is_sea ? WaterKind::sea : WaterKind::dry;
        water.water_depth[cell] = is_sea ? sea_level - terrain.height[cell] : 0;
      }
    }
  }
  return other;
}

}  // namespace

std::vector<std::uint32_t> update_standing_water(const WateredGround& before, const Terrain& terrain,
                                                 const Grid<std::uint8_t>& sea, const TileSet& changed,
                                                 const HydrologyOptions& options, Hydrology& water) {
  const TileSet asked = changed.grown(1);
  std::vector<std::uint32_t> all;
  // Each depression near the change: first those of before are dried, then those of now are marked.
  const auto each_depression = [&](const FilledGround& ground, const auto& is_sea, const auto& body) {
    CellMarks marks(terrain.height.width(), terrain.height.height());
    const auto mark = [&](std::size_t cell) { return !is_sea(cell) && marks.mark(cell); };
    std::vector<std::uint32_t> cells;
    for (const std::size_t tile : asked.list()) {
      const Rect rect = asked.rect(tile);
      for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) {
          const std::size_t cell = ground.height.index(x, y);
          if (!ground.depressed(cell) || !mark(cell)) continue;
          gather_depression(ground, std::uint32_t(cell), mark, cells);
          body(cells);
          all.insert(all.end(), cells.begin(), cells.end());
        }
      }
    }
  };
  const Grid<WaterKind>& kind_before = before.hydrology.water;
  each_depression(
      {before.terrain.height, before.hydrology.filled}, [&](std::size_t cell) { return kind_before[cell] == WaterKind::sea; },
      [&](const std::vector<std::uint32_t>& cells) {
        for (const std::uint32_t cell : cells) {
          if (water.water[cell] != WaterKind::lake) continue;
          water.water[cell] = WaterKind::dry;
          water.water_depth[cell] = 0;
        }
      });
  const std::vector<std::uint32_t> coast = update_sea(terrain, sea, changed, options.sea_level, water);
  all.insert(all.end(), coast.begin(), coast.end());
  each_depression(
      {terrain.height, water.filled}, [&](std::size_t cell) { return !sea.empty() && sea[cell] != 0; },
      [&](const std::vector<std::uint32_t>& cells) { mark_lake(terrain, options, cells, water); });
  return all;
}

}  // namespace biotope
