#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/movement/travel.hpp"

namespace biotope {

/// How the trails of a network serve those who walk from place to place.
struct TrailWays {
  /// A travel graph with the costs of its directed edges once trails are worn.
  struct WornGraph {
    std::shared_ptr<const TravelGraph> graph;
    std::vector<float> cost;
  };
  std::vector<WornGraph> graphs;

  /// The points [first .. last] of a route that lead from one cell to another; first may lie after last.
  struct Stretch {
    std::uint32_t route = 0;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  /// By the cells (indices) of the two vertices of an edge, the smaller one first.
  std::unordered_map<std::uint64_t, Stretch> stretches;

  [[nodiscard]] static std::uint64_t key(std::uint32_t smaller, std::uint32_t larger) { return (std::uint64_t(smaller) << 32) | larger; }
  /// The graph with worn costs; null when nobody of it walked.
  [[nodiscard]] const WornGraph* find(const TravelGraph* graph) const {
    for (const WornGraph& worn : graphs) {
      if (worn.graph.get() == graph) return &worn;
    }
    return nullptr;
  }
};

}  // namespace biotope
