#include <algorithm>

#include "core/movement/travel_search.hpp"

namespace biotope {
namespace {
constexpr float unreached = std::numeric_limits<float>::infinity();
}

TravelSearch::TravelSearch(const TravelGraph& graph, std::span<const float> cost)
    : graph_(graph),
      edge_cost_(cost),
      best_(graph.vertices.size(), unreached),
      relaxed_(graph.vertices.size(), unreached),
      parent_(graph.vertices.size(), -1),
      parent_slot_(graph.vertices.size(), 0) {
  double sum = 0;
  float longest = 1;
  for (const float c : cost) {
    sum += c;
    longest = std::max(longest, c);
  }
  // Half a mean edge a bucket; enough buckets for the longest edge, so that a circle of them never overlaps.
  width_ = cost.empty() ? 1.0F : std::max(float(0.5 * sum / double(cost.size())), longest / 4096);
  buckets_.resize(std::size_t(longest / width_) + 3);
}

void TravelSearch::reset() {
  for (const std::uint32_t vertex : touched_) {
    best_[vertex] = unreached;
    relaxed_[vertex] = unreached;
    parent_[vertex] = -1;
  }
  touched_.clear();
  for (auto& bucket : buckets_) bucket.clear();
  queued_ = 0;
  current_ = 0;
}

void TravelSearch::relax(std::uint32_t vertex) {
  const float here = best_[vertex];
  for (std::uint32_t slot = graph_.first_edge[vertex]; slot < graph_.first_edge[vertex + 1]; ++slot) {
    const std::uint32_t to = graph_.target[slot];
    const float there = here + edge_cost_[slot];
    if (there > best_[to]) continue;
    if (there == best_[to]) {
      if (parent_[to] > std::int32_t(vertex)) {
        parent_[to] = std::int32_t(vertex);
        parent_slot_[to] = slot;
      }
      continue;
    }
    if (best_[to] == unreached) touched_.push_back(to);
    best_[to] = there;
    parent_[to] = std::int32_t(vertex);
    parent_slot_[to] = slot;
    buckets_[std::size_t(there / width_) % buckets_.size()].push_back(to);
    ++queued_;
  }
}

void TravelSearch::run(std::uint32_t source, std::span<const std::uint16_t> counts, std::uint32_t wanted) {
  reset();
  best_[source] = 0;
  touched_.push_back(source);
  buckets_[0].push_back(source);
  queued_ = 1;
  std::uint32_t counted = 0;
  while (queued_ > 0) {
    auto& bucket = buckets_[current_ % buckets_.size()];
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      const std::uint32_t vertex = bucket[i];
      if (relaxed_[vertex] == best_[vertex]) continue;
      if (!counts.empty() && relaxed_[vertex] == unreached) counted += counts[vertex];
      relaxed_[vertex] = best_[vertex];
      relax(vertex);
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
