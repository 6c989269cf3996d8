#include "core/movement/trails.hpp"

#include <algorithm>

#include "core/movement/pinned_routes.hpp"
#include "core/movement/trail_raster.hpp"

namespace biotope {
namespace {

/// Our choice.
constexpr std::size_t most_routes = 400;

/// Appends what is allowed of a refined route, and notes which of its points lead along each edge of the coarse one.
void add_route(const PlacedGround& placed, const TrailGraph& trails, const CoarseRoute& coarse, const RefinedRoute& refined,
               double cell_size, int width, TrailNetwork& network, TrailWays& ways) {
  const auto cell = [&](std::uint32_t v) {
    return std::uint32_t(trails.cells[v].y) * std::uint32_t(width) + std::uint32_t(trails.cells[v].x);
  };
  const auto& points = refined.line.points;
  const auto& weight = refined.line.weight;
  const auto& at = refined.point_of_vertex;
  for (const auto& [first, last] : allowed_pieces(placed, points)) {
    TrailRoute piece = refined.line;
    if (last - first < points.size()) {
      piece.points.assign(points.begin() + std::ptrdiff_t(first), points.begin() + std::ptrdiff_t(last));
      piece.weight.assign(weight.begin() + std::ptrdiff_t(first), weight.begin() + std::ptrdiff_t(last));
      piece.length = length_of(piece.points, cell_size);
    }
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      if (at[i] < first || at[i + 1] >= last) continue;
      const std::uint32_t a = cell(coarse.vertices[i]);
      const std::uint32_t b = cell(coarse.vertices[i + 1]);
      TrailWays::Stretch stretch{std::uint32_t(network.routes.size()), at[i] - std::uint32_t(first),
                                 at[i + 1] - std::uint32_t(first)};
      if (b < a) std::swap(stretch.first, stretch.last);
      ways.stretches.emplace(TrailWays::key(std::min(a, b), std::max(a, b)), stretch);
    }
    network.routes.push_back(std::move(piece));
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
  const double cell_size = ground.terrain->cell_size;
  const int width = ground.terrain->height.width();
  const PlacedGround placed(ground);
  TrailGraph trails = merge_walks(walked);
  ways->stretches = pinned_edges(jobs, placed);
  mark_pinned(ways->stretches, width, trails);
  const std::vector<CoarseRoute> coarse = extract_routes(trails, most_routes, placed.lines().size());
  RouteRefiner refiner(ground, placed, jobs, trails, coarse, pinned_routes(placed, ways->stretches, trails, width, cell_size),
                       cache);
  std::vector<RefinedRoute> refined = refiner.run(context);
  if (context.stopped()) return fail("stopped");
  context.report("trails", 0.9);
  TrailNetwork network;
  std::vector<float> wade_depth;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    if (refined[i].line.points.size() < 2) continue;
    if (refined[i].line.pinned >= 0) {
      network.routes.push_back(std::move(refined[i].line));
    } else {
      add_route(placed, trails, coarse[i], refined[i], cell_size, width, network, *ways);
    }
    wade_depth.resize(network.routes.size(), refiner.wade_depth(coarse[i]));
  }
  draw_trails(ground, wade_depth, network);
  network.ways = std::move(ways);
  context.report("trails", 1.0);
  return network;
}

}  // namespace biotope
