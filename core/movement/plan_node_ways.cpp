#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/movement/plan_parts.hpp"
#include "core/movement/travel_search.hpp"

namespace biotope {
namespace {

/// Places a straight line may skip, and by how much it may cost more than going by them. Our choice.
constexpr std::size_t most_skipped = 6;
constexpr double skipping_cost = 1.02;

PathPoint point_of(PathCell cell) { return {float(cell.x), float(cell.y)}; }

PathCell place_of(const TravelGraph& graph, std::uint32_t vertex) { return {graph.vertices[vertex].x, graph.vertices[vertex].y}; }

/// Around what lies between two neighbouring places when the straight line is not clear.
std::vector<PathCell> way_around(const FineGround& ground, int block, PathCell a, PathCell b) {
  const std::array over{a, b};
  return fine_path(ground, block, over, a, b);
}

/// Draws ways over a travel graph on the fine ground: straight from place to place, past places where that costs no more, and around obstacles.
class WayDrawer {
 public:
  WayDrawer(const FineGround& ground, const TravelGraph& graph) : ground_(ground), graph_(graph) {}

  [[nodiscard]] NodeWay draw(std::span<const std::uint32_t> vertices, PathCell from, PathCell to) const {
    std::vector<PathCell> places{from};
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i) places.push_back(place_of(graph_, vertices[i]));
    if (from != to) places.push_back(to);
    std::vector<PathPoint> points{point_of(from)};
    for (std::size_t at = 0; at + 1 < places.size();) {
      const std::size_t next = farthest(places, at);
      if (next > at) {
        append_line(points, places[at], places[next]);
        at = next;
        continue;
      }
      const auto around = way_around(ground_, graph_.block, places[at], places[at + 1]);
      if (around.empty()) return whole(places, from, to);
      for (std::size_t i = 1; i < around.size(); ++i) points.push_back(point_of(around[i]));
      ++at;
    }
    return costed(smooth_path(ground_, std::move(points)));
  }

 private:
  /// Place that a straight line reaches from place `at`; `at` itself when not even the next one.
  [[nodiscard]] std::size_t farthest(const std::vector<PathCell>& places, std::size_t at) const {
    const PathPoint start = point_of(places[at]);
    std::size_t reached = at;
    double by_places = 0;
    for (std::size_t next = at + 1; next < std::min(places.size(), at + 1 + most_skipped); ++next) {
      const PathPoint end = point_of(places[next]);
      if (!ground_.clear(start, end)) break;
      by_places += ground_.walk_along(point_of(places[next - 1]), end);
      if (next > at + 1 && ground_.walk_along(start, end) > by_places * skipping_cost) break;
      reached = next;
    }
    return reached;
  }

  void append_line(std::vector<PathPoint>& points, PathCell a, PathCell b) const {
    const int pieces = std::max(1, std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / ground_.stride());
    for (int i = 1; i <= pieces; ++i) {
      const float t = float(i) / float(pieces);
      points.push_back({float(a.x) + float(b.x - a.x) * t, float(a.y) + float(b.y - a.y) * t});
    }
  }

  /// Where two places do not connect closely: a search along the whole way.
  [[nodiscard]] NodeWay whole(const std::vector<PathCell>& places, PathCell from, PathCell to) const {
    const auto cells = fine_path(ground_, graph_.block, places, from, to);
    return cells.empty() ? NodeWay{} : costed(smooth_path(ground_, points_of(cells)));
  }

  [[nodiscard]] NodeWay costed(std::vector<PathPoint> points) const {
    NodeWay way{std::move(points), {0}};
    for (std::size_t i = 1; i < way.points.size(); ++i) {
      way.cost.push_back(way.cost.back() + ground_.walk_between(way.points[i - 1], way.points[i]));
    }
    return way;
  }

  const FineGround& ground_;
  const TravelGraph& graph_;
};

}  // namespace

