#include "core/movement/trail_routes.hpp"

#include <algorithm>
#include <numeric>

namespace biotope {
namespace {

/// Share of weight x length the routes cover: the 2021 authors' code.
constexpr double covered_share = 0.99;
/// A route does not go on over segments with less than this of its heaviest: those start routes of their own. Our choice.
constexpr double faint_extension = 0.02;

/// One graph's walk over a pair of cells.
struct Walk {
  std::uint64_t a = 0;
  std::uint64_t b = 0;
  int graph = 0;
  double weight = 0;
};

std::vector<Walk> list_walks(std::span<const WalkedGraph> walked) {
  std::vector<Walk> walks;
  for (std::size_t g = 0; g < walked.size(); ++g) {
    const TravelGraph& graph = *walked[g].graph;
    const auto key = [&](std::uint32_t v) {
      return std::uint64_t(graph.vertices[v].y) * std::uint64_t(graph.vertex_of_cell.width()) +
             std::uint64_t(graph.vertices[v].x);
    };
    for (std::uint32_t v = 0; v < graph.vertices.size(); ++v) {
      for (std::uint32_t slot = graph.first_edge[v]; slot < graph.first_edge[v + 1]; ++slot) {
        const double weight = walked[g].weight[graph.edge[slot]];
        if (weight <= 0 || graph.target[slot] < v) continue;
        const std::uint64_t a = key(v);
        const std::uint64_t b = key(graph.target[slot]);
        walks.push_back({std::min(a, b), std::max(a, b), int(g), weight});
      }
    }
  }
  std::sort(walks.begin(), walks.end(), [](const Walk& p, const Walk& q) {
    if (p.a != q.a) return p.a < q.a;
    return p.b != q.b ? p.b < q.b : p.graph < q.graph;
  });
  return walks;
}

void index_incident(TrailGraph& trails) {
  auto& first = trails.first_incident;
  first.assign(trails.cells.size() + 1, 0);
  for (const auto& edge : trails.edges) {
    ++first[edge.a + 1];
    ++first[edge.b + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  trails.incident.resize(first.back());
  for (std::uint32_t e = 0; e < trails.edges.size(); ++e) {
    trails.incident[next[trails.edges[e].a]++] = e;
    trails.incident[next[trails.edges[e].b]++] = e;
  }
  for (std::size_t v = 0; v < trails.cells.size(); ++v) {
    std::sort(trails.incident.begin() + first[v], trails.incident.begin() + first[v + 1], [&](std::uint32_t p, std::uint32_t q) {
      return trails.edges[p].weight != trails.edges[q].weight ? trails.edges[p].weight > trails.edges[q].weight : p < q;
    });
  }
}

/// Takes routes out of a trail graph one after the other.
class RouteExtractor {
 public:
  RouteExtractor(const TrailGraph& trails, std::size_t pinned)
      : trails_(trails),
        used_(trails.edges.size(), 0),
        owner_(trails.cells.size(), -1),
        visitor_(trails.cells.size(), -1),
        routes_(pinned) {
    for (std::size_t e = 0; e < trails.edges.size(); ++e) {
      const auto& edge = trails.edges[e];
      if (edge.pinned < 0) continue;
      used_[e] = 1;
      covered_ += edge.weight * edge.length;
      for (const std::uint32_t v : {edge.a, edge.b}) owner_[v] = owner_[v] < 0 ? edge.pinned : std::min(owner_[v], edge.pinned);
    }
  }

  std::vector<CoarseRoute> run(std::size_t most) {
    std::vector<std::uint32_t> order(trails_.edges.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t p, std::uint32_t q) { return trails_.edges[p].weight > trails_.edges[q].weight; });
    double total = 0;
    for (const auto& edge : trails_.edges) total += edge.weight * edge.length;
    const std::size_t pinned = routes_.size();
    for (const std::uint32_t seed : order) {
      if (covered_ >= covered_share * total || routes_.size() - pinned >= most) break;
      if (used_[seed]) continue;
      covered_ += take(seed);
    }
    return std::move(routes_);
  }

 private:
  /// Makes the route through an edge; returns its weight x length.
  double take(std::uint32_t seed) {
    const int number = int(routes_.size());
    CoarseRoute route{{trails_.edges[seed].a, trails_.edges[seed].b}, {seed}, -1, -1, 0};
    used_[seed] = 1;
    for (const std::uint32_t v : route.vertices) visitor_[v] = number;
    extend(route, number);
    std::reverse(route.vertices.begin(), route.vertices.end());
    std::reverse(route.edges.begin(), route.edges.end());
    extend(route, number);
    route.joins_front = owner_[route.vertices.front()];
    route.joins_back = owner_[route.vertices.back()];
    for (const int joined : {route.joins_front, route.joins_back}) {
      if (joined >= 0) route.rank = std::max(route.rank, routes_[std::size_t(joined)].rank + 1);
    }
    for (const std::uint32_t v : route.vertices) {
      if (owner_[v] < 0) owner_[v] = number;
    }
    double covered = 0;
    for (const std::uint32_t e : route.edges) covered += trails_.edges[e].weight * trails_.edges[e].length;
    routes_.push_back(std::move(route));
    return covered;
  }

  /// Goes on from the back until another route, a dead end or only faint segments.
  void extend(CoarseRoute& route, int number) {
    double heaviest = 0;
    for (const std::uint32_t e : route.edges) heaviest = std::max(heaviest, trails_.edges[e].weight);
    while (owner_[route.vertices.back()] < 0) {
      const std::uint32_t at = route.vertices.back();
      const std::uint32_t before = route.vertices[route.vertices.size() - 2];
      bool found = false;
      for (std::uint32_t i = trails_.first_incident[at]; i < trails_.first_incident[at + 1] && !found; ++i) {
        const std::uint32_t e = trails_.incident[i];
        const auto& edge = trails_.edges[e];
        const std::uint32_t next = edge.a == at ? edge.b : edge.a;
        if (used_[e] || visitor_[next] == number || edge.weight < faint_extension * heaviest || turns_back(before, at, next))
          continue;
        used_[e] = 1;
        visitor_[next] = number;
        route.vertices.push_back(next);
        route.edges.push_back(e);
        found = true;
      }
      if (!found) break;
    }
  }

  /// Sharper than a right angle: animals came from elsewhere and go elsewhere.
  [[nodiscard]] bool turns_back(std::uint32_t before, std::uint32_t at, std::uint32_t next) const {
    const PathCell a = trails_.cells[before];
    const PathCell b = trails_.cells[at];
    const PathCell c = trails_.cells[next];
    return (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0;
  }

  const TrailGraph& trails_;
  std::vector<std::uint8_t> used_;
  /// First route through a vertex, and the route that visited it last.
  std::vector<int> owner_;
  std::vector<int> visitor_;
  std::vector<CoarseRoute> routes_;
  /// Weight x length.
  double covered_ = 0;
};

}  // namespace

TrailGraph merge_walks(std::span<const WalkedGraph> walked) {
  assert(walked.size() <= 64);
  TrailGraph trails;
  if (walked.empty()) return trails;
  const std::vector<Walk> walks = list_walks(walked);
  std::vector<std::uint64_t> keys;
  for (const Walk& walk : walks) {
    keys.push_back(walk.a);
    keys.push_back(walk.b);
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  const auto width = std::uint64_t(walked.front().graph->vertex_of_cell.width());
  for (const std::uint64_t key : keys) trails.cells.push_back({int(key % width), int(key / width)});
  const auto vertex = [&](std::uint64_t key) {
    return std::uint32_t(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
  };
  for (std::size_t i = 0; i < walks.size();) {
    TrailGraph::Edge edge{vertex(walks[i].a), vertex(walks[i].b), 0, 0, 0, walks[i].graph, -1};
    const PathCell a = trails.cells[edge.a];
    const PathCell b = trails.cells[edge.b];
    edge.length = std::hypot(double(a.x - b.x), double(a.y - b.y));
    double most = 0;
    std::size_t j = i;
    for (; j < walks.size() && walks[j].a == walks[i].a && walks[j].b == walks[i].b; ++j) {
      edge.weight += walks[j].weight;
      edge.users |= std::uint64_t(1) << walks[j].graph;
      if (walks[j].weight > most) {
        most = walks[j].weight;
        edge.heaviest = walks[j].graph;
      }
    }
    trails.edges.push_back(edge);
    i = j;
  }
  index_incident(trails);
  return trails;
}

std::vector<CoarseRoute> extract_routes(const TrailGraph& trails, std::size_t most, std::size_t pinned) {
  return RouteExtractor(trails, pinned).run(most);
}

}  // namespace biotope
