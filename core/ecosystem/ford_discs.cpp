#include "core/ecosystem/ford_discs.hpp"

#include <algorithm>

namespace biotope {
namespace {

/// Smallest radius of a ford's corridor, cells and metres. Our choice: wide enough that a diagonal river does not close it.
constexpr double ford_radius_cells = 2;
constexpr double ford_radius_metres = 6;

/// Radius (cells) within which every point has the centre of a cell.
constexpr double least_place_radius = 0.7072;

/// Its river's width and a cell.
double ford_radius(const Hydrology& hydrology, const Ford& ford, double cell_size) {
  float discharge = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (hydrology.discharge.contains(ford.x + dx, ford.y + dy)) {
        discharge = std::max(discharge, hydrology.discharge(ford.x + dx, ford.y + dy));
      }
    }
  }
  return std::max({river_width(discharge) / cell_size + 1, ford_radius_cells, ford_radius_metres / cell_size});
}

}  // namespace

double place_radius(float metres, double cell_size) { return std::max(double(metres) / cell_size, least_place_radius); }

std::vector<FordDisc> ford_discs(const Ground& ground) {
  std::vector<FordDisc> discs;
  const double cell_size = ground.terrain->cell_size;
  if (ground.hydrology) {
    for (const Ford& ford : ground.hydrology->fords)
      discs.push_back({double(ford.x), double(ford.y), ford_radius(*ground.hydrology, ford, cell_size)});
  }
  if (ground.places) {
    for (const PlacedFord& ford : ground.places->fords)
      discs.push_back({double(ford.at.x), double(ford.at.y), place_radius(ford.radius, cell_size)});
  }
  return discs;
}

}  // namespace biotope
