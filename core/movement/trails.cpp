#include "core/movement/trails.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"
#include "core/movement/trail_raster.hpp"
#include "core/movement/trail_routes.hpp"
#include "core/movement/walkers.hpp"

namespace biotope {
namespace {

/// Routes at most, and travel edges of one refinement: our choice.
constexpr std::size_t most_routes = 400;
constexpr std::size_t leg_edges = 24;
/// Roughness of the ground between two places, the same both ways: of equally good ways one is best. Our choice.
constexpr double roughness = 0.2;

/// One travel graph, who walks on it and where they may be.
struct Job {
  std::shared_ptr<const TravelGraph> graph;
  const Grid<std::int32_t>* region = nullptr;
  std::vector<Walkers> walkers;
  double total = 0;
};

std::vector<Job> list_jobs(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                           std::span<const LevelMovement> movement) {
  std::vector<Job> jobs;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const LevelTravel& travel = *movement[level].travel;
    for (std::size_t graph = 0; graph < travel.graphs.size(); ++graph) {
      Job job{travel.graphs[graph], nullptr, walkers_of_graph(web, levels, movement, level, graph), 0};
      const auto species = std::find(travel.graph_of_species.begin(), travel.graph_of_species.end(), int(graph));
      job.region = &levels[level]->regions[std::size_t(species - travel.graph_of_species.begin())]->label;
      for (const Walkers& walkers : job.walkers) job.total += walkers.yearly;
      if (job.total > 0) jobs.push_back(std::move(job));
    }
  }
  std::stable_sort(jobs.begin(), jobs.end(), [](const Job& a, const Job& b) { return a.total > b.total; });
  if (jobs.size() > 64) jobs.resize(64);
  return jobs;
}

/// How worn the ground between neighbouring blocks is, 0..1, whoever wore it: by block and direction (east, south, south-east, south-west).
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

 private:
  int columns_;
  std::vector<float> worn_;
};

/// A graph's costs with a little roughness between places, and cheaper by as much as others have worn the ground.
std::vector<float> rough_costs(const TravelGraph& graph, WornBlocks& worn) {
  std::vector<float> cost = graph.cost;
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

/// Walks on all graphs, the heaviest first: what they have worn draws the others.
std::vector<WalkedGraph> walk_all(const std::vector<Job>& jobs, const TaskContext& context) {
  std::vector<WalkedGraph> walked;
  if (jobs.empty()) return walked;
  WornBlocks worn(*jobs.front().graph);
  for (const Job& job : jobs) {
    if (context.stopped()) return walked;
    const TravelGraph& graph = *job.graph;
    walked.push_back({&graph, gathered_weight(graph, rough_costs(graph, worn), job.walkers)});
    const std::vector<float> share = worn_share(walked.back().weight);
    for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
      for (std::uint32_t slot = graph.first_edge[v]; slot < graph.first_edge[v + 1]; ++slot) {
        float& block = worn.at(graph, v, graph.target[slot]);
        block = std::max(block, share[graph.edge[slot]]);
      }
    }
    context.report("Trails", 0.5 * double(walked.size()) / double(jobs.size()));
  }
  return walked;
}

/// Turns coarse routes into lines on the ground.
class RouteRefiner {
 public:
  RouteRefiner(const Ground& ground, const std::vector<Job>& jobs, const TrailGraph& trails, const std::vector<CoarseRoute>& routes)
      : ground_(ground), jobs_(jobs), trails_(trails), routes_(routes), refined_(routes.size()) {
    for (const Job& job : jobs) costs_.emplace_back(job.graph->mobility);
  }

  /// Routes that others join come first; those of one rank do not need each other.
  std::vector<TrailRoute> run(const TaskContext& context) {
    int ranks = 0;
    for (const CoarseRoute& route : routes_) ranks = std::max(ranks, route.rank + 1);
    std::vector<std::vector<std::size_t>> by_rank(std::size_t(ranks), std::vector<std::size_t>{});
    for (std::size_t i = 0; i < routes_.size(); ++i) by_rank[std::size_t(routes_[i].rank)].push_back(i);
    for (const auto& numbers : by_rank) {
      if (context.stopped()) break;
      parallel_each(numbers.size(), [&](std::size_t i) { refined_[numbers[i]] = refine(routes_[numbers[i]]); });
    }
    return std::move(refined_);
  }

  [[nodiscard]] float wade_depth(const CoarseRoute& route) const {
    const std::uint64_t users = users_of(route.edges);
    float depth = jobs_[std::size_t(std::countr_zero(users))].graph->mobility.wade_depth;
    for (std::size_t j = 0; j < jobs_.size(); ++j) {
      if (users >> j & 1) depth = std::min(depth, jobs_[j].graph->mobility.wade_depth);
    }
    return depth;
  }

 private:
  [[nodiscard]] std::uint64_t users_of(std::span<const std::uint32_t> edges) const {
    std::uint64_t users = 0;
    for (const std::uint32_t e : edges) users |= trails_.edges[e].users;
    return users;
  }
  [[nodiscard]] int heaviest_of(std::span<const std::uint32_t> edges) const {
    const auto lighter = [&](std::uint32_t a, std::uint32_t b) { return trails_.edges[a].weight < trails_.edges[b].weight; };
    return trails_.edges[*std::max_element(edges.begin(), edges.end(), lighter)].heaviest;
  }
  [[nodiscard]] FineGround ground_for(std::uint64_t users, int heaviest) const {
    std::vector<const Grid<std::int32_t>*> regions;
    for (std::size_t j = 0; j < jobs_.size(); ++j) {
      if (users >> j & 1) regions.push_back(jobs_[j].region);
    }
    return {ground_, std::move(regions), costs_[std::size_t(heaviest)], trail_step};
  }

