#include "core/ecosystem/resource_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace biotope {

std::vector<char> edible_to_level(const FoodWeb& web, int level) {
  std::vector<char> edible(web.species.size());
  for (const int species : web.levels[std::size_t(level)]) {
    for (const auto& need : web.diets[std::size_t(species)]) {
      for (const int food : need.foods) edible[std::size_t(food)] = 1;
    }
  }
  return edible;
}

NodeLimits node_limits(int level) { return level == 1 ? NodeLimits{180, 0, 120} : NodeLimits{110, 90, 100}; }

int patch_side(const Terrain& terrain, std::size_t present_cells) {
  const double longer = std::max(terrain.height.width(), terrain.height.height());
  const double wide_enough = std::sqrt(double(present_cells) / 150);
  return std::max(1, int(std::ceil(std::max({400 / terrain.cell_size, longer / 10, wide_enough}))));
}

std::shared_ptr<const RunTable> piece_runs(const AnimalLevel& level) { return level.partition->label.shared_runs(); }

ResourceNode node_of_area(const Area& area, NearestCell position, double cell_area) {
  ResourceNode node;
  node.cells = area.cells;
  node.area = double(area.cells) * cell_area;
  node.bounds = area.bounds;
  node.centroid_x = area.centroid_x();
  node.centroid_y = area.centroid_y();
  node.x = position.x;
  node.y = position.y;
  return node;
}

std::vector<std::int64_t> number_values(RunTable& table) {
  std::vector<std::int64_t> values;
  std::unordered_map<std::int64_t, std::int64_t> number;
  std::int64_t last_value = -1;
  std::int64_t last_number = -1;
  for (CellRun& run : table.runs) {
    if (run.value != last_value) {
      last_value = run.value;
      const auto [found, added] = number.try_emplace(run.value, std::int64_t(values.size()));
      if (added) values.push_back(run.value);
      last_number = found->second;
    }
    run.value = last_number;
  }
  return values;
}

GraphLevel build_resource_nodes(const ResourceSources& sources, std::span<const PreySupply> prey, const TaskContext& context) {
  GraphLevel graph;
  graph.level = sources.level;
  if (!context.stopped()) add_vegetation_nodes(sources, graph);
  if (!context.stopped()) add_prey_nodes(sources, prey, graph);
  if (!context.stopped()) add_bank_nodes(sources, graph);
  if (!context.stopped()) add_waypoint_nodes(sources, graph);
  const auto& label = sources.partition.label;
  for (auto& nodes : graph.node_of_cell) {
    if (nodes) continue;
    RunTable nowhere{label.width(), label.height(), {}, std::vector<std::size_t>(std::size_t(label.height()) + 1)};
    nodes = std::make_shared<const RunMap>(std::move(nowhere));
  }
  return graph;
}

}  // namespace biotope
