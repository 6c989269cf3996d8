#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/rect.hpp"
#include "core/ecosystem/run_map.hpp"

namespace biotope {

/// A waypoint offers nothing to eat: herds come by (Waypoint, PlacedExit).
enum class NodeKind : std::uint8_t { bank, vegetation, prey, waypoint };

/// An amount of one species that a node offers.
struct ResourceQuantity {
  int species = 0;                ///< number in the food web
  double kilograms_per_year = 0;  ///< yearly growth within the node, before anybody eats
  double available = 0;           ///< what the levels below left of it, kg per year
};

/// A node of the graph: one contiguous area where resources of a level are found (paper section 5).
struct ResourceNode {
  NodeKind kind = NodeKind::vegetation;
  /// Stratum of vegetation, or the prey's species number; 0 for banks and waypoints.
  int group = 0;
  double area = 0;  ///< m2
  std::size_t cells = 0;
  Rect bounds;
  /// Mean position of the area's cells, in cells.
  float centroid_x = 0;
  float centroid_y = 0;
  /// The passable cell of the area nearest to the centroid.
  int x = 0;
  int y = 0;
  /// Piece of the level's partition that holds the node.
  int piece = -1;
  std::vector<ResourceQuantity> quantities;
  /// For prey: the region of the prey species this node stands for.
  int prey_region = -1;
  /// For waypoints: the probability that a species of the region comes by (Waypoint::attraction; of exits exit_attraction); 0 for
  /// others.
  float attraction = 0;
  /// Hierarchical edges of a prey node: the nodes of the prey's own level in the prey's region. Empty for waypoints, and for
  /// banks and vegetation, which are built from the cells of level 0 themselves.
  std::vector<int> built_from;
};

/// A directed edge: `species` walks from one node to another in `seconds`.
struct SpatialEdge {
  int from = 0;
  int to = 0;
  int species = 0;
  float seconds = 0;
};

/// One level of the Resource Access Graph: resources for the species of that level.
struct GraphLevel {
  int level = 1;
  std::vector<ResourceNode> nodes;
  std::vector<SpatialEdge> edges;
  /// Node of each cell, -1 where none: one map a kind of ground resource, indexed by stratum; [3] are the banks. Never null.
  std::array<std::shared_ptr<const RunMap>, 4> node_of_cell;
};

/// All levels; levels[0] stands for the cells (a node a cell, no list), levels[i] for food-chain level i.
struct ResourceAccessGraph {
  std::vector<GraphLevel> levels;
};

}  // namespace biotope
