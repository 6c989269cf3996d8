#include <cmath>
#include <limits>
#include <optional>

#include "core/movement/fine_path.hpp"
#include "core/movement/placed_ground.hpp"

namespace biotope {
namespace {

/// No edge is free: ways stay as short as they can be. m.
constexpr float least_cost = 0.01F;

std::optional<std::uint32_t> slot_between(const TravelGraph& graph, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t slot = graph.first_edge[from]; slot < graph.first_edge[from + 1]; ++slot) {
    if (graph.target[slot] == to) return slot;
  }
  return std::nullopt;
}

/// A piece of a line within one vertex, and the point of it that is nearest to the vertex's cell.
struct Passage {
  std::uint32_t vertex = 0;
  std::uint32_t point = 0;
  /// Walked to from the passage before without leaving passable ground.
  bool joined = false;
};

std::vector<Passage> passages_of(const TravelGraph& graph, const std::vector<PathPoint>& points) {
  std::vector<Passage> passages;
  bool joined = false;
  double nearest = 0;
  const auto see = [&](PathPoint at, std::uint32_t point) {
    const PathCell cell = cell_at(at);
    const std::int32_t vertex = graph.vertex_of_cell.contains(cell.x, cell.y) ? graph.vertex_of_cell(cell.x, cell.y) : -1;
    if (vertex < 0) {
      joined = false;
      return;
    }
    const TravelGraph::Vertex& place = graph.vertices[std::size_t(vertex)];
    const double distance = std::hypot(double(points[point].x) - place.x, double(points[point].y) - place.y);
    if (!joined || passages.back().vertex != std::uint32_t(vertex)) {
      passages.push_back({std::uint32_t(vertex), point, joined});
      nearest = distance;
    } else if (distance < nearest) {
      passages.back().point = point;
      nearest = distance;
    }
    joined = true;
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const PathPoint a = points[i];
    const PathPoint b = points[i + 1];
    const int pieces = std::max(1, int(std::ceil(2.5F * std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)))));
    for (int k = 0; k <= pieces; ++k) {
      const float t = float(k) / float(pieces);
      see({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}, std::uint32_t(2 * k <= pieces ? i : i + 1));
    }
  }
  return passages;
}

/// Share of the straight line between two vertices that is forbidden.
float forbidden_share(const TravelGraph& graph, const PlacedGround& placed, std::uint32_t a, std::uint32_t b) {
  const TravelGraph::Vertex& from = graph.vertices[std::min(a, b)];
  const TravelGraph::Vertex& to = graph.vertices[std::max(a, b)];
  const Rect box{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x) + 1, std::max(from.y, to.y) + 1};
  if (intersection(box, placed.bounds()).empty()) return 0;
  const int steps = 2 * std::max({1, std::abs(to.x - from.x), std::abs(to.y - from.y)});
  int inside = 0;
  for (int i = 0; i < steps; ++i) {
    const float t = (float(i) + 0.5F) / float(steps);
    const PathCell cell = cell_at({float(from.x) + float(to.x - from.x) * t, float(from.y) + float(to.y - from.y) * t});
    inside += placed.at(cell.x, cell.y) == PlacedGround::forbidden;
  }
  return float(inside) / float(steps);
}

}  // namespace

std::vector<PinnedStretch> pinned_stretches(const TravelGraph& graph, const PlacedGround& placed) {
  std::vector<PinnedStretch> stretches;
  for (std::size_t number = 0; number < placed.lines().size(); ++number) {
    const std::vector<Passage> passages = passages_of(graph, placed.lines()[number].points);
    for (std::size_t i = 1; i < passages.size(); ++i) {
      const Passage& a = passages[i - 1];
      const Passage& b = passages[i];
      if (!b.joined) continue;
      const auto slot = slot_between(graph, a.vertex, b.vertex);
      if (slot) stretches.push_back({std::uint32_t(number), a.vertex, b.vertex, *slot, a.point, b.point});
    }
  }
  return stretches;
}

std::vector<float> placed_costs(const Ground& ground, const TravelGraph& graph, const PlacedGround& placed) {
  if (placed.empty()) return {};
  std::vector<float> cost = graph.cost;
  for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
    for (std::uint32_t slot = graph.first_edge[v]; slot < graph.first_edge[v + 1]; ++slot) {
      const float share = forbidden_share(graph, placed, v, graph.target[slot]);
      if (share > 0) cost[slot] *= 1 + (forbidden_factor - 1) * share;
    }
  }
  const FineGround fine(ground, {&graph}, WalkCost(graph.mobility), trail_step);
  for (const PinnedStretch& stretch : pinned_stretches(graph, placed)) {
    const auto& points = placed.lines()[stretch.line].points;
    const auto back = slot_between(graph, stretch.to, stretch.from);
    double forth_walk = 0;
    double back_walk = 0;
    for (std::size_t i = stretch.first; i < stretch.last; ++i) {
      forth_walk += fine.walk_between(points[i], points[i + 1]);
      back_walk += fine.walk_between(points[i + 1], points[i]);
    }
    cost[stretch.slot] = std::max(least_cost, pinned_factor * std::min(graph.cost[stretch.slot], float(forth_walk)));
    cost[*back] = std::max(least_cost, pinned_factor * std::min(graph.cost[*back], float(back_walk)));
  }
  return cost == graph.cost ? std::vector<float>{} : cost;
}

}  // namespace biotope
