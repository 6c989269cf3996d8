#include "core/movement/trails.hpp"

#include <algorithm>

#include "core/movement/trail_raster.hpp"
#include "core/movement/trail_refiner.hpp"
#include "core/movement/trail_ways.hpp"

namespace biotope {
namespace {

/// Our choice.
constexpr std::size_t most_routes = 400;

/// Notes which points of a route lead along each edge of the coarse one.
void add_stretches(const TrailGraph& trails, const CoarseRoute& coarse, const RefinedRoute& refined, std::size_t number, int width,
                   TrailWays& ways) {
  const auto cell = [&](std::uint32_t v) { return std::uint32_t(trails.cells[v].y) * std::uint32_t(width) + std::uint32_t(trails.cells[v].x); };
  for (std::size_t i = 0; i + 1 < refined.point_of_vertex.size(); ++i) {
    const std::uint32_t a = cell(coarse.vertices[i]);
    const std::uint32_t b = cell(coarse.vertices[i + 1]);
    TrailWays::Stretch stretch{std::uint32_t(number), refined.point_of_vertex[i], refined.point_of_vertex[i + 1]};
    if (b < a) std::swap(stretch.first, stretch.last);
    ways.stretches.emplace(TrailWays::key(std::min(a, b), std::max(a, b)), stretch);
  }
}

}  // namespace

Result<TrailNetwork> compute_trails(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                    std::span<const LevelMovement> movement, const Ground& ground, const TaskContext& context,
                                    MovementCache* cache) {
  assert(levels.size() == movement.size());
  const std::vector<WalkJob> jobs = list_walk_jobs(web, levels, movement);
  std::vector<JobWalks> walks = walk_all(jobs, context);
  if (context.stopped()) return fail("stopped");
  std::vector<WalkedGraph> walked;
  auto ways = std::make_shared<TrailWays>();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    walked.push_back({jobs[i].graph.get(), std::move(walks[i].weight)});
    ways->graphs.push_back({jobs[i].graph, std::move(walks[i].worn_cost)});
  }
  const TrailGraph trails = merge_walks(walked);
  const std::vector<CoarseRoute> coarse = extract_routes(trails, most_routes);
  RouteRefiner refiner(ground, jobs, trails, coarse, cache);
  std::vector<RefinedRoute> refined = refiner.run(context);
  if (context.stopped()) return fail("stopped");
  context.report("trails", 0.9);
  TrailNetwork network;
  std::vector<float> wade_depth;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    if (refined[i].line.points.size() < 2) continue;
    add_stretches(trails, coarse[i], refined[i], network.routes.size(), ground.terrain->height.width(), *ways);
    network.routes.push_back(std::move(refined[i].line));
    wade_depth.push_back(refiner.wade_depth(coarse[i]));
  }
  draw_trails(ground, wade_depth, network);
  network.ways = std::move(ways);
  context.report("trails", 1.0);
  return network;
}

}  // namespace biotope
