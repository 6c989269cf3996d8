#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/parallel.hpp"
#include "core/movement/travel_search.hpp"
#include "core/movement/walkers.hpp"

namespace biotope {
namespace {

/// Walks between resources on a day: stays of about two hours (90 to 150 minutes, 2021 authors) in an active day of 16 h.
constexpr double walks_per_day = 8;
/// A share of onward walks below this leaves no trail; not followed. Our choice.
constexpr double faint_share = 1e-4;

void add_stay(Walkers& walkers, const std::vector<std::int32_t>& vertices, int node, double probability) {
  const std::int32_t vertex = vertices[std::size_t(node)];
  if (vertex >= 0 && probability > 0) walkers.stays.push_back({std::uint32_t(vertex), float(probability)});
}

/// Where the prey of a node is: its own resources, by its presence there.
class PreyStays {
 public:
  PreyStays(const AnimalLevel& below, const LevelTravel& travel_below, const TravelGraph& graph)
      : below_(below), travel_below_(travel_below), graph_(graph) {}

  void add(const ResourceNode& prey, double probability, const std::vector<std::int32_t>& own, int own_node, Walkers& walkers) const {
    const auto found = std::find(below_.species.begin(), below_.species.end(), prey.group);
    std::vector<Walkers::Stay> stays;
    double sum = 0;
    if (found != below_.species.end() && prey.prey_region >= 0) {
      const auto& regions = travel_below_.presence[std::size_t(found - below_.species.begin())];
      for (const auto& [node, p] : regions[std::size_t(prey.prey_region)]) {
        const ResourceNode& place = below_.graph->nodes[std::size_t(node)];
        const std::int32_t vertex = graph_.vertex_of_cell(place.x, place.y);
        if (vertex < 0 || graph_.vertices[std::size_t(vertex)].region != own_region(own, own_node)) continue;
        stays.push_back({std::uint32_t(vertex), p});
        sum += double(p);
      }
    }
    if (stays.empty()) add_stay(walkers, own, own_node, probability);
    for (const auto& stay : stays) walkers.stays.push_back({stay.vertex, float(probability * double(stay.probability) / sum)});
  }

 private:
  [[nodiscard]] int own_region(const std::vector<std::int32_t>& own, int node) const {
    const std::int32_t vertex = own[std::size_t(node)];
    return vertex < 0 ? -1 : graph_.vertices[std::size_t(vertex)].region;
  }

  const AnimalLevel& below_;
  const LevelTravel& travel_below_;
  const TravelGraph& graph_;
};

/// Level (index) a species belongs to, among those below; -1 when it is none of them.
int level_of(std::span<const std::shared_ptr<const AnimalLevel>> levels, std::size_t below, int species) {
  for (std::size_t i = 0; i < below; ++i) {
    const auto& numbers = levels[i]->species;
    if (std::find(numbers.begin(), numbers.end(), species) != numbers.end()) return int(i);
  }
  return -1;
}

/// Sums walks of all walkers from one source over the edges of a search's tree, each edge once.
class TreeSum {
 public:
  TreeSum(const TravelGraph& graph, const TravelSearch& search)
      : graph_(graph), search_(search), carried_(graph.vertices.size(), 0.0), children_(graph.vertices.size(), 0), seen_(graph.vertices.size(), 0) {}

  /// What one species carries away from `source` (eqs. 2 and 3) to each of its stays.
  void carry(std::uint32_t source, const Walkers& walkers, double times) {
    onward_.clear();
    double all = 0;
    for (const auto& stay : walkers.stays) {
      const float cost = search_.cost(stay.vertex);
      onward_.push_back(std::isfinite(cost) ? double(stay.probability) / double(std::max(cost / walkers.speed, shortest_walk)) : 0.0);
      all += onward_.back();
    }
    double leaving = 0;
    for (const auto& stay : walkers.stays) {
      const double others = all - double(stay.probability) / double(shortest_walk);
      if (stay.vertex == source && others > all * 1e-9) leaving += double(stay.probability) / others;
    }
    for (std::size_t i = 0; i < onward_.size(); ++i) {
      const std::uint32_t to = walkers.stays[i].vertex;
      if (to != source && onward_[i] >= faint_share * all) reach(to, times * walkers.yearly * leaving * onward_[i]);
    }
  }

  /// Adds what was carried to the edges' weights, from the leaves of the tree to its root, and forgets it.
  void add_to(std::vector<double>& weight) {
    for (const std::uint32_t leaf : seen_list_) {
      for (std::uint32_t v = leaf; children_[v] == 0 && seen_[v] && search_.parent(v) >= 0;) {
        const auto parent = std::uint32_t(search_.parent(v));
        weight[graph_.edge[search_.parent_slot(v)]] += carried_[v];
        carried_[parent] += carried_[v];
        seen_[v] = 0;
        v = parent;
        --children_[v];
      }
    }
    for (const std::uint32_t v : seen_list_) {
      carried_[v] = 0;
      children_[v] = 0;
      seen_[v] = 0;
    }
    seen_list_.clear();
  }

