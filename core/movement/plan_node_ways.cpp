#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/movement/plan_parts.hpp"
#include "core/movement/trail_ways.hpp"
#include "core/movement/travel_search.hpp"

namespace biotope {
namespace {

/// Places a straight line may skip, and by how much it may cost more than going by them. Our choice.
constexpr std::size_t most_skipped = 6;
constexpr double skipping_cost = 1.02;

/// Points of a trail next to where a way joins or leaves it that may be rounded.
constexpr std::size_t loose_ends = 2;

PathPoint point_of(PathCell cell) { return {float(cell.x), float(cell.y)}; }

PathCell place_of(const TravelGraph& graph, std::uint32_t vertex) { return {graph.vertices[vertex].x, graph.vertices[vertex].y}; }

double squared_distance(PathPoint a, PathPoint b) {
  return double(a.x - b.x) * double(a.x - b.x) + double(a.y - b.y) * double(a.y - b.y);
}

/// Points of one trail, first to last in the direction of walking.
struct OnTrail {
  std::size_t first_edge = 0;  ///< position in the coarse way
  std::size_t last_edge = 0;   ///< the edge after the last
  const std::vector<PathPoint>* points = nullptr;
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// Draws ways over a travel graph on the fine ground: along trails where there are any, else straight from place to place, past
/// places where that costs no more, and around obstacles.
class WayDrawer {
 public:
  /// `mends`: a trail that cannot be reached closely is left out, before all of the way is searched.
  WayDrawer(const FineGround& ground, const TravelGraph& graph, const TrailNetwork* trails, bool mends = false)
      : ground_(ground), graph_(graph), trails_(trails), mends_(mends) {}

  [[nodiscard]] NodeWay draw(std::span<const std::uint32_t> vertices, PathCell from, PathCell to) {
    std::vector<OnTrail> trails = trails_along(vertices, from, to);
    while (const auto gap = go(vertices, trails, from, to)) {
      if (!mends_ || *gap >= trails.size()) return whole(vertices, from, to);
      trails.erase(trails.begin() + std::ptrdiff_t(*gap));
    }
    round_path(ground_, fixed_, points_);
    return costed(std::move(points_));
  }

 private:
  /// Goes by trails and places. Where two places do not connect closely: the number of the trail that one of them lies on, or how
  /// many there are when neither does.
  [[nodiscard]] std::optional<std::size_t> go(std::span<const std::uint32_t> vertices, std::span<const OnTrail> trails,
                                              PathCell from, PathCell to) {
    points_.assign(1, point_of(from));
    fixed_.assign(1, 0);
    std::vector<PathPoint> places{point_of(from)};
    std::size_t edge = 0;
    for (std::size_t i = 0; i <= trails.size(); ++i) {
      const bool last = i == trails.size();
      const std::size_t until = last ? vertices.size() - 1 : trails[i].first_edge;
      for (std::size_t v = std::max<std::size_t>(edge, 1); v < until; ++v)
        places.push_back(point_of(place_of(graph_, vertices[v])));
      places.push_back(last ? point_of(to) : (*trails[i].points)[std::size_t(trails[i].first)]);
      const std::size_t reached = append_places(places);
      if (reached + 1 < places.size()) return reached == 0 && i > 0 ? i - 1 : reached + 2 == places.size() ? i : trails.size();
      if (last) return std::nullopt;
      append_trail(trails[i]);
      places.assign(1, points_.back());
      edge = trails[i].last_edge + 1;
    }
    return std::nullopt;
  }

  /// Runs of edges that follow one trail, in order, where the mobility can walk all of it.
  [[nodiscard]] std::vector<OnTrail> trails_along(std::span<const std::uint32_t> vertices, PathCell from, PathCell to) const {
    std::vector<OnTrail> runs;
    if (!trails_ || !trails_->ways) return runs;
    const auto cell = [&](std::uint32_t v) {
      return std::uint32_t(graph_.vertices[v].y) * std::uint32_t(graph_.vertex_of_cell.width()) +
             std::uint32_t(graph_.vertices[v].x);
    };
    for (std::size_t e = 0; e + 1 < vertices.size(); ++e) {
      const std::uint32_t a = cell(vertices[e]);
      const std::uint32_t b = cell(vertices[e + 1]);
      const auto found = trails_->ways->stretches.find(TrailWays::key(std::min(a, b), std::max(a, b)));
      if (found == trails_->ways->stretches.end()) continue;
      TrailWays::Stretch stretch = found->second;
      if (b < a) std::swap(stretch.first, stretch.last);
      OnTrail run{e, e + 1, &trails_->routes[stretch.route].points, stretch.first, stretch.last};
      if (!walkable(run)) continue;
      if (!runs.empty() && runs.back().last_edge == e && runs.back().points == run.points && runs.back().last == run.first) {
        runs.back().last_edge = e + 1;
        runs.back().last = run.last;
      } else {
        runs.push_back(run);
      }
    }
    if (!runs.empty() && runs.front().first_edge == 0) runs.front().first = nearest(runs.front(), point_of(from));
    if (!runs.empty() && runs.back().last_edge + 1 == vertices.size()) runs.back().last = nearest(runs.back(), point_of(to));
    return runs;
  }

