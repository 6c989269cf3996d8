#include "core/ecosystem/obstacle_rows.hpp"

#include "core/ecosystem/ford_discs.hpp"

namespace biotope {

ObstacleRows::ObstacleRows(const Ground& ground, const Mobility& mobility)
    : slope_(ground.derivatives->slope),
      depth_(ground.hydrology->water_depth),
      trees_(ground.tree_cover.get()),
      passage_(ground.passage.get()),
      mobility_(mobility),
      max_trees_(most_trees(mobility)),
      fords_(std::size_t(slope_.height())) {
  assert(passage_ == nullptr || (passage_->width() == slope_.width() && passage_->height() == slope_.height()));
  for (const FordDisc& ford : ford_discs(ground)) add_disk(fords_, ford.x, ford.y, ford.radius);
  if (!ground.places || ground.places->exits.empty()) return;
  exits_.resize(fords_.size());
  for (const PlacedExit& exit : ground.places->exits) {
    add_disk(exits_, double(exit.at.x), double(exit.at.y), place_radius(exit.radius, ground.terrain->cell_size));
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
