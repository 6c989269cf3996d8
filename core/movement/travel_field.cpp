#include <algorithm>
#include <bit>
#include <cassert>

#include "core/movement/travel_search.hpp"

namespace biotope {
namespace {
constexpr float unreached = std::numeric_limits<float>::infinity();
}

TravelSearch::TravelSearch(const TravelGraph& graph, std::span<const float> cost)
    : graph_(graph), edge_cost_(cost), vertices_(graph.vertices.size()) {
  assert(cost.size() == graph.cost.size());
  const float longest_own = std::max(1.0F, graph.longest_cost * highest_cost_factor);
  // Half a mean edge a bucket; enough buckets for the longest edge, so that a circle of them never overlaps.
  width_ = std::max({0.5F * graph.mean_cost, longest_own / 4096, 1e-3F});
  per_width_ = 1 / width_;
  // The bits of numbers that are not negative are in their order, and faster to compare.
  std::uint32_t highest = 0;
  for (const float one : cost) highest = std::max(highest, std::bit_cast<std::uint32_t>(one));
  const float longest = std::max(longest_own, std::bit_cast<float>(highest) * highest_cost_factor);
  buckets_.resize(std::bit_ceil(std::size_t(longest / width_) + 3));
  bucket_mask_ = std::uint32_t(buckets_.size() - 1);
}

void TravelSearch::reset() {
  for (const std::uint32_t vertex : touched_) vertices_[vertex] = {};
  touched_.clear();
  if (queued_ > 0) {
    for (auto& bucket : buckets_) bucket.clear();
  }
  queued_ = 0;
  current_ = 0;
}

void TravelSearch::relax(std::uint32_t vertex) {
  const float here = vertices_[vertex].best;
  const std::uint32_t last = graph_.first_edge[vertex + 1];
  for (std::uint32_t slot = graph_.first_edge[vertex]; slot < last; ++slot) {
    const std::uint32_t to = graph_.target[slot];
    const float there = here + edge_cost_[slot];
    Vertex& other = vertices_[to];
    if (there > other.best) continue;
    if (there == other.best) {
      if (other.parent > std::int32_t(vertex)) {
        other.parent = std::int32_t(vertex);
        other.parent_slot = slot;
      }
      continue;
    }
    if (other.best == unreached) touched_.push_back(to);
    other.best = there;
    other.parent = std::int32_t(vertex);
    other.parent_slot = slot;
    buckets_[bucket_of(there) & bucket_mask_].push_back(to);
    ++queued_;
  }
}

void TravelSearch::run(std::uint32_t source, std::span<const std::uint16_t> counts, std::uint32_t wanted) {
  reset();
  vertices_[source].best = 0;
  touched_.push_back(source);
  buckets_[0].push_back(source);
  queued_ = 1;
  std::uint32_t counted = 0;
  while (queued_ > 0) {
    auto& bucket = buckets_[current_ & bucket_mask_];
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      Vertex& vertex = vertices_[bucket[i]];
      if (vertex.relaxed == vertex.best) continue;
      if (!counts.empty() && vertex.relaxed == unreached) counted += counts[bucket[i]];
      vertex.relaxed = vertex.best;
      relax(bucket[i]);
    }
    queued_ -= bucket.size();
    bucket.clear();
    ++current_;
    if (!counts.empty() && counted >= wanted) break;
  }
  complete_ = queued_ == 0;
}

std::vector<std::uint32_t> travel_path(const TravelSearch& search, std::uint32_t target) {
  std::vector<std::uint32_t> path;
  if (search.cost(target) == unreached) return path;
  for (auto vertex = std::int32_t(target); vertex >= 0; vertex = search.parent(std::uint32_t(vertex))) {
    path.push_back(std::uint32_t(vertex));
  }
  std::reverse(path.begin(), path.end());
  return path;
}

TravelField travel_field(const TravelGraph& graph, std::uint32_t source) {
  TravelSearch search(graph, graph.cost);
  search.run(source);
  TravelField field;
  field.cost.resize(graph.vertices.size());
  field.parent.resize(graph.vertices.size());
  for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
    field.cost[v] = search.cost(v);
    field.parent[v] = search.parent(v);
  }
  return field;
}

}  // namespace biotope
