#pragma once

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// By tile of tile_side cells, columns from the west and rows from the north: 1 where the cover of a plant is not the one it was.
/// Both snapshots are of the same extent and have the same plants; only pointers are compared.
[[nodiscard]] Grid<std::uint8_t> changed_cover(const MapsSnapshot& now, const MapsSnapshot& then);

}  // namespace biotope
