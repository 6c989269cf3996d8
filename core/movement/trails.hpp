#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/path_point.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/ecosystem/animal_level.hpp"
#include "core/movement/travel.hpp"

namespace biotope {

/// A worn trail: a smooth line with the yearly weight that walks along each of its points.
struct TrailRoute {
  std::vector<PathPoint> points;
  /// kg x trips per year at each point.
  std::vector<float> weight;
  double length = 0;  ///< m
  /// Index in Places::pinned_trails of the trail that a person drew; -1 where animals made it.
  int pinned = -1;
};

struct TrailWays;
class MovementCache;

/// Trails of all species together, and what they do to the ground. Pinned trails come first, in the order in which they were
/// placed.
struct TrailNetwork {
  std::vector<TrailRoute> routes;
  /// Worn fraction of each cell, 0..1: clears vegetation; 1 on the most used trails.
  Grid<float> wear;
  /// Metres the ground is carved, >= 0; a derived map, the terrain itself is never changed.
  Grid<float> carving;
  /// What daily plans need to walk on the trails (core/movement/trail_ways.hpp); null when nothing was computed.
  std::shared_ptr<const TrailWays> ways;
  double total_length() const {
    double sum = 0;
    for (const auto& route : routes) sum += route.length;
    return sum;
  }
};

/// Travel between the resources of one level, per species of the level.
struct LevelTravel {
  /// Distinct mobilities of the level and the graph of each.
  std::vector<std::shared_ptr<const TravelGraph>> graphs;
  /// Graph of each species of the level.
  std::vector<int> graph_of_species;
  /// Costs of each graph's directed edges as animals choose ways (placed_costs); empty where they are the graph's own.
  std::vector<std::vector<float>> placed_cost;
  [[nodiscard]] std::span<const float> cost(std::size_t graph) const {
    return graph < placed_cost.size() && !placed_cost[graph].empty() ? std::span<const float>(placed_cost[graph])
                                                                     : std::span<const float>(graphs[graph]->cost);
  }
  /// Vertex of each resource node in each graph, -1 where the species cannot stand there.
  std::vector<std::vector<std::int32_t>> vertex_of_node;
  /// P_s(v): probability of presence at each node, by species and region of that species (paper eq. 1): pairs {node,
  /// probability}, nodes ascending. Empty where the species finds nothing.
  struct Presence {
    int node = 0;
    float probability = 0;
  };
  std::vector<std::vector<std::vector<Presence>>> presence;
  /// P_s(v' | v) of each spatial edge of LevelMovement::edges (paper eq. 2); a node's onward probabilities sum to at most 1
  /// because only the most probable edges are kept.
  std::vector<float> onward;
};

/// P_s(v) of one species (index in the level) at every node of a region (paper eq. 1). Drinking counts as a need of a fixed
/// share. Waypoints get their attraction, together at most half of all, and what the animal needs gets the rest.
[[nodiscard]] std::vector<LevelTravel::Presence> presence_in_region(const FoodWeb& web, const AnimalLevel& level,
                                                                    int species_index, int region);

/// Region of the species (index in the level) that holds the node, -1 where it cannot be.
[[nodiscard]] int region_of_node(const AnimalLevel& level, int species_index, const ResourceNode& node);

/// Travel graphs, fields and presence of a level, and its spatial edges (directed, in seconds).
struct LevelMovement {
  std::shared_ptr<const LevelTravel> travel;
  /// Most probable onward edges, by species, node of departure, then node of arrival.
  std::vector<SpatialEdge> edges;
};
/// A cache (may be null) makes it faster, never different.
[[nodiscard]] Result<LevelMovement> compute_level_movement(const FoodWeb& web, const AnimalLevel& level, const Ground& ground,
                                                           const TaskContext& context = {}, MovementCache* cache = nullptr);

/// Trails worn by all levels (paper section 6.1, eqs. 1-3): weights accumulate on shared ground, routes are taken from the most
/// used outwards, refined on the full grid and smoothed by splines that never enter a cell blocked for the species that walk
/// there. A pinned trail (Ground::places) always is a route, whole, as worn as was asked and by all who walk on it besides, even
/// over ground that nobody can walk: there it is a person's wish, and herds go around. No other route enters a forbidden
/// corridor: those who must cross it leave no trail.
[[nodiscard]] Result<TrailNetwork> compute_trails(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                                  std::span<const LevelMovement> movement, const Ground& ground,
                                                  const TaskContext& context = {}, MovementCache* cache = nullptr);

}  // namespace biotope
