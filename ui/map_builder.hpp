#pragma once

#include <memory>

#include "core/pipeline/maps_snapshot.hpp"
#include "ui/map_catalogue.hpp"

namespace biotope {

/// The values of a map, ready to be drawn: in the unit of its MapEntry (fractions for "%"), NaN where nothing is known.
struct MapValues {
  std::shared_ptr<const Grid<float>> cells;
  /// Least and greatest known value.
  float low = 0;
  float high = 0;
};

/// Values of a map, paint included; null cells while the snapshot does not hold what it needs. May take tenths of a second: call
/// it off the window's thread.
[[nodiscard]] MapValues build_map(const MapsSnapshot& snapshot, const MapId& id);

/// What the map was made from: two snapshots with the same value show the same map. Null when it cannot be made yet.
[[nodiscard]] const void* source_of(const MapsSnapshot& snapshot, const MapId& id);

/// The map under a layer of paint, as it was computed; null while it is not known.
[[nodiscard]] std::shared_ptr<const Grid<float>> computed_under(const MapsSnapshot& snapshot, const LayerId& layer);

/// What that map is made from; two snapshots with the same pointer have the same computed map. Null while it is not known.
[[nodiscard]] std::shared_ptr<const void> computed_source(const MapsSnapshot& snapshot, const LayerId& layer);

/// The value of a map at one cell without making the whole map, where that is cheap; NaN when unknown.
[[nodiscard]] float value_at(const MapsSnapshot& snapshot, const MapId& id, int x, int y);

/// Place of an animal species in its level; null level when there is none.
struct AnimalPlace {
  const AnimalLevel* level = nullptr;
  int index = -1;
};
[[nodiscard]] AnimalPlace find_animal(const MapsSnapshot& snapshot, int species);
/// Place of a plant species among the covers; -1 when there is none.
[[nodiscard]] int find_plant(const MapsSnapshot& snapshot, int species);

}  // namespace biotope