  [[nodiscard]] bool walkable(const OnTrail& run) const {
    const auto& points = *run.points;
    for (std::int64_t i = std::min(run.first, run.last); i < std::max(run.first, run.last); ++i) {
      if (!ground_.clear(points[std::size_t(i)], points[std::size_t(i) + 1])) return false;
    }
    return ground_.passable(points[std::size_t(run.first)]);
  }

  /// Point of a run nearest to another point.
  static std::int64_t nearest(const OnTrail& run, PathPoint to) {
    const std::int64_t step = run.last >= run.first ? 1 : -1;
    std::int64_t best = run.first;
    for (std::int64_t i = run.first; i != run.last + step; i += step) {
      if (squared_distance((*run.points)[std::size_t(i)], to) < squared_distance((*run.points)[std::size_t(best)], to)) best = i;
    }
    return best;
  }

  void append(PathPoint point, bool fixed) {
    if (point.x == points_.back().x && point.y == points_.back().y) return;
    points_.push_back(point);
    fixed_.push_back(fixed);
  }

  void append_trail(const OnTrail& trail) {
    const std::int64_t step = trail.last >= trail.first ? 1 : -1;
    const auto count = std::size_t((trail.last - trail.first) * step) + 1;
    for (std::size_t i = 0; i < count; ++i) {
      append((*trail.points)[std::size_t(trail.first + std::int64_t(i) * step)], i >= loose_ends && i + loose_ends < count);
    }
  }

  /// Goes by places from where the way has come to; the number of the last one, or of the first that does not connect closely
  /// with the next.
  std::size_t append_places(const std::vector<PathPoint>& places) {
    std::size_t at = 0;
    while (at + 1 < places.size()) {
      const std::size_t next = farthest(places, at);
      if (next > at) {
        append_line(places[at], places[next]);
        at = next;
        continue;
      }
      const std::array over{cell_at(places[at]), cell_at(places[at + 1])};
      const auto around = fine_path(ground_, over, over[0], over[1]);
      if (around.empty()) return at;
      for (const PathCell& cell : around) append(point_of(cell), false);
      append(places[at + 1], false);
      ++at;
    }
    return at;
  }

  /// Place that a straight line reaches from place `at`; `at` itself when not even the next one.
  [[nodiscard]] std::size_t farthest(const std::vector<PathPoint>& places, std::size_t at) const {
    const PathPoint start = places[at];
    std::size_t reached = at;
    double by_places = 0;
    for (std::size_t next = at + 1; next < std::min(places.size(), at + 1 + most_skipped); ++next) {
      const PathPoint end = places[next];
      if (!ground_.allows(start, end)) break;
      by_places += ground_.walk_along(places[next - 1], end);
      if (next > at + 1 && ground_.walk_along(start, end) > by_places * skipping_cost) break;
      reached = next;
    }
    return reached;
  }

  void append_line(PathPoint a, PathPoint b) {
    const int pieces = std::max(1, int(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y))) / ground_.stride());
    for (int i = 1; i <= pieces; ++i) {
      const float t = float(i) / float(pieces);
      append(i == pieces ? b : PathPoint{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}, false);
    }
  }

  /// Where two places do not connect closely: a search along the whole way.
  [[nodiscard]] NodeWay whole(std::span<const std::uint32_t> vertices, PathCell from, PathCell to) const {
    std::vector<PathCell> places{from};
    for (const std::uint32_t v : vertices) places.push_back(place_of(graph_, v));
    const auto cells = fine_path(ground_, places, from, to);
    return cells.empty() ? NodeWay{} : costed(smooth_path(ground_, points_of(cells)));
  }

  [[nodiscard]] NodeWay costed(std::vector<PathPoint> points) const {
    NodeWay way{std::move(points), {0}};
    way.cost.reserve(way.points.size());
    for (std::size_t i = 1; i < way.points.size(); ++i) {
      way.cost.push_back(way.cost.back() + ground_.walk_between(way.points[i - 1], way.points[i]));
    }
    return way;
  }

  const FineGround& ground_;
  const TravelGraph& graph_;
  const TrailNetwork* trails_;
  bool mends_;
  std::vector<PathPoint> points_;
  std::vector<std::uint8_t> fixed_;
};

}  // namespace

