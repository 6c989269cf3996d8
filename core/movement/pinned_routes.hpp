#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "core/movement/placed_ground.hpp"
#include "core/movement/trail_refiner.hpp"
#include "core/movement/trail_routes.hpp"
#include "core/movement/trail_walks.hpp"
#include "core/movement/trail_ways.hpp"

namespace biotope {

/// Which edges of the travel graphs follow which points of the pinned lines: the same cells, whoever walks there. The routes of a
/// network begin with the pinned ones, in the order of PlacedGround::lines.
using PinnedEdges = std::unordered_map<std::uint64_t, TrailWays::Stretch>;
[[nodiscard]] PinnedEdges pinned_edges(const std::vector<WalkJob>& jobs, const PlacedGround& placed);

/// Notes in TrailGraph::Edge::pinned the line that an edge follows.
void mark_pinned(const PinnedEdges& pinned, int width, TrailGraph& trails);

/// The pinned lines as routes: as worn as was asked, and by what walks on them.
[[nodiscard]] std::vector<RefinedRoute> pinned_routes(const PlacedGround& placed, const PinnedEdges& pinned,
                                                      const TrailGraph& trails, int width, double cell_size);

/// The pieces [first, last) of a line that enter no forbidden cell, of at least two points.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> allowed_pieces(const PlacedGround& placed,
                                                                              std::span<const PathPoint> points);

}  // namespace biotope
