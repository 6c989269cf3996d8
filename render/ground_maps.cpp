#include "render/ground_maps.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace biotope {

Grid<float> visible_surface(const MapsSnapshot& snapshot, int stride) {
  const Grid<float>& heights = snapshot.terrain().height;
  const Hydrology* water = snapshot.hydrology.get();
  const Grid<float>* carving = snapshot.trails && !snapshot.trails->carving.empty() ? &snapshot.trails->carving : nullptr;
  Grid<float> surface(heights.width() / stride, heights.height() / stride);
  parallel_rows(0, surface.height(), [&](int row) {
    for (int column = 0; column < surface.width(); ++column) {
      const int x = column * stride + stride / 2;
      const int y = row * stride + stride / 2;
      float& height = surface(column, row);
      height = heights(x, y);
      if (carving != nullptr) height -= (*carving)(x, y);
      if (water == nullptr || water->water_depth(x, y) <= 0) continue;
      const float depth = water->water_depth(x, y);
      const WaterKind kind = water->water(x, y);
      // A river's bed is not in the terrain model: its surface lies a little below the banks instead of its depth above them.
      height += kind == WaterKind::lake || kind == WaterKind::sea ? depth : -0.3F * std::min(depth, 1.0F);
    }
  });
  return surface;
}

Grid<Rgba> surface_normals(const Grid<float>& surface, double cell_size, const Rect& rect) {
  Grid<Rgba> normals(rect.width(), rect.height());
  const float run = 1.0F / float(2 * cell_size);
  const auto code = [](float v) { return std::uint8_t(std::lround(std::clamp(v, -1.0F, 1.0F) * 127.0F + 128.0F)); };
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const float east = (surface.clamped(x + 1, y) - surface.clamped(x - 1, y)) * run;
      const float north = (surface.clamped(x, y - 1) - surface.clamped(x, y + 1)) * run;
      const float length = std::sqrt(1 + east * east + north * north);
      // Hollows see less sky: mean height of a ring against the cell, on two scales.
      float rise = 0;
      for (const int reach : {3, normal_reach}) {
        const float ring = surface.clamped(x + reach, y) + surface.clamped(x - reach, y) + surface.clamped(x, y + reach) +
                           surface.clamped(x, y - reach);
        rise += (0.25F * ring - surface(x, y)) / (float(reach) * float(cell_size));
      }
      const float open = std::clamp(0.92F - 0.85F * rise, 0.35F, 1.0F);
      normals(x - rect.x0, y - rect.y0) = {code(-east / length), code(-north / length), code(1 / length),
                                           std::uint8_t(open * 255)};
    }
  }
  return normals;
}

}  // namespace biotope
