#pragma once

#include <memory>
#include <vector>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"

namespace biotope {

/// A document of flat ground and nothing else.
inline Document flat_document(int width, int height) {
  Document document;
  Terrain terrain;
  terrain.height = Grid<float>(width, height, 0.0F);
  document.terrain = std::make_shared<const Terrain>(std::move(terrain));
  return document;
}

/// Values 0..8 without any order.
inline Grid<float> random_map(int width, int height, std::uint64_t seed) {
  Grid<float> map(width, height);
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = 8 * float(random_unit({seed, i}));
  return map;
}

/// Any brush that a person may hold, with values that suit the kind of layer.
inline Brush random_brush(std::uint64_t number, LayerKind kind) {
  Brush brush;
  brush.mode = BrushMode(random_int(0, 9, {number, 1}));
  brush.radius = 0.5F + 35 * float(random_unit({number, 2}));
  brush.strength = float(random_unit({number, 3}));
  brush.hardness = float(random_unit({number, 4}));
  const float most = kind == LayerKind::resource || kind == LayerKind::ground ? 9.0F : kind == LayerKind::geology ? 4.0F : 1.0F;
  brush.value = most * float(random_unit({number, 5}));
  brush.floor = kind == LayerKind::resource ? 1 : 0;
  brush.falloff = Falloff(random_int(0, 3, {number, 6}));
  brush.spacing = 0.1F + float(random_unit({number, 7}));
  brush.noise_size = 1 + 20 * float(random_unit({number, 8}));
  brush.noise_seed = number;
  brush.pressure_sizes = random_int(0, 1, {number, 9}) == 1;
  brush.clone_offset = {0, float(random_int(-9, 9, {number, 11}))};
  return brush;
}

/// Up to six points in and around a map.
inline std::vector<StrokePoint> random_points(std::uint64_t number, int width, int height) {
  std::vector<StrokePoint> points;
  const int count = random_int(1, 6, {number, 30});
  for (std::uint64_t i = 0; i < std::uint64_t(count); ++i) {
    points.push_back({float(random_unit({number, 31, i})) * float(width + 40) - 20,
                      float(random_unit({number, 32, i})) * float(height + 40) - 20, float(random_unit({number, 33, i}))});
  }
  return points;
}

}  // namespace biotope
