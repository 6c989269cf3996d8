#include "render/ground_maps.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"

namespace biotope {

Grid<float> visible_surface(const MapsSnapshot& snapshot) {
  Grid<float> surface = snapshot.terrain().height;
  const Hydrology* water = snapshot.hydrology.get();
  const Grid<float>* carving = snapshot.trails && !snapshot.trails->carving.empty() ? &snapshot.trails->carving : nullptr;
  parallel_rows(0, surface.height(), [&](int y) {
    for (int x = 0; x < surface.width(); ++x) {
      float& height = surface(x, y);
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

Grid<Rgba> surface_normals(const Grid<float>& surface, double cell_size) {
  Grid<Rgba> normals(surface.width(), surface.height());
  const float run = 1.0F / float(2 * cell_size);
  const auto code = [](float v) { return std::uint8_t(std::lround(std::clamp(v, -1.0F, 1.0F) * 127.0F + 128.0F)); };
  parallel_rows(0, surface.height(), [&](int y) {
    for (int x = 0; x < surface.width(); ++x) {
      const float east = (surface.clamped(x + 1, y) - surface.clamped(x - 1, y)) * run;
      const float north = (surface.clamped(x, y - 1) - surface.clamped(x, y + 1)) * run;
      const float length = std::sqrt(1 + east * east + north * north);
      // Hollows see less sky: mean height of a ring against the cell, on two scales.
      float rise = 0;
      for (const int reach : {3, 10}) {
        const float ring = surface.clamped(x + reach, y) + surface.clamped(x - reach, y) + surface.clamped(x, y + reach) +
                           surface.clamped(x, y - reach);
        rise += (0.25F * ring - surface(x, y)) / (float(reach) * float(cell_size));
      }
      const float open = std::clamp(0.92F - 0.85F * rise, 0.35F, 1.0F);
      normals(x, y) = {code(-east / length), code(-north / length), code(1 / length), std::uint8_t(open * 255)};
    }
  });
  return normals;
}

}  // namespace biotope
