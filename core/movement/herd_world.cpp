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
  if (details) {
    if (const std::optional<float> shore = details->shore(place)) return *shore;
  }
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

namespace {

/// Whether cells of two grids of one size are equal; a grid that is not there equals one that is not either.
bool same_cells(const Grid<float>* a, const Grid<float>* b, HerdWorld::Cell first, HerdWorld::Cell last) {
  const bool none = a == nullptr || a->empty();
  if (none || b == nullptr || b->empty()) return none == (b == nullptr || b->empty());
  if (a == b) return true;
  for (int y = first.y; y <= last.y; ++y) {
    const std::size_t begin = std::size_t(y) * std::size_t(a->width());
    const auto from = a->cells().begin() + std::ptrdiff_t(begin);
    if (!std::equal(from + first.x, from + last.x + 1, b->cells().begin() + std::ptrdiff_t(begin) + first.x)) return false;
  }
  return true;
}

}  // namespace

bool HerdWorld::same_within(const HerdWorld& other, Place low, Place high) const {
  const Cell north_west = cell_of({low.x, high.y});
  const Cell south_east = cell_of({high.x, low.y});
  const auto same = [&](const auto& here, const auto& there, auto member) {
    return here == there ||
           same_cells(here ? &((*here).*member) : nullptr, there ? &((*there).*member) : nullptr, north_west, south_east);
  };
  if (!same(ground.hydrology, other.ground.hydrology, &Hydrology::water_depth)) return false;
  if (!same(ground.derivatives, other.ground.derivatives, &Derivatives::east)) return false;
  if (!same(ground.derivatives, other.ground.derivatives, &Derivatives::north)) return false;
  if (details == other.details) return true;
  return details && other.details && details->same_within(*other.details, low, high);
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
