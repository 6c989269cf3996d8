#include <algorithm>
#include <cmath>

#include "core/movement/daily_plan.hpp"
#include "core/movement/fine_path.hpp"

namespace biotope {
namespace {

/// A herd's home is looked for this many cells around the cell that an edit names: obstacles may have come to lie on it. Our
/// choice.
constexpr int home_reach = 12;

/// Region of the labelled cell nearest to a cell, the first in row order of equals; -1 when there is none near.
int region_near(const RunMap& label, PathCell home) {
  int region = -1;
  int nearest = home_reach * home_reach + 1;
  const Rect near =
      intersection(label.rect(), {home.x - home_reach, home.y - home_reach, home.x + home_reach + 1, home.y + home_reach + 1});
  for (int y = near.y0; y < near.y1; ++y) {
    for (int x = near.x0; x < near.x1; ++x) {
      const int distance = (x - home.x) * (x - home.x) + (y - home.y) * (y - home.y);
      if (label(x, y) < 0 || distance >= nearest) continue;
      nearest = distance;
      region = label(x, y);
    }
  }
  return region;
}

}  // namespace

std::optional<NamedHerd> find_planned_herd(const PlanEdit& edit, const FoodWeb& web,
                                           std::span<const std::shared_ptr<const AnimalLevel>> levels) {
  const auto is_named = [&](int species) { return web.species[std::size_t(species)].name == edit.species; };
  for (std::size_t number = 0; number < levels.size(); ++number) {
    const AnimalLevel& level = *levels[number];
    const auto species = std::find_if(level.species.begin(), level.species.end(), is_named);
    if (species == level.species.end()) continue;
    const auto& label = level.regions[std::size_t(species - level.species.begin())]->label;
    const int region = region_near(label, cell_at(edit.home));
    int left = edit.number;
    for (std::size_t herd = 0; herd < level.herds.size() && left >= 0; ++herd) {
      if (level.herds[herd].species != *species || level.herds[herd].region != region) continue;
      if (left-- == 0) return NamedHerd{number, int(herd)};
    }
  }
  return std::nullopt;
}

std::optional<PlanEdit> edit_of_plan(const DailyPlan& plan, const FoodWeb& web,
                                     std::span<const std::shared_ptr<const AnimalLevel>> levels) {
  const auto found = std::find_if(levels.begin(), levels.end(), [&](const auto& level) { return level->level == plan.level; });
  if (found == levels.end() || plan.herd < 0 || std::size_t(plan.herd) >= (*found)->herds.size()) return std::nullopt;
  const AnimalLevel& level = **found;
  const Herd& herd = level.herds[std::size_t(plan.herd)];
  const auto species = std::find(level.species.begin(), level.species.end(), herd.species);
  if (herd.species != plan.species || species == level.species.end() || plan.way.empty()) return std::nullopt;
  PlanEdit edit;
  edit.species = web.species[std::size_t(herd.species)].name;
  const PathCell home = cell_at(plan.way.front().at);
  edit.home = {float(home.x), float(home.y)};
  const auto& label = level.regions[std::size_t(species - level.species.begin())]->label;
  if (region_near(label, home) != herd.region) return std::nullopt;
  for (int i = 0; i < plan.herd; ++i) {
    const Herd& before = level.herds[std::size_t(i)];
    edit.number += before.species == herd.species && before.region == herd.region;
  }
  for (const PlanStop& stop : plan.stops) {
    const ResourceNode& node = level.graph->nodes[std::size_t(stop.node)];
    const float days = 24 * std::floor(stop.arrive / 24);
    edit.stops.push_back({{float(node.x), float(node.y)}, stop.arrive - days, stop.leave - days});
  }
  return edit;
}

}  // namespace biotope
