#pragma once

#include <array>
#include <string>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "core/document/document.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// A random layer that a person may paint.
inline LayerId random_layer(const MapsSnapshot& maps, std::uint64_t number) {
  static constexpr std::array<const char*, 3> resources{"illumination", "temperature", "moisture"};
  const auto& web = *maps.web;
  const int kind = random_int(0, 2, {number, 11});
  if (kind == 0) return {LayerKind::resource, resources[std::size_t(random_int(0, 2, {number, 12}))]};
  const auto& level = web.levels[kind == 1 ? 0 : 1];
  const int species = level[std::size_t(random_int(0, int(level.size()) - 1, {number, 13}))];
  return {kind == 1 ? LayerKind::plant_density : LayerKind::animal_density, web.species[std::size_t(species)].name};
}

/// A dab of random place, size, mode and value on a random layer; the map below is taken as flat.
inline void random_edit(Document& document, const MapsSnapshot& maps, std::uint64_t number) {
  const LayerId layer = random_layer(maps, number);
  const Grid<float>& height = document.terrain->height;
  const Grid<float> computed(height.width(), height.height(), layer.kind == LayerKind::resource ? 4.0F : 0.2F);
  Brush brush;
  brush.mode = BrushMode(random_int(0, 4, {number, 1}));
  brush.radius = float(random_int(2, 25, {number, 2}));
  brush.strength = float(random_unit({number, 3}));
  const float most = layer.kind == LayerKind::resource ? 9.0F : layer.kind == LayerKind::plant_density ? 1.0F : 300.0F;
  brush.value = float(random_unit({number, 4})) * most;
  Stroke stroke(layer, &computed);
  stroke.dab(document, brush, float(random_int(0, height.width(), {number, 5})),
             float(random_int(0, height.height(), {number, 6})));
}

}  // namespace biotope
