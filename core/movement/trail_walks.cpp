#include "core/movement/trail_walks.hpp"

#include <algorithm>

#include "core/base/random.hpp"
#include "core/movement/plan_parts.hpp"
#include "core/movement/walk_cost.hpp"

namespace biotope {
namespace {

/// Roughness of the ground between two places, the same both ways: of equally good ways one is best. Our choice.
constexpr double roughness = 0.2;
/// Jobs that together make less than this share of all walks wear no trail: less than what routes leave out. Our choice.
constexpr double faint_jobs = 0.005;

/// How worn the ground between neighbouring blocks is, 0..1, whoever wore it: by block and direction (east, south, south-east,
/// south-west).
class WornBlocks {
 public:
  explicit WornBlocks(const TravelGraph& graph)
      : columns_(graph.columns), worn_(std::size_t(graph.columns) * std::size_t(graph.rows) * 4, 0.0F) {}

  [[nodiscard]] float& at(const TravelGraph& graph, std::uint32_t a, std::uint32_t b) {
    if (b < a) std::swap(a, b);
    const int ax = graph.vertices[a].x / graph.block;
    const int ay = graph.vertices[a].y / graph.block;
    const int dx = graph.vertices[b].x / graph.block - ax;
    const int dy = graph.vertices[b].y / graph.block - ay;
    const int direction = dy == 0 ? 0 : dx == 0 ? 1 : dx > 0 ? 2 : 3;
    return worn_[(std::size_t(ay) * std::size_t(columns_) + std::size_t(ax)) * 4 + std::size_t(direction)];
  }

  /// Takes over the worn share (by undirected edge) of a graph.
  void add(const TravelGraph& graph, const std::vector<float>& share) {
    for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
      for (std::uint32_t slot = graph.first_edge[v]; slot < graph.first_edge[v + 1]; ++slot) {
        const float here = share[graph.edge[slot]];
        if (graph.target[slot] < v || here <= 0) continue;
        float& block = at(graph, v, graph.target[slot]);
        block = std::max(block, here);
      }
    }
  }

 private:
  int columns_;
  std::vector<float> worn_;
};

/// A graph's costs with a little roughness between places, and cheaper by as much as others have worn the ground.
std::vector<float> rough_costs(const TravelGraph& graph, std::span<const float> own, WornBlocks& worn) {
  std::vector<float> cost(own.begin(), own.end());
  const auto place = [&](std::uint32_t v) {
    return std::uint64_t(graph.vertices[v].y) * std::uint64_t(graph.vertex_of_cell.width()) + std::uint64_t(graph.vertices[v].x);
  };
  for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
    for (std::uint32_t slot = graph.first_edge[v]; slot < graph.first_edge[v + 1]; ++slot) {
      const std::uint32_t to = graph.target[slot];
      const double unit = random_unit({place(std::min(v, to)), place(std::max(v, to))});
      cost[slot] *= float(1 + roughness * unit) * (1 - (1 - worn_factor) * worn.at(graph, v, to));
    }
  }
  return cost;
}

}  // namespace

std::vector<WalkJob> list_walk_jobs(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                    std::span<const LevelMovement> movement) {
  std::vector<WalkJob> jobs;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const LevelTravel& travel = *movement[level].travel;
    for (std::size_t graph = 0; graph < travel.graphs.size(); ++graph) {
      WalkJob job{
          travel.graphs[graph], travel.cost(graph), nullptr, walkers_of_graph(web, levels, movement, level, graph), 0, {}};
      const auto species = std::find(travel.graph_of_species.begin(), travel.graph_of_species.end(), int(graph));
      job.region = &levels[level]->regions[std::size_t(species - travel.graph_of_species.begin())]->label;
      for (const Walkers& walkers : job.walkers) job.total += walkers.yearly;
      const auto& nodes = levels[level]->graph->nodes;
      for (std::size_t node = 0; node < nodes.size(); ++node) {
        const std::int32_t vertex = travel.vertex_of_node[graph][node];
        if (nodes[node].kind != NodeKind::waypoint || vertex < 0) continue;
        const auto cell = standing_cell(*job.graph, nodes[node]);
        if (cell) job.waypoints.emplace_back(std::uint32_t(vertex), *cell);
      }
      if (job.total > 0) jobs.push_back(std::move(job));
    }
  }
  std::stable_sort(jobs.begin(), jobs.end(), [](const WalkJob& a, const WalkJob& b) { return a.total > b.total; });
  if (jobs.size() > 64) jobs.resize(64);
  return jobs;
}

std::vector<JobWalks> walk_all(const std::vector<WalkJob>& jobs, const TaskContext& context) {
  std::vector<JobWalks> walks;
  if (jobs.empty()) return walks;
  WornBlocks worn(*jobs.front().graph);
  double left = 0;
  for (const WalkJob& job : jobs) left += job.total;
  const double faint = faint_jobs * left;
  for (const WalkJob& job : jobs) {
    if (context.stopped()) return walks;
    const TravelGraph& graph = *job.graph;
    std::vector<float> cost = rough_costs(graph, job.cost, worn);
    if (left >= faint) {
      GatheredWalks gathered = gather_walks(graph, std::move(cost), job.walkers);
      walks.push_back({std::move(gathered.weight), std::move(gathered.worn_cost)});
      worn.add(graph, worn_share(walks.back().weight));
    } else {
      walks.push_back({std::vector<double>(graph.edge_count, 0.0), std::move(cost)});
    }
    left -= job.total;
    context.report("trails", 0.5 * double(walks.size()) / double(jobs.size()));
  }
  return walks;
}

}  // namespace biotope
