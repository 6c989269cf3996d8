#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/movement/movement_cache.hpp"
#include "core/movement/trail_routes.hpp"
#include "core/movement/trail_walks.hpp"

namespace biotope {

/// A route as a line on the ground.
struct RefinedRoute {
  TrailRoute line;
  /// Point of the line nearest to each vertex of the coarse route, ascending; shorter than the route where the line ends early.
  std::vector<std::uint32_t> point_of_vertex;
};

/// The mean of each weight and those around it: weights change where animals leave a trail one by one, not all at a block's
/// middle.
[[nodiscard]] std::vector<float> blurred_weight(const std::vector<float>& weight);
/// Length of a line, m.
[[nodiscard]] double length_of(std::span<const PathPoint> points, double cell_size);

/// Turns coarse routes into lines on the ground. Everything passed in must outlive it; the cache may be null.
class RouteRefiner {
 public:
  /// The lines of the first routes are known: `pinned`.
  RouteRefiner(const Ground& ground, const PlacedGround& placed, const std::vector<WalkJob>& jobs, const TrailGraph& trails,
               const std::vector<CoarseRoute>& routes, std::vector<RefinedRoute> pinned, MovementCache* cache);

  /// Routes that others join come first; those of one rank do not need each other.
  [[nodiscard]] std::vector<RefinedRoute> run(const TaskContext& context);
  /// Water that the least of those who walk a route wades, m.
  [[nodiscard]] float wade_depth(const CoarseRoute& route) const;

 private:
  struct Leg {
    std::uint64_t key = 0;
    std::vector<PathCell> cells;
  };
  /// The cells of a route, the weight at each, and where its legs begin.
  struct Draft {
    std::vector<PathCell> cells;
    std::vector<float> weight;
    /// First cell of each leg and the vertex (position in the route) there; the end comes last.
    std::vector<std::pair<std::size_t, std::size_t>> marks;
  };

  [[nodiscard]] std::uint64_t users_of(std::span<const std::uint32_t> edges) const;
  [[nodiscard]] int heaviest_of(std::span<const std::uint32_t> edges) const;
  [[nodiscard]] FineGround ground_for(std::uint64_t users, int heaviest) const;
  [[nodiscard]] std::optional<PathPoint> joint(int joined, std::uint32_t vertex, const FineGround& fine) const;
  [[nodiscard]] std::size_t leg_end(const CoarseRoute& route, std::size_t first) const;
  [[nodiscard]] PathCell place_of(std::uint32_t vertex) const;
  [[nodiscard]] std::vector<PathCell> refine_leg(std::span<const std::uint32_t> edges, std::span<const PathCell> over,
                                                 PathCell from, PathCell to, std::vector<Leg>& legs) const;
  [[nodiscard]] std::vector<PathCell> leg_on(const FineGround& fine, int heaviest, std::span<const PathCell> over, PathCell from,
                                             PathCell to, std::vector<Leg>& legs) const;
  [[nodiscard]] Draft draft(const CoarseRoute& route, std::optional<PathPoint> front, std::optional<PathPoint> back,
                            std::vector<Leg>& legs) const;
  [[nodiscard]] RefinedRoute refine(const CoarseRoute& route, std::vector<Leg>& legs) const;
  [[nodiscard]] std::vector<std::uint32_t> points_of_vertices(const CoarseRoute& route, const Draft& draft,
                                                              const std::vector<PathPoint>& points) const;

  const Ground& ground_;
  const PlacedGround& placed_;
  const std::vector<WalkJob>& jobs_;
  const TrailGraph& trails_;
  const std::vector<CoarseRoute>& routes_;
  MovementCache* cache_;
  std::vector<WalkCost> costs_;
  /// Cell of a waypoint by vertex of the trail graph.
  std::unordered_map<std::uint32_t, PathCell> waypoints_;
  std::size_t pinned_;
  std::vector<RefinedRoute> refined_;
};

}  // namespace biotope
