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

std::vector<double> available_by_piece(const GraphLevel& graph, std::size_t pieces, int resource) {
  std::vector<double> available(pieces);
  for (const ResourceNode& node : graph.nodes) {
    for (const ResourceQuantity& quantity : node.quantities) {
      if (quantity.species == resource) available[std::size_t(node.piece)] += quantity.available;
    }
  }
  return available;
}

std::vector<double> eaten_share(const AnimalLevel& level, int resource) {
  const auto& eaten = level.eaten[std::size_t(resource)];
  if (std::all_of(eaten.begin(), eaten.end(), [](double kilograms) { return kilograms <= 0; })) return {};
  std::vector<double> share = available_by_piece(*level.graph, eaten.size(), resource);
  for (std::size_t piece = 0; piece < share.size(); ++piece) {
    share[piece] = share[piece] > 0 ? std::min(1.0, eaten[piece] / share[piece]) : 0;
  }
  return share;
}

int patch_side(const Terrain& terrain, std::size_t present_cells) {
  const double longer = std::max(terrain.height.width(), terrain.height.height());
  const double wide_enough = std::sqrt(double(present_cells) / 150);
  return std::max(1, int(std::ceil(std::max({400 / terrain.cell_size, longer / 10, wide_enough}))));
}

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

GraphLevel build_resource_nodes(const ResourceSources& sources, const TaskContext& context) {
  GraphLevel graph;
  graph.level = sources.level;
  if (!context.stopped()) add_vegetation_nodes(sources, graph);
  if (!context.stopped()) add_prey_nodes(sources, graph);
  if (!context.stopped()) add_bank_nodes(sources, graph);
  std::shared_ptr<const Grid<std::int32_t>> nowhere;
  for (auto& grid : graph.node_of_cell) {
    if (grid) continue;
    if (!nowhere) {
      const auto& label = sources.partition.label;
      nowhere = std::make_shared<const Grid<std::int32_t>>(label.width(), label.height(), -1);
    }
    grid = nowhere;
  }
  return graph;
}

}  // namespace biotope
