#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/movement/travel.hpp"

namespace biotope {

/// Costs that replace a graph's own are at most this many times those, or than the highest that a search was made with.
inline constexpr float highest_cost_factor = 1.25F;

/// Repeated one-to-many searches on one graph that reuse their memory. A circular bucket queue; vertices of the bucket at hand
/// are relaxed until none improves, so costs are exact; of equally good parents the one with the smaller number is kept.
class TravelSearch {
 public:
  /// `cost` replaces the graph's own costs (one a directed edge); both must outlive the search, but may change between runs,
  /// within highest_cost_factor of the graph's or this cost.
  TravelSearch(const TravelGraph& graph, std::span<const float> cost);

  /// Searches from `source`. When `counts` is given (a number a vertex), stops once vertices with `wanted` counts in sum are
  /// settled.
  void run(std::uint32_t source, std::span<const std::uint16_t> counts = {}, std::uint32_t wanted = 0);

  /// Cost of a vertex, infinity where it was not settled or cannot be reached.
  [[nodiscard]] float cost(std::uint32_t vertex) const {
    const float best = vertices_[vertex].best;
    return complete_ || (best < std::numeric_limits<float>::max() && bucket_of(best) < current_)
               ? best
               : std::numeric_limits<float>::infinity();
  }
  [[nodiscard]] std::int32_t parent(std::uint32_t vertex) const { return vertices_[vertex].parent; }
  /// The directed edge from its parent to a vertex.
  [[nodiscard]] std::uint32_t parent_slot(std::uint32_t vertex) const { return vertices_[vertex].parent_slot; }

 private:
  struct Vertex {
    float best = std::numeric_limits<float>::infinity();
    /// Cost it was last relaxed with.
    float relaxed = std::numeric_limits<float>::infinity();
    std::int32_t parent = -1;
    std::uint32_t parent_slot = 0;
  };

  [[nodiscard]] std::uint32_t bucket_of(float cost) const { return std::uint32_t(cost * per_width_); }
  void reset();
  void relax(std::uint32_t vertex);

  const TravelGraph& graph_;
  std::span<const float> edge_cost_;
  float width_ = 1;
  float per_width_ = 1;
  /// Everything reachable is settled; else what lies in buckets before the current one.
  bool complete_ = false;
  std::uint32_t current_ = 0;
  std::size_t queued_ = 0;
  std::uint32_t bucket_mask_ = 0;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> touched_;
};

/// Vertices from the source of `search` to `target`, both included; empty where it was not settled.
[[nodiscard]] std::vector<std::uint32_t> travel_path(const TravelSearch& search, std::uint32_t target);

}  // namespace biotope
