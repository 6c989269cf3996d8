#include "core/movement/trail_refiner.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"

namespace biotope {
namespace {

/// Travel edges of one search, at least and at most. Between, legs end at vertices drawn by their place, so that routes that
/// share a piece of ground share legs, whatever lies before. Our choice.
constexpr std::size_t shortest_leg = 5;
constexpr std::size_t longest_leg = 14;

double squared_distance(PathPoint point, PathCell cell) {
  const double dx = double(point.x) - cell.x;
  const double dy = double(point.y) - cell.y;
  return dx * dx + dy * dy;
}

}  // namespace

std::vector<float> blurred_weight(const std::vector<float>& weight) {
  constexpr std::size_t reach = 4;
  std::vector<float> result(weight.size());
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const std::size_t first = i > reach ? i - reach : 0;
    const std::size_t last = std::min(weight.size() - 1, i + reach);
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) sum += double(weight[k]);
    result[i] = float(sum / double(last - first + 1));
  }
  return result;
}

double length_of(std::span<const PathPoint> points, double cell_size) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += std::hypot(double(points[i + 1].x - points[i].x), double(points[i + 1].y - points[i].y)) * cell_size;
  }
  return length;
}

RouteRefiner::RouteRefiner(const Ground& ground, const PlacedGround& placed, const std::vector<WalkJob>& jobs,
                           const TrailGraph& trails, const std::vector<CoarseRoute>& routes, std::vector<RefinedRoute> pinned,
                           MovementCache* cache)
    : ground_(ground),
      placed_(placed),
      jobs_(jobs),
      trails_(trails),
      routes_(routes),
      cache_(cache),
      pinned_(pinned.size()),
      refined_(std::move(pinned)) {
  refined_.resize(routes.size());
  for (const WalkJob& job : jobs) {
    costs_.emplace_back(job.graph->mobility);
    for (const auto& [vertex, cell] : job.waypoints) {
      const TravelGraph::Vertex& place = job.graph->vertices[vertex];
      const auto found = std::find(trails.cells.begin(), trails.cells.end(), PathCell{place.x, place.y});
      if (found != trails.cells.end()) waypoints_.emplace(std::uint32_t(found - trails.cells.begin()), cell);
    }
  }
}

std::vector<RefinedRoute> RouteRefiner::run(const TaskContext& context) {
  int ranks = 0;
  for (const CoarseRoute& route : routes_) ranks = std::max(ranks, route.rank + 1);
  std::vector<std::vector<std::size_t>> by_rank(std::size_t(ranks), std::vector<std::size_t>{});
  for (std::size_t i = pinned_; i < routes_.size(); ++i) by_rank[std::size_t(routes_[i].rank)].push_back(i);
  std::vector<std::vector<Leg>> legs(routes_.size());
  if (cache_ && !jobs_.empty()) cache_->begin_paths(ground_, jobs_.front().graph->block);
  for (const auto& numbers : by_rank) {
    if (context.stopped()) break;
    parallel_each(numbers.size(), [&](std::size_t i) { refined_[numbers[i]] = refine(routes_[numbers[i]], legs[numbers[i]]); });
  }
  if (cache_) {
    for (const auto& of_route : legs) {
      for (const Leg& leg : of_route) cache_->keep_path(leg.key, leg.cells);
    }
    if (!context.stopped()) cache_->end_paths();
  }
  return std::move(refined_);
}

float RouteRefiner::wade_depth(const CoarseRoute& route) const {
  if (route.edges.empty()) return pinned_wade_depth;
  const std::uint64_t users = users_of(route.edges);
  float depth = jobs_[std::size_t(std::countr_zero(users))].graph->mobility.wade_depth;
  for (std::size_t j = 0; j < jobs_.size(); ++j) {
    if (users >> j & 1) depth = std::min(depth, jobs_[j].graph->mobility.wade_depth);
  }
  return depth;
}

std::uint64_t RouteRefiner::users_of(std::span<const std::uint32_t> edges) const {
  std::uint64_t users = 0;
  for (const std::uint32_t e : edges) users |= trails_.edges[e].users;
  return users;
}

int RouteRefiner::heaviest_of(std::span<const std::uint32_t> edges) const {
  const auto lighter = [&](std::uint32_t a, std::uint32_t b) { return trails_.edges[a].weight < trails_.edges[b].weight; };
  return trails_.edges[*std::max_element(edges.begin(), edges.end(), lighter)].heaviest;
}

FineGround RouteRefiner::ground_for(std::uint64_t users, int heaviest) const {
  std::vector<const RunMap*> regions;
  std::vector<const TravelGraph*> graphs;
  for (std::size_t j = 0; j < jobs_.size(); ++j) {
    // Species with the same obstacles share their regions.
    if (!(users >> j & 1) || std::find(regions.begin(), regions.end(), jobs_[j].region) != regions.end()) continue;
    regions.push_back(jobs_[j].region);
    graphs.push_back(jobs_[j].graph.get());
  }
  return {ground_, std::move(graphs), costs_[std::size_t(heaviest)], trail_step, &placed_};
}

/// Nearest point of the route that is joined, where the users of this one can stand.
std::optional<PathPoint> RouteRefiner::joint(int joined, std::uint32_t vertex, const FineGround& fine) const {
  if (joined < 0) return std::nullopt;
  const PathCell at = trails_.cells[vertex];
  std::optional<PathPoint> best;
  double nearest = 9.0 * jobs_.front().graph->block * jobs_.front().graph->block;
  for (const PathPoint& point : refined_[std::size_t(joined)].line.points) {
    const double distance = squared_distance(point, at);
    if (distance >= nearest || !fine.passable(point)) continue;
    nearest = distance;
    best = point;
  }
  return best;
}