  /// Nearest point of the route that is joined, where the users of this one can stand.
  [[nodiscard]] std::optional<PathPoint> joint(int joined, std::uint32_t vertex, std::uint64_t users, int heaviest) const {
    if (joined < 0) return std::nullopt;
    const FineGround fine = ground_for(users, heaviest);
    const PathCell at = trails_.cells[vertex];
    std::optional<PathPoint> best;
    double nearest = 3.0 * jobs_.front().graph->block;
    for (const PathPoint& point : refined_[std::size_t(joined)].points) {
      const double distance = std::hypot(double(point.x) - at.x, double(point.y) - at.y);
      if (distance >= nearest || !fine.passable(point)) continue;
      nearest = distance;
      best = point;
    }
    return best;
  }

  /// Cells of one leg and the weight at each; first tries the ground that all its users share, then that of who walks most.
  [[nodiscard]] std::vector<PathCell> refine_leg(std::span<const std::uint32_t> edges, std::span<const PathCell> over, PathCell from,
                                                 PathCell to) const {
    const int block = jobs_.front().graph->block;
    const int heaviest = heaviest_of(edges);
    auto cells = fine_path(ground_for(users_of(edges), heaviest), block, over, from, to);
    if (cells.empty()) cells = fine_path(ground_for(std::uint64_t(1) << heaviest, heaviest), block, over, from, to);
    return cells;
  }

  [[nodiscard]] TrailRoute refine(const CoarseRoute& route) const {
    const std::uint64_t users = users_of(route.edges);
    const int heaviest = heaviest_of(route.edges);
    const auto front = joint(route.joins_front, route.vertices.front(), users, heaviest);
    const auto back = joint(route.joins_back, route.vertices.back(), users, heaviest);
    std::vector<PathCell> over;
    for (const std::uint32_t v : route.vertices) over.push_back(trails_.cells[v]);
    std::vector<PathCell> cells;
    std::vector<float> weight;
    for (std::size_t first = 0; first < route.edges.size(); first += leg_edges) {
      const std::size_t count = std::min(leg_edges, route.edges.size() - first);
      const auto edges = std::span(route.edges).subspan(first, count);
      const PathCell from = !cells.empty() ? cells.back() : front ? cell_at(*front) : over.front();
      const bool last = first + count == route.edges.size();
      const PathCell to = last && back ? cell_at(*back) : over[first + count];
      const auto leg = refine_leg(edges, std::span(over).subspan(first, count + 1), from, to);
      if (leg.empty()) break;
      for (std::size_t i = cells.empty() ? 0 : 1; i < leg.size(); ++i) {
        cells.push_back(leg[i]);
        weight.push_back(float(trails_.edges[edges[std::min(count - 1, i * count / leg.size())]].weight));
      }
    }
    TrailRoute line{smooth_path(ground_for(users, heaviest), points_of(cells)), blurred(weight), 0};
    if (line.points.size() < 2) return {};
    if (front && cells.front() == cell_at(*front)) line.points.front() = *front;
    if (back && cells.back() == cell_at(*back)) line.points.back() = *back;
    measure(line);
    return line;
  }

  /// Weights change where animals leave a trail one by one, not all at a block's middle.
  static std::vector<float> blurred(const std::vector<float>& weight) {
    constexpr std::size_t reach = 6;
    std::vector<float> result(weight.size());
    for (std::size_t i = 0; i < weight.size(); ++i) {
      const std::size_t first = i > reach ? i - reach : 0;
      const std::size_t last = std::min(weight.size() - 1, i + reach);
      double sum = 0;
      for (std::size_t k = first; k <= last; ++k) sum += double(weight[k]);
      result[i] = float(sum / double(last - first + 1));
    }
    return result;
  }

  void measure(TrailRoute& line) const {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      line.length += std::hypot(double(line.points[i + 1].x - line.points[i].x), double(line.points[i + 1].y - line.points[i].y)) *
                     ground_.terrain->cell_size;
    }
  }

  const Ground& ground_;
  const std::vector<Job>& jobs_;
  const TrailGraph& trails_;
  const std::vector<CoarseRoute>& routes_;
  std::vector<WalkCost> costs_;
  std::vector<TrailRoute> refined_;
};

}  // namespace

Result<TrailNetwork> compute_trails(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                    std::span<const LevelMovement> movement, const Ground& ground, const TaskContext& context) {
  assert(levels.size() == movement.size());
  const std::vector<Job> jobs = list_jobs(web, levels, movement);
  const std::vector<WalkedGraph> walked = walk_all(jobs, context);
  if (context.stopped()) return fail("stopped");
  const TrailGraph trails = merge_walks(walked);
  const std::vector<CoarseRoute> coarse = extract_routes(trails, most_routes);
  RouteRefiner refiner(ground, jobs, trails, coarse);
  std::vector<TrailRoute> refined = refiner.run(context);
  if (context.stopped()) return fail("stopped");
  context.report("Trails", 0.9);
  TrailNetwork network;
  std::vector<float> wade_depth;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    if (refined[i].points.size() < 2) continue;
    network.routes.push_back(std::move(refined[i]));
    wade_depth.push_back(refiner.wade_depth(coarse[i]));
  }
  draw_trails(ground, wade_depth, network);
  context.report("Trails", 1.0);
  return network;
}

}  // namespace biotope