std::optional<PathCell> standing_cell(const TravelGraph& graph, const ResourceNode& node) {
  const auto& cells = graph.vertex_of_cell;
  // The node's cell is passable for some species of the level; another stands at the nearest cell that it can reach.
  for (int ring = 0; ring <= std::max(2, graph.block / 2); ++ring) {
    for (int y = node.y - ring; y <= node.y + ring; ++y) {
      const int step = std::abs(y - node.y) == ring ? 1 : std::max(1, 2 * ring);
      for (int x = node.x - ring; x <= node.x + ring; x += step) {
        if (cells.contains(x, y) && cells(x, y) >= 0) return PathCell{x, y};
      }
    }
  }
  return std::nullopt;
}

FineGround fine_ground(const PlanInput& input, int graph) {
  const LevelTravel& travel = *input.movement.travel;
  const auto species = std::find(travel.graph_of_species.begin(), travel.graph_of_species.end(), graph) - travel.graph_of_species.begin();
  return {input.ground,
          {&input.level.regions[std::size_t(species)]->label},
          WalkCost(travel.graphs[std::size_t(graph)]->mobility),
          plan_step};
}

void NodeWays::need(int graph, int from, int to) { ways_[{graph, from}].try_emplace(to); }

void NodeWays::find() {
  std::vector<FineGround> grounds;
  for (std::size_t g = 0; g < input_.movement.travel->graphs.size(); ++g) grounds.push_back(fine_ground(input_, int(g)));
  std::vector<std::pair<const std::pair<int, int>, std::map<int, NodeWay>>*> groups;
  for (auto& group : ways_) groups.push_back(&group);
  parallel_each(groups.size(), [&](std::size_t i) {
    const auto [number, from] = groups[i]->first;
    const TravelGraph& graph = *input_.movement.travel->graphs[std::size_t(number)];
    const auto& nodes = input_.level.graph->nodes;
    const auto start = standing_cell(graph, nodes[std::size_t(from)]);
    if (!start) return;
    std::vector<std::uint16_t> goals(graph.vertices.size(), 0);
    std::uint32_t wanted = 0;
    std::map<int, PathCell> ends;
    for (const auto& [to, way] : groups[i]->second) {
      const auto end = standing_cell(graph, nodes[std::size_t(to)]);
      if (!end) continue;
      ends[to] = *end;
      ++goals[std::size_t(graph.vertex_of_cell(end->x, end->y))];
      ++wanted;
    }
    TravelSearch search(graph, graph.cost);
    search.run(std::uint32_t(graph.vertex_of_cell(start->x, start->y)), goals, wanted);
    const WayDrawer drawer(grounds[std::size_t(number)], graph);
    for (const auto& [to, end] : ends) {
      const auto vertices = travel_path(search, std::uint32_t(graph.vertex_of_cell(end.x, end.y)));
      if (!vertices.empty()) groups[i]->second.at(to) = drawer.draw(vertices, *start, end);
    }
  });
}

const NodeWay* NodeWays::get(int graph, int from, int to) const {
  const auto ways = ways_.find({graph, from});
  if (ways == ways_.end()) return nullptr;
  const auto way = ways->second.find(to);
  return way == ways->second.end() || way->second.points.empty() ? nullptr : &way->second;
}

NodeWay way_between(const FineGround& ground, const TravelGraph& graph, PathCell from, PathCell to) {
  const auto& cells = graph.vertex_of_cell;
  if (cells(from.x, from.y) < 0 || cells(to.x, to.y) < 0) return {};
  const auto goal = std::uint32_t(cells(to.x, to.y));
  std::vector<std::uint16_t> goals(graph.vertices.size(), 0);
  goals[goal] = 1;
  TravelSearch search(graph, graph.cost);
  search.run(std::uint32_t(cells(from.x, from.y)), goals, 1);
  const auto vertices = travel_path(search, goal);
  return vertices.empty() ? NodeWay{} : WayDrawer(ground, graph).draw(vertices, from, to);
}

}  // namespace biotope
