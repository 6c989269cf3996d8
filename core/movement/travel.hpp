#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/task_context.hpp"
#include "core/ecosystem/animal_level.hpp"
#include "core/movement/block_vertices.hpp"

namespace biotope {

/// Walking speed (m/s) on a step of slope S = rise / run: v exp(-k (|S + 0.05| - 0.05)); 0 beyond the limit.
[[nodiscard]] float walking_speed(float flat_speed, float slope, float slope_sensitivity, float max_slope);

/// A coarse directed graph whose vertices are the connected pieces of passable ground inside square blocks of fine cells, so that
/// it connects exactly what the fine grid connects. Edges carry metres of flat walking (time x speed), one value each way.
struct TravelGraph {
  Mobility mobility;
  int block = 1;    ///< side of a block, cells
  int columns = 0;  ///< blocks
  int rows = 0;
  struct Vertex {
    int x = 0;  ///< passable cell that stands for the vertex
    int y = 0;
    int region = -1;
  };
  std::vector<Vertex> vertices;
  /// Edges of vertex v are [first_edge[v], first_edge[v + 1]).
  std::vector<std::uint32_t> first_edge;
  std::vector<std::uint32_t> target;
  std::vector<float> cost;
  /// Number of the undirected edge of each directed one: both directions of a pair share it, 0 .. edge_count - 1.
  std::vector<std::uint32_t> edge;
  std::uint32_t edge_count = 0;
  float mean_cost = 0;
  float longest_cost = 0;
  /// Vertex of each cell, -1 where blocked.
  BlockVertices vertex_of_cell;
  /// By block, row by row: 0 where all its cells are passable, else a hash of which are.
  std::vector<std::uint64_t> open_cells;
};

/// Side of a block (cells) that suits a landscape: about 80 blocks along the longer side, at least one cell each. Our choice:
/// fine enough for trails to be told apart, coarse enough that a search from every resource takes less than a millisecond.
[[nodiscard]] int travel_block(int width, int height);

/// Cells an animal goes in one step of a path: about 4 m, at least one cell and at most four. Our choice.
[[nodiscard]] int walking_stride(double cell_size);

/// Builds the graph of one mobility over its confinement regions. Parallel over blocks.
[[nodiscard]] TravelGraph build_travel_graph(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility,
                                             int block);

/// Shortest costs from one vertex to all others, and the tree (parent vertex, -1 at the source and where unreachable).
struct TravelField {
  std::vector<float> cost;  ///< metres of flat walking; infinity where unreachable
  std::vector<std::int32_t> parent;
};
[[nodiscard]] TravelField travel_field(const TravelGraph& graph, std::uint32_t source);

}  // namespace biotope
