#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/movement/fine_path.hpp"
#include "core/movement/walkers.hpp"

namespace biotope {

/// One travel graph, who walks on it and where they may be.
struct WalkJob {
  std::shared_ptr<const TravelGraph> graph;
  /// Of its directed edges (LevelTravel::cost).
  std::span<const float> cost;
  const RunMap* region = nullptr;
  std::vector<Walkers> walkers;
  double total = 0;
  /// Vertices where a waypoint is, with its cell: trails over such a vertex lead to the waypoint itself.
  std::vector<std::pair<std::uint32_t, PathCell>> waypoints;
};

/// Graphs of all levels that somebody walks on, most weight first; at most 64.
[[nodiscard]] std::vector<WalkJob> list_walk_jobs(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                                  std::span<const LevelMovement> movement);

/// What the walks of one job left, and the costs of its graph's directed edges after all have walked.
struct JobWalks {
  std::vector<double> weight;
  std::vector<float> worn_cost;
};

/// Walks on all graphs, the heaviest first: what they have worn draws the others. Jobs too light to leave a trail of their own do
/// not wear any, but are drawn to what others wore. Fewer than jobs when stopped.
[[nodiscard]] std::vector<JobWalks> walk_all(const std::vector<WalkJob>& jobs, const TaskContext& context);

}  // namespace biotope
