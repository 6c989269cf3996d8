#pragma once

#include <array>
#include <cmath>
#include <string>

#include "core/terrain/terrain.hpp"

namespace biotope {

/// East and north of a cell's centre in the file's reference system, or metres from the south-west corner where there is none:
/// what a person reads as a place.
[[nodiscard]] inline std::array<double, 2> ground_coordinates(const Terrain& terrain, double x, double y) {
  const auto& t = terrain.georeference.transform;
  if (terrain.georeference.wkt.empty())
    return {(x + 0.5) * terrain.cell_size, terrain.height_metres() - (y + 0.5) * terrain.cell_size};
  return {t[0] + (x + 0.5) * t[1] + (y + 0.5) * t[2], t[3] + (x + 0.5) * t[4] + (y + 0.5) * t[5]};
}

/// "(near x 750 m, y 650 m)", as the status bar says places.
[[nodiscard]] inline std::string near_text(const Terrain& terrain, double x, double y) {
  const auto [east, north] = ground_coordinates(terrain, x, y);
  return "(near x " + std::to_string(std::llround(east)) + " m, y " + std::to_string(std::llround(north)) + " m)";
}

}  // namespace biotope