std::span<const float> way_costs(const PlanInput& input, int graph) {
  const LevelTravel& travel = *input.movement.travel;
  const TravelGraph* own = travel.graphs[std::size_t(graph)].get();
  const TrailWays::WornGraph* worn = input.trails && input.trails->ways ? input.trails->ways->find(own) : nullptr;
  return worn ? std::span<const float>(worn->cost) : travel.cost(std::size_t(graph));
}

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
  return {input.ground,
          {travel.graphs[std::size_t(graph)].get()},
          WalkCost(travel.graphs[std::size_t(graph)]->mobility),
          plan_step,
          &input.placed};
}

void NodeWays::need(int graph, int from, int to) { ways_[{graph, from}].try_emplace(to); }

void NodeWays::find() {
  std::vector<FineGround> grounds;
  for (std::size_t g = 0; g < input_.movement.travel->graphs.size(); ++g) grounds.push_back(fine_ground(input_, int(g)));
  std::vector<std::pair<const std::pair<int, int>, std::map<int, NodeWay>>*> groups;
  for (auto& group : ways_) groups.push_back(&group);
  // A search is made ready once for several groups of one graph.
  constexpr std::size_t together = 8;
  std::vector<std::pair<std::size_t, std::size_t>> batches;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const bool more = !batches.empty() && i - batches.back().first < together &&
                      groups[batches.back().first]->first.first == groups[i]->first.first;
    if (!more) batches.emplace_back(i, i);
    batches.back().second = i + 1;
  }
  parallel_each(batches.size(), [&](std::size_t batch) {
    const int number = groups[batches[batch].first]->first.first;
    TravelSearch search(*input_.movement.travel->graphs[std::size_t(number)], way_costs(input_, number));
    for (std::size_t i = batches[batch].first; i < batches[batch].second; ++i)
      find_from(groups[i]->first.second, grounds[std::size_t(number)], number, search, groups[i]->second);
  });
}

void NodeWays::find_from(int from, const FineGround& ground, int number, TravelSearch& search,
                         std::map<int, NodeWay>& found) const {
  const TravelGraph& graph = *input_.movement.travel->graphs[std::size_t(number)];
  const auto& nodes = input_.level.graph->nodes;
  const auto start = standing_cell(graph, nodes[std::size_t(from)]);
  if (!start) return;
  std::vector<std::uint16_t> goals(graph.vertices.size(), 0);
  std::uint32_t wanted = 0;
  std::map<int, PathCell> ends;
  for (const auto& [to, way] : found) {
    const auto end = standing_cell(graph, nodes[std::size_t(to)]);
    if (!end) continue;
    ends[to] = *end;
    ++goals[std::size_t(graph.vertex_of_cell(end->x, end->y))];
    ++wanted;
  }
  search.run(std::uint32_t(graph.vertex_of_cell(start->x, start->y)), goals, wanted);
  WayDrawer drawer(ground, graph, input_.trails);
  for (const auto& [to, end] : ends) {
    const auto vertices = travel_path(search, std::uint32_t(graph.vertex_of_cell(end.x, end.y)));
    if (!vertices.empty()) found.at(to) = drawer.draw(vertices, *start, end);
  }
}

const NodeWay* NodeWays::get(int graph, int from, int to) const {
  const auto ways = ways_.find({graph, from});
  if (ways == ways_.end()) return nullptr;
  const auto way = ways->second.find(to);
  return way == ways->second.end() || way->second.points.empty() ? nullptr : &way->second;
}

NodeWay way_between(const PlanInput& input, int number, const FineGround& ground, PathCell from, PathCell to) {
  const TravelGraph& graph = *input.movement.travel->graphs[std::size_t(number)];
  const auto& cells = graph.vertex_of_cell;
  if (cells(from.x, from.y) < 0 || cells(to.x, to.y) < 0) return {};
  const auto goal = std::uint32_t(cells(to.x, to.y));
  std::vector<std::uint16_t> goals(graph.vertices.size(), 0);
  goals[goal] = 1;
  TravelSearch search(graph, way_costs(input, number));
  search.run(std::uint32_t(cells(from.x, from.y)), goals, 1);
  const auto vertices = travel_path(search, goal);
  return vertices.empty() ? NodeWay{} : way_over(input, number, ground, vertices, from, to);
}

NodeWay way_over(const PlanInput& input, int number, const FineGround& ground, std::span<const std::uint32_t> vertices,
                 PathCell from, PathCell to) {
  const TravelGraph& graph = *input.movement.travel->graphs[std::size_t(number)];
  return WayDrawer(ground, graph, input.trails, true).draw(vertices, from, to);
}

}  // namespace biotope