/// Where a leg begins or ends that does so at a vertex.
PathCell RouteRefiner::place_of(std::uint32_t vertex) const {
  const auto waypoint = waypoints_.find(vertex);
  return waypoint == waypoints_.end() ? trails_.cells[vertex] : waypoint->second;
}

/// Vertex (position in the route) where the leg that begins at `first` ends.
std::size_t RouteRefiner::leg_end(const CoarseRoute& route, std::size_t first) const {
  std::size_t last = route.edges.size();
  for (std::size_t end = first + 1; end < std::min(last, first + longest_leg) && !waypoints_.empty(); ++end) {
    if (waypoints_.contains(route.vertices[end])) last = end;
  }
  if (last - first <= longest_leg) return last;
  for (std::size_t end = first + shortest_leg; end < first + longest_leg; ++end) {
    const PathCell cell = trails_.cells[route.vertices[end]];
    if (random_bits({std::uint64_t(cell.x), std::uint64_t(cell.y)}) % 6 == 0) return end;
  }
  return first + longest_leg;
}

std::vector<PathCell> RouteRefiner::leg_on(const FineGround& fine, int heaviest, std::span<const PathCell> over, PathCell from,
                                           PathCell to, std::vector<Leg>& legs) const {
  const Tube tube = tube_around(fine, over, from, to);
  if (!cache_) return fine_path(fine, tube, from, to);
  Leg leg{cache_->path_key(fine, tube, from, to, jobs_[std::size_t(heaviest)].graph->mobility), {}};
  const std::vector<PathCell>* known = cache_->path(leg.key);
  leg.cells = known ? *known : fine_path(fine, tube, from, to);
  legs.push_back(leg);
  return std::move(leg.cells);
}

/// Cells of one leg; first tries the ground that all its users share, then that of who walks most.
std::vector<PathCell> RouteRefiner::refine_leg(std::span<const std::uint32_t> edges, std::span<const PathCell> over,
                                               PathCell from, PathCell to, std::vector<Leg>& legs) const {
  const int heaviest = heaviest_of(edges);
  auto cells = leg_on(ground_for(users_of(edges), heaviest), heaviest, over, from, to, legs);
  if (cells.empty()) cells = leg_on(ground_for(std::uint64_t(1) << heaviest, heaviest), heaviest, over, from, to, legs);
  return cells;
}

RouteRefiner::Draft RouteRefiner::draft(const CoarseRoute& route, std::optional<PathPoint> front, std::optional<PathPoint> back,
                                        std::vector<Leg>& legs) const {
  std::vector<PathCell> over;
  for (const std::uint32_t v : route.vertices) over.push_back(trails_.cells[v]);
  Draft draft;
  for (std::size_t first = 0; first < route.edges.size();) {
    const std::size_t end = leg_end(route, first);
    const std::size_t count = end - first;
    const auto edges = std::span(route.edges).subspan(first, count);
    const PathCell from = !draft.cells.empty() ? draft.cells.back() : front ? cell_at(*front) : place_of(route.vertices.front());
    const PathCell to = end == route.edges.size() && back ? cell_at(*back) : place_of(route.vertices[end]);
    const auto leg = refine_leg(edges, std::span(over).subspan(first, count + 1), from, to, legs);
    if (leg.empty()) break;
    if (draft.marks.empty()) draft.marks.emplace_back(0, 0);
    for (std::size_t i = draft.cells.empty() ? 0 : 1; i < leg.size(); ++i) {
      draft.cells.push_back(leg[i]);
      draft.weight.push_back(float(trails_.edges[edges[std::min(count - 1, i * count / leg.size())]].weight));
    }
    draft.marks.emplace_back(draft.cells.size() - 1, end);
    first = end;
  }
  return draft;
}

RefinedRoute RouteRefiner::refine(const CoarseRoute& route, std::vector<Leg>& legs) const {
  const FineGround fine = ground_for(users_of(route.edges), heaviest_of(route.edges));
  const auto front = joint(route.joins_front, route.vertices.front(), fine);
  const auto back = joint(route.joins_back, route.vertices.back(), fine);
  const Draft drafted = draft(route, front, back, legs);
  if (drafted.cells.size() < 2) return {};
  TrailRoute line{smooth_path(fine, points_of(drafted.cells)), blurred_weight(drafted.weight)};
  if (front && drafted.cells.front() == cell_at(*front)) line.points.front() = *front;
  if (back && drafted.cells.back() == cell_at(*back)) line.points.back() = *back;
  line.length = length_of(line.points, ground_.terrain->cell_size);
  auto vertices = points_of_vertices(route, drafted, line.points);
  return {std::move(line), std::move(vertices)};
}

std::vector<std::uint32_t> RouteRefiner::points_of_vertices(const CoarseRoute& route, const Draft& draft,
                                                            const std::vector<PathPoint>& points) const {
  std::vector<std::uint32_t> result{0};
  for (std::size_t leg = 0; leg + 1 < draft.marks.size(); ++leg) {
    const auto [first_point, first_vertex] = draft.marks[leg];
    const auto [last_point, last_vertex] = draft.marks[leg + 1];
    for (std::size_t v = first_vertex + 1; v <= last_vertex; ++v) {
      std::size_t nearest = v == last_vertex ? last_point : result.back();
      for (std::size_t i = result.back(); i <= last_point && v != last_vertex; ++i) {
        const PathCell cell = trails_.cells[route.vertices[v]];
        if (squared_distance(points[i], cell) < squared_distance(points[nearest], cell)) nearest = i;
      }
      result.push_back(std::uint32_t(nearest));
    }
  }
  return result;
}

}  // namespace biotope
