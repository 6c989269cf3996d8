#include "core/movement/pinned_routes.hpp"

#include <algorithm>

namespace biotope {
namespace {

std::uint64_t key_between(PathCell p, PathCell q, int width) {
  const auto index = [&](PathCell c) { return std::uint32_t(c.y) * std::uint32_t(width) + std::uint32_t(c.x); };
  return TrailWays::key(std::min(index(p), index(q)), std::max(index(p), index(q)));
}

}  // namespace

PinnedEdges pinned_edges(const std::vector<WalkJob>& jobs, const PlacedGround& placed) {
  PinnedEdges edges;
  if (placed.lines().empty()) return edges;
  for (const WalkJob& job : jobs) {
    const TravelGraph& graph = *job.graph;
    const int width = graph.vertex_of_cell.width();
    for (const PinnedStretch& stretch : pinned_stretches(graph, placed)) {
      const PathCell from{graph.vertices[stretch.from].x, graph.vertices[stretch.from].y};
      const PathCell to{graph.vertices[stretch.to].x, graph.vertices[stretch.to].y};
      TrailWays::Stretch points{stretch.line, stretch.first, stretch.last};
      if (std::pair{to.y, to.x} < std::pair{from.y, from.x}) std::swap(points.first, points.last);
      edges.emplace(key_between(from, to, width), points);
    }
  }
  return edges;
}

void mark_pinned(const PinnedEdges& pinned, int width, TrailGraph& trails) {
  if (pinned.empty()) return;
  for (TrailGraph::Edge& edge : trails.edges) {
    const auto found = pinned.find(key_between(trails.cells[edge.a], trails.cells[edge.b], width));
    if (found != pinned.end()) edge.pinned = int(found->second.route);
  }
}

std::vector<RefinedRoute> pinned_routes(const PlacedGround& placed, const PinnedEdges& pinned, const TrailGraph& trails,
                                        int width, double cell_size) {
  std::vector<RefinedRoute> routes;
  // By segment between two points.
  std::vector<std::vector<float>> walked;
  for (const PinnedLine& line : placed.lines()) {
    routes.push_back(
        {{line.points, std::vector<float>(line.points.size(), line.weight), length_of(line.points, cell_size), line.trail}, {}});
    walked.emplace_back(line.points.size() - 1, 0.0F);
  }
  for (const TrailGraph::Edge& edge : trails.edges) {
    if (edge.pinned < 0) continue;
    const TrailWays::Stretch& stretch = pinned.at(key_between(trails.cells[edge.a], trails.cells[edge.b], width));
    auto& segments = walked[stretch.route];
    for (std::size_t i = std::min(stretch.first, stretch.last); i < std::max(stretch.first, stretch.last); ++i)
      segments[i] += float(edge.weight);
  }
  for (std::size_t r = 0; r < routes.size(); ++r) {
    walked[r].push_back(walked[r].back());
    const std::vector<float> by_point = blurred_weight(walked[r]);
    for (std::size_t i = 0; i < by_point.size(); ++i) routes[r].line.weight[i] += by_point[i];
  }
  return routes;
}

std::vector<std::pair<std::size_t, std::size_t>> allowed_pieces(const PlacedGround& placed, std::span<const PathPoint> points) {
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  for (std::size_t first = 0; first + 1 < points.size();) {
    std::size_t last = first + 1;
    while (last < points.size() && !placed.forbids(points[last - 1], points[last])) ++last;
    if (last - first >= 2) pieces.emplace_back(first, last);
    first = last;
  }
  return pieces;
}

}  // namespace biotope
