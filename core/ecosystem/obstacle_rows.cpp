#include "core/ecosystem/obstacle_rows.hpp"

namespace biotope {
namespace {

/// Smallest radius of a ford's corridor, cells and metres. Our choice: wide enough that a diagonal river does not close it.
constexpr double ford_radius_cells = 2;
constexpr double ford_radius_metres = 6;

/// Radius (cells) within which every point has the centre of a cell: a place holds at least one cell however small it is.
constexpr double least_place_radius = 0.7072;

/// Radius (cells) of the disk that a ford opens: its river's width and a cell.
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

double place_radius(float metres, double cell_size) { return std::max(double(metres) / cell_size, least_place_radius); }

}  // namespace

ObstacleRows::ObstacleRows(const Ground& ground, const Mobility& mobility)
    : slope_(ground.derivatives->slope),
      depth_(ground.hydrology->water_depth),
      trees_(ground.tree_cover.get()),
      passage_(ground.passage.get()),
      mobility_(mobility),
      max_trees_(most_trees(mobility)),
      fords_(std::size_t(slope_.height())) {
  assert(passage_ == nullptr || (passage_->width() == slope_.width() && passage_->height() == slope_.height()));
  const double cell_size = ground.terrain->cell_size;
  for (const Ford& ford : ground.hydrology->fords)
    add_disk(fords_, ford.x, ford.y, ford_radius(*ground.hydrology, ford, cell_size));
  if (!ground.places) return;
  for (const PlacedFord& ford : ground.places->fords) {
    add_disk(fords_, double(ford.at.x), double(ford.at.y), place_radius(ford.radius, cell_size));
  }
  if (ground.places->exits.empty()) return;
  exits_.resize(fords_.size());
  for (const PlacedExit& exit : ground.places->exits) {
    add_disk(exits_, double(exit.at.x), double(exit.at.y), place_radius(exit.radius, cell_size));
  }
}

void ObstacleRows::add_disk(Rows& rows, double x, double y, double radius) const {
  const double last_row = slope_.height() - 1;
  const double last_column = slope_.width() - 1;
  const int first = int(std::ceil(std::clamp(y - radius, 0.0, last_row + 1)));
  const int last = int(std::floor(std::clamp(y + radius, -1.0, last_row)));
  for (int row = first; row <= last; ++row) {
    const double half = std::sqrt(std::max(0.0, radius * radius - (row - y) * (row - y)));
    const int x0 = int(std::ceil(std::clamp(x - half, 0.0, last_column + 1)));
    const int x1 = int(std::floor(std::clamp(x + half, -1.0, last_column))) + 1;
    if (x0 < x1) rows[std::size_t(row)].push_back({x0, x1});
  }
}

Obstacle ObstacleRows::at(int x, int y) const {
  if (!exits_.empty() && inside(exits_[std::size_t(y)], x)) return Obstacle::none;
  const Passage passage = passage_ != nullptr ? passage_of((*passage_)(x, y)) : Passage::none;
  if (passage == Passage::obstacle) return Obstacle::painted;
  if (passage == Passage::passage) return Obstacle::none;
  if (slope_(x, y) > mobility_.max_slope) return Obstacle::slope;
  if (depth_(x, y) > mobility_.wade_depth && !inside(fords_[std::size_t(y)], x)) return Obstacle::deep_water;
  if (trees_ != nullptr && (*trees_)(x, y) > max_trees_) return Obstacle::trees;
  return Obstacle::none;
}

}  // namespace biotope
