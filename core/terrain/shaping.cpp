#include "core/terrain/shaping.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/terrain/ground_tiles.hpp"
#include "core/terrain/water_shaping.hpp"

namespace biotope {
namespace {

constexpr double seconds_per_year = 365.25 * 86400;

void lay_paint(const PaintLayer& paint, const Grid<float>& below, Grid<float>& height) {
  parallel_each(paint.tile_count(), [&](std::size_t tile) {
    if (paint.tile(tile) || paint.background().coverage > 0) paint_heights(below, &paint, paint.tile_rect(tile), height);
  });
}

}  // namespace

void paint_heights(const Grid<float>& height, const PaintLayer* paint, const Rect& cells, Grid<float>& out) {
  for (int y = cells.y0; y < cells.y1; ++y) {
    for (int x = cells.x0; x < cells.x1; ++x) {
      const Paint stroke = paint != nullptr ? (*paint)(x, y) : Paint{};
      out(x, y) = stroke.coverage > 0 ? painted(height(x, y), stroke) : height(x, y);
    }
  }
}

Terrain shaped_terrain(const Terrain& terrain, const PaintLayer* heights, const DrawnWater& water) {
  Terrain land = terrain;
  if (heights != nullptr) lay_paint(*heights, terrain.height, land.height);
  WaterShaping().lay(water, land);
  return land;
}

std::vector<Inflow> inflows_of(const DrawnWater& water, const Terrain& terrain, double runoff) {
  std::vector<Inflow> inflows;
  if (!(runoff > 0)) return inflows;
  for (const DrawnRiver& river : water.rivers) {
    if (!(river.discharge > 0)) continue;
    for (const PathPoint& point : smooth_line(river.course, false)) {
      const int x = int(std::floor(point.x + 0.5F));
      const int y = int(std::floor(point.y + 0.5F));
      if (!terrain.height.contains(x, y)) continue;
      inflows.push_back({x, y, river.discharge * seconds_per_year / runoff});
      break;
    }
  }
  return inflows;
}

}  // namespace biotope
