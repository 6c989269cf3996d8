#include <algorithm>
#include <cmath>
#include <optional>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// The cell of some piece nearest to a point, the first in row order of equals; none farther than `reach` cells.
std::optional<NearestCell> nearest_passable(const RunMap& piece, PathPoint point, double reach) {
  std::optional<NearestCell> nearest;
  double best = reach * reach;
  const int x0 = std::max(0, int(std::ceil(double(point.x) - reach)));
  const int x1 = std::min(piece.width() - 1, int(std::floor(double(point.x) + reach)));
  const int y0 = std::max(0, int(std::ceil(double(point.y) - reach)));
  const int y1 = std::min(piece.height() - 1, int(std::floor(double(point.y) + reach)));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double dx = x - double(point.x);
      const double dy = y - double(point.y);
      const double distance = dx * dx + dy * dy;
      if (piece(x, y) < 0 || distance > best || (nearest && distance == best)) continue;
      best = distance;
      nearest = NearestCell{x, y};
    }
  }
  return nearest;
}

void add_node(const ResourceSources& sources, PathPoint at, float attraction, GraphLevel& graph) {
  // The nearest cell counts however large cells are.
  const double reach = std::max(waypoint_reach / sources.ground.terrain->cell_size, 0.7072);
  const auto cell = nearest_passable(sources.partition.label, at, reach);
  if (!cell) return;
  Area area;
  area.add_run(cell->y, {cell->x, cell->x + 1, 0});
  ResourceNode node = node_of_area(area, *cell, sources.ground.terrain->cell_area());
  node.kind = NodeKind::waypoint;
  node.piece = sources.partition.label(cell->x, cell->y);
  node.attraction = attraction;
  graph.nodes.push_back(std::move(node));
}

}  // namespace

void add_waypoint_nodes(const ResourceSources& sources, GraphLevel& graph) {
  if (!sources.ground.places) return;
  const Places& places = *sources.ground.places;
  for (const Waypoint& waypoint : places.waypoints) add_node(sources, waypoint.at, waypoint.attraction, graph);
  for (const PlacedExit& exit : places.exits) add_node(sources, exit.at, exit_attraction, graph);
}

}  // namespace biotope
