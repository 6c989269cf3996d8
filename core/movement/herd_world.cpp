#include "core/movement/herd_world.hpp"

#include <algorithm>

namespace biotope {

Place HerdWorld::place_of(PathPoint at) const {
  const double cell = terrain().cell_size;
  return {(double(at.x) + 0.5) * cell, (terrain().height.height() - 0.5 - double(at.y)) * cell};
}

HerdWorld::Cell HerdWorld::cell_of(Place place) const {
  const double cell = terrain().cell_size;
  const int width = terrain().height.width();
  const int height = terrain().height.height();
  return {std::clamp(int(std::floor(place.x / cell)), 0, width - 1),
          std::clamp(height - 1 - int(std::floor(place.y / cell)), 0, height - 1)};
}

float HerdWorld::depth_at(Place place) const {
  if (!ground.hydrology || ground.hydrology->water_depth.empty()) return 0;
  const Cell cell = cell_of(place);
  return ground.hydrology->water_depth(cell.x, cell.y);
}

float HerdWorld::shore_at(Place place) const {
  if (shore) return shore(place);
  return depth_at(place) > 0 ? 1.0F : -1.0F;
}

double HerdWorld::slope_along(Place place, Place direction) const {
  if (!ground.derivatives) return 0;
  const Cell cell = cell_of(place);
  return double(ground.derivatives->east(cell.x, cell.y)) * direction.x +
         double(ground.derivatives->north(cell.x, cell.y)) * direction.y;
}

HerdState HerdWorld::state(const DailyPlan& plan, double seconds) const {
  return herd_state(plan, graph_of(plan), seconds / 3600, terrain().cell_size);
}

std::vector<std::vector<int>> predators_of_plans(const HerdWorld& world) {
  const std::vector<DailyPlan>& plans = *world.plans;
  std::vector<std::vector<int>> predators(plans.size());
  // Species that a species fears: those that eat it.
  std::vector<std::vector<bool>> feared(world.web->species.size(), std::vector<bool>(world.web->species.size(), false));
  for (std::size_t eater = 0; eater < world.web->diets.size(); ++eater) {
    for (const FoodWeb::ResolvedNeed& need : world.web->diets[eater]) {
      for (const int food : need.foods) feared[std::size_t(food)][eater] = true;
    }
  }
  for (std::size_t p = 0; p < plans.size(); ++p) {
    for (std::size_t q = 0; q < plans.size(); ++q) {
      if (!feared[std::size_t(plans[p].species)][std::size_t(plans[q].species)]) continue;
      // Nobody runs from a fox that a hind could kick over.
      const double pack = double(world.traits(plans[q]).mean_mass()) * std::sqrt(double(std::max(1, plans[q].size)));
      if (pack >= feared_mass * double(world.traits(plans[p]).mean_mass())) predators[p].push_back(int(q));
    }
  }
  return predators;
}

}  // namespace biotope