 private:
  /// Notes the way to a vertex up to where it meets ways noted before.
  void reach(std::uint32_t vertex, double amount) {
    carried_[vertex] += amount;
    while (!seen_[vertex]) {
      seen_[vertex] = 1;
      seen_list_.push_back(vertex);
      if (search_.parent(vertex) < 0) break;
      vertex = std::uint32_t(search_.parent(vertex));
      ++children_[vertex];
    }
  }

  const TravelGraph& graph_;
  const TravelSearch& search_;
  std::vector<double> onward_;
  std::vector<double> carried_;
  std::vector<std::uint16_t> children_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> seen_list_;
};

}  // namespace

std::vector<Walkers> walkers_of_graph(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                      std::span<const LevelMovement> movement, std::size_t level, std::size_t graph) {
  const AnimalLevel& animals = *levels[level];
  const LevelTravel& travel = *movement[level].travel;
  const auto& vertices = travel.vertex_of_node[graph];
  std::vector<Walkers> result;
  for (std::size_t s = 0; s < animals.species.size(); ++s) {
    if (travel.graph_of_species[s] != int(graph)) continue;
    const AnimalTraits& animal = web.species[std::size_t(animals.species[s])].animal();
    for (std::size_t region = 0; region < travel.presence[s].size(); ++region) {
      if (travel.presence[s][region].empty()) continue;
      Walkers walkers;
      walkers.yearly = animals.population[s][region] * double(animal.mean_mass()) * walks_per_day * 365;
      walkers.speed = animal.speed;
      for (const auto& [node, probability] : travel.presence[s][region]) {
        const ResourceNode& place = animals.graph->nodes[std::size_t(node)];
        const int below = place.kind == NodeKind::prey ? level_of(levels, level, place.group) : -1;
        if (below < 0) {
          add_stay(walkers, vertices, node, double(probability));
        } else {
          PreyStays(*levels[std::size_t(below)], *movement[std::size_t(below)].travel, *travel.graphs[graph])
              .add(place, double(probability), vertices, node, walkers);
        }
      }
      result.push_back(std::move(walkers));
    }
  }
  return result;
}

std::vector<WalkSource> walk_sources(std::span<const Walkers> walkers) {
  std::map<std::uint32_t, WalkSource> by_vertex;
  for (std::size_t i = 0; i < walkers.size(); ++i) {
    for (const auto& stay : walkers[i].stays) {
      WalkSource& source = by_vertex[stay.vertex];
      source.vertex = stay.vertex;
      source.yearly += walkers[i].yearly * double(stay.probability);
      if (source.walkers.empty() || source.walkers.back() != i) source.walkers.push_back(i);
    }
  }
  std::vector<WalkSource> sources;
  for (auto& [vertex, source] : by_vertex) sources.push_back(std::move(source));
  return sources;
}

/// One of the sums that run side by side.
struct WalkSum::Part {
  Part(const TravelGraph& graph, std::span<const float> cost) : search(graph, cost), tree(graph, search), weight(graph.edge_count, 0.0) {}

  TravelSearch search;
  TreeSum tree;
  std::vector<double> weight;
};

WalkSum::WalkSum(const TravelGraph& graph, std::span<const float> cost, std::span<const Walkers> walkers, std::span<const std::uint16_t> stays)
    : graph_(graph), cost_(cost), walkers_(walkers), stays_(stays) {}
WalkSum::~WalkSum() = default;

void WalkSum::add(std::span<const WalkSource> sources) {
  // A number of sums that depends on the sources only, added in order: the result does not depend on threads.
  constexpr std::size_t most_parts = 8;
  const std::size_t count = std::min(sources.size(), most_parts);
  parts_.resize(std::max(parts_.size(), count));
  parallel_each(count, [&](std::size_t number) {
    auto& part = parts_[number];
    if (!part) part = std::make_unique<Part>(graph_, cost_);
    for (std::size_t i = number; i < sources.size(); i += count) {
      part->search.run(sources[i].vertex, stays_, searched_nodes);
      for (const std::size_t w : sources[i].walkers) part->tree.carry(sources[i].vertex, walkers_[w], sources[i].stands_for);
      part->tree.add_to(part->weight);
    }
  });
}

std::vector<double> WalkSum::weight() const {
  std::vector<double> sum(graph_.edge_count, 0.0);
  for (const auto& part : parts_) {
    for (std::size_t e = 0; e < sum.size(); ++e) sum[e] += part->weight[e];
  }
  return sum;
}

void WalkSum::clear() {
  for (const auto& part : parts_) std::fill(part->weight.begin(), part->weight.end(), 0.0);
}

}  // namespace biotope
