#pragma once

#include <cstdint>
#include <vector>

#include "core/movement/travel.hpp"

namespace biotope {

/// Two vertices in neighbouring blocks and the cost each way.
struct VertexPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  float forth = 0;
  float back = 0;
};

/// Parts of a graph by block, row by row, kept so that the next graph is built only where something changed.
struct TravelBlocks {
  std::vector<std::vector<VertexPair>> pairs;
};

/// A graph of the same mobility and blocks on a ground of the same size and cells, and where the ground is the same.
struct KnownGraph {
  const TravelGraph& graph;
  const TravelBlocks& blocks;
  const RunMap& label;
  /// By block: whether heights and water are those of the ground of now; empty where they are everywhere.
  std::vector<char> same_ground;
};

/// build_travel_graph that takes over from a known graph (null: none) all blocks in which the same cells are passable. The result
/// is the same without it.
[[nodiscard]] TravelGraph build_travel_graph(const Ground& ground, const ConfinementRegions& regions, const Mobility& mobility,
                                             int block, const KnownGraph* known, TravelBlocks& blocks);

/// By block: whether heights and depths of water of two grounds of one size are the same.
[[nodiscard]] std::vector<char> blocks_of_same_ground(const Ground& a, const Ground& b, int block);

}  // namespace biotope
