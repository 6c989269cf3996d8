#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/movement/fine_path.hpp"
#include "core/movement/travel.hpp"

namespace biotope {

/// Walks on the edges of one travel graph.
struct WalkedGraph {
  const TravelGraph* graph = nullptr;
  /// By undirected edge, kg x trips per year.
  std::vector<double> weight;
};

/// All walks together: vertices that stand on the same cell are one, whoever walks there.
struct TrailGraph {
  struct Edge {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    double weight = 0;
    double length = 0;  ///< cells
    /// Bit i: walked_graphs[i] walks here.
    std::uint64_t users = 0;
    /// The one that walks most.
    int heaviest = 0;
    /// Number of the pinned line it follows, -1 when it follows none.
    int pinned = -1;
  };
  std::vector<PathCell> cells;
  std::vector<Edge> edges;
  /// Edges at vertex v are incident[first_incident[v] .. first_incident[v + 1]), heaviest first.
  std::vector<std::uint32_t> first_incident;
  std::vector<std::uint32_t> incident;
};

/// Merges at most 64 graphs.
[[nodiscard]] TrailGraph merge_walks(std::span<const WalkedGraph> walked);

/// A route over the trail graph; ends that lie on an earlier route name it.
struct CoarseRoute {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> edges;
  int joins_front = -1;
  int joins_back = -1;
  /// 0 when it joins none, else one more than the highest rank it joins.
  int rank = 0;
};

/// Routes from the most used segment outwards, each extended at both ends by the heaviest segment that is not in a route yet,
/// until 99 % of weight x length is covered (as the 2021 authors do) or there are `most` routes. The first `pinned` routes stand
/// for the pinned lines: they have no vertices and edges of their own, but others join them where they meet an edge that follows
/// the line.
[[nodiscard]] std::vector<CoarseRoute> extract_routes(const TrailGraph& trails, std::size_t most, std::size_t pinned);

}  // namespace biotope
