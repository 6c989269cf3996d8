#include "render/animal_wading.hpp"

#include <algorithm>

namespace biotope {

namespace {

/// Share of its height at the shoulder by which an animal is in the water when it swims. Our choice.
constexpr double swimming = 0.72;
/// Depths, as shares of the height at the shoulder, at which it begins to raise its head and holds it up. Our choice.
constexpr double begins_to_raise = 0.15;
constexpr double holds_up = 0.3;
/// The bed falls from the shore by this a metre, from a little below the surface on (shaders/landscape/water.glsl).
constexpr double bed_slope = 0.40;
constexpr double edge_depth = 0.06;
constexpr double below_mean = 0.12;

}  // namespace

AnimalWading::AnimalWading(std::shared_ptr<const HerdWorld> world)
    : world_(std::move(world)), fords_(world_ && world_->ground.terrain ? FordLook(world_->ground) : FordLook()) {}

double AnimalWading::depth(Place place) const {
  if (!world_ || !world_->ground.hydrology || world_->ground.hydrology->water_depth.empty()) return 0;
  const double inside = double(world_->shore_at(place));
  if (inside <= 0) return 0;
  const Hydrology& water = *world_->ground.hydrology;
  const HerdWorld::Cell cell = world_->cell_of(place);
  if (water.water(cell.x, cell.y) == WaterKind::lake || water.water(cell.x, cell.y) == WaterKind::sea) return 0;
  // Where water is drawn beside the cells that have it, it is as deep as in the deepest of them nearby.
  float deepest = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (water.water_depth.contains(cell.x + dx, cell.y + dy) && water.water(cell.x + dx, cell.y + dy) == WaterKind::river)
        deepest = std::max(deepest, water.water_depth(cell.x + dx, cell.y + dy));
    }
  }
  const double metres = world_->terrain().cell_size;
  const double column = place.x / metres - 0.5;
  const double row = world_->terrain().height.height() - 0.5 - place.y / metres;
  const double mean = double(ford_depth(deepest, fords_.share(column, row)));
  return std::min(edge_depth + bed_slope * inside, mean + below_mean);
}

double AnimalWading::feet(Place place, double surface, double standing, double shoulder) const {
  const double bed = standing - depth(place);
  // Dry ground never is far below what is drawn; a lake's bed may be.
  return std::max(bed, surface - swimming * shoulder);
}

double AnimalWading::head_up(double metres, double shoulder) {
  return smooth_step(begins_to_raise * shoulder, holds_up * shoulder, metres);
}

}  // namespace biotope
