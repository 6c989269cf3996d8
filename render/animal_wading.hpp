#pragma once

#include <memory>

#include "core/movement/herd_world.hpp"
#include "render/ford_look.hpp"

namespace biotope {

/// How deep animals stand in the water that is drawn. The terrain has no beds of rivers: what is drawn there is the water's
/// surface.
class AnimalWading {
 public:
  AnimalWading() = default;
  explicit AnimalWading(std::shared_ptr<const HerdWorld> world);

  /// Metres from the surface of a river to its bed, as shaders/landscape/water.glsl draws it; 0 outside of rivers.
  [[nodiscard]] double depth(Place place) const;

  /// Height that the feet of an animal are at: on the ground or the bed (`standing`: without the depth of rivers), or hanging
  /// from a body that swims in water whose surface is at `surface`. Metres; `shoulder` is its height there.
  [[nodiscard]] double feet(Place place, double surface, double standing, double shoulder) const;

  /// How far it keeps its head up because of the water that it stands in, `metres` deep: 0 not at all .. 1.
  [[nodiscard]] static double head_up(double metres, double shoulder);

 private:
  std::shared_ptr<const HerdWorld> world_;
  FordLook fords_;
};

}  // namespace biotope
