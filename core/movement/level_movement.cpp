#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/movement/movement_cache.hpp"
#include "core/movement/plan_parts.hpp"
#include "core/movement/trails.hpp"
#include "core/movement/travel_search.hpp"
#include "core/movement/walkers.hpp"

namespace biotope {
namespace {

/// Onward edges kept a node and species, and among them banks, so that a herd always finds its way to water. Our choice.
constexpr std::size_t kept_edges = 14;
constexpr std::size_t kept_banks = 2;
/// A search for edges ends once this many resources are reached. Our choice: a few times what is kept.
constexpr std::uint32_t searched_for_edges = 40;
/// Longer walks are no edges, s. Our choice.
constexpr float longest_walk = 3 * 3600;

/// One species in one region, ready to walk.
struct Party {
  int species_index = 0;
  const std::vector<LevelTravel::Presence>* presence = nullptr;
};

constexpr float unreached = std::numeric_limits<float>::infinity();

struct Onward {
  SpatialEdge edge;
  float probability = 0;
};

void find_graphs(const FoodWeb& web, const AnimalLevel& level, const Ground& ground, MovementCache* cache, LevelTravel& travel) {
  std::vector<std::size_t> first_species;
  std::vector<Mobility> mobilities;
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    const Mobility mobility = mobility_of(web.species[std::size_t(level.species[i])].animal());
    const auto known = std::find(mobilities.begin(), mobilities.end(), mobility);
    travel.graph_of_species.push_back(int(known - mobilities.begin()));
    if (known != mobilities.end()) continue;
    mobilities.push_back(mobility);
    first_species.push_back(i);
  }
  const int block = travel_block(ground.terrain->height.width(), ground.terrain->height.height());
  travel.graphs.resize(mobilities.size());
  travel.vertex_of_node.resize(mobilities.size());
  const PlacedGround placed(ground);
  MovementCache own;
  MovementCache& graphs = cache ? *cache : own;
  for (std::size_t i = 0; i < mobilities.size(); ++i) {
    auto graph = graphs.graph(ground, level.regions[first_species[i]], mobilities[i], block);
    for (const ResourceNode& node : level.graph->nodes) {
      const auto cell = standing_cell(*graph, node);
      travel.vertex_of_node[i].push_back(cell ? graph->vertex_of_cell(cell->x, cell->y) : -1);
    }
    travel.placed_cost.push_back(placed_costs(ground, *graph, placed));
    travel.graphs[i] = std::move(graph);
  }
  graphs.end_graphs(travel.graphs, level.level);
}

/// Keeps the most probable onward edges, and the most probable banks among them.
void keep_best(const std::vector<ResourceNode>& nodes, std::vector<Onward>& onward) {
  const auto likelier = [](const Onward& a, const Onward& b) {
    return a.probability != b.probability ? a.probability > b.probability : a.edge.to < b.edge.to;
  };
  std::sort(onward.begin(), onward.end(), likelier);
  std::vector<Onward> kept;
  std::size_t banks = 0;
  for (const Onward& candidate : onward) {
    const bool bank = nodes[std::size_t(candidate.edge.to)].kind == NodeKind::bank;
    if (kept.size() < kept_edges || (bank && banks < kept_banks)) {
      kept.push_back(candidate);
      banks += bank;
    }
  }
  std::sort(kept.begin(), kept.end(), [](const Onward& a, const Onward& b) { return a.edge.to < b.edge.to; });
  onward = std::move(kept);
}

/// Edges of one species out of `from` (paper eq. 2); `cost_of_node` is infinite where the search from it did not come.
std::vector<Onward> onward_edges(const AnimalLevel& level, const Party& party, const std::vector<std::int32_t>& vertex_of_node,
                                 const std::vector<float>& cost_of_node, int from, float speed, double cell_size) {
  const auto& nodes = level.graph->nodes;
  std::vector<Onward> onward;
  double sum = 0;
  for (const auto& [node, probability] : *party.presence) {
    const std::int32_t vertex = vertex_of_node[std::size_t(node)];
    const float cost = cost_of_node[std::size_t(node)];
    if (node == from || cost == unreached) continue;
    const ResourceNode& a = nodes[std::size_t(from)];
    const ResourceNode& b = nodes[std::size_t(node)];
    const double beeline = std::hypot(double(a.x - b.x), double(a.y - b.y)) * cell_size;
    // Nodes in one block have no way between vertices; the straight line stands for it.
    const float seconds = std::max(
        float(std::max(double(cost), vertex == vertex_of_node[std::size_t(from)] ? beeline : 0.0)) / speed, shortest_walk);
    sum += double(probability) / double(seconds);
    onward.push_back(
        {{from, node, level.species[std::size_t(party.species_index)], seconds}, float(double(probability) / double(seconds))});
  }
  for (Onward& candidate : onward) candidate.probability = float(double(candidate.probability) / sum);
  std::erase_if(onward, [](const Onward& candidate) { return candidate.edge.seconds > longest_walk; });
  keep_best(nodes, onward);
  return onward;
}

/// Finds the edges out of every node of one graph's species.
class EdgeFinder {
 public:
  EdgeFinder(const FoodWeb& web, const AnimalLevel& level, const LevelTravel& travel, std::size_t graph, double cell_size)
      : web_(web),
        level_(level),
        graph_(*travel.graphs[graph]),
        cost_(travel.cost(graph)),
        vertices_(travel.vertex_of_node[graph]),
        cell_size_(cell_size) {
    wanted_.assign(vertices_.size(), 0);
    for (std::size_t s = 0; s < level.species.size(); ++s) {
      if (travel.graph_of_species[s] != int(graph)) continue;
      for (const auto& presence : travel.presence[s]) {
        if (presence.empty()) continue;
        parties_.push_back({int(s), &presence});
        for (const auto& [node, probability] : presence) wanted_[std::size_t(node)] = vertices_[std::size_t(node)] >= 0;
      }
    }
    counts_.assign(graph_.vertices.size(), 0);
    for (std::size_t node = 0; node < vertices_.size(); ++node) {
      if (vertices_[node] >= 0) ++counts_[std::size_t(vertices_[node])];
    }
  }

  void run(MovementCache* cache, std::vector<Onward>& out) const {
    const std::size_t nodes = vertices_.size();
    const ReachedNodes* known = cache ? cache->reached(graph_, cost_, vertices_) : nullptr;
    ReachedNodes reached = known ? *known : ReachedNodes(nodes);
    std::vector<std::vector<Onward>> found(nodes);
    constexpr std::size_t chunk = 32;
    parallel_each((nodes + chunk - 1) / chunk, [&](std::size_t i) {
      std::optional<TravelSearch> search;
      std::vector<float> cost(nodes, unreached);
      for (std::size_t node = i * chunk; node < std::min(nodes, (i + 1) * chunk); ++node) {
        if (!wanted_[node]) continue;
        if (reached[node].empty()) {
          if (!search) search.emplace(graph_, cost_);
          reached[node] = search_from(*search, node);
        }
        for (const ReachedNode& other : reached[node]) cost[std::size_t(other.node)] = other.cost;
        from_node(int(node), cost, found[node]);
        for (const ReachedNode& other : reached[node]) cost[std::size_t(other.node)] = unreached;
      }
    });
    for (const auto& of_node : found) out.insert(out.end(), of_node.begin(), of_node.end());
    if (cache) cache->keep_reached(graph_, cost_, vertices_, std::move(reached));
  }

 private:
  [[nodiscard]] std::vector<ReachedNode> search_from(TravelSearch& search, std::size_t node) const {
    search.run(std::uint32_t(vertices_[node]), counts_, searched_for_edges);
    std::vector<ReachedNode> reached;
    for (std::size_t other = 0; other < vertices_.size(); ++other) {
      if (vertices_[other] < 0) continue;
      const float cost = search.cost(std::uint32_t(vertices_[other]));
      if (cost < unreached)
        reached.push_back(
            {int(other), cost_.data() == graph_.cost.data() ? cost : walk_to(search, std::uint32_t(vertices_[other]))});
    }
    return reached;
  }

  /// What a way that was chosen by other costs takes to walk.
  [[nodiscard]] float walk_to(const TravelSearch& search, std::uint32_t vertex) const {
    double walk = 0;
    for (; search.parent(vertex) >= 0; vertex = std::uint32_t(search.parent(vertex)))
      walk += double(graph_.cost[search.parent_slot(vertex)]);
    return float(walk);
  }

  void from_node(int node, const std::vector<float>& cost, std::vector<Onward>& out) const {
    for (const Party& party : parties_) {
      const auto& presence = *party.presence;
      const auto here = std::lower_bound(presence.begin(), presence.end(), node, [](const auto& p, int n) { return p.node < n; });
      if (here == presence.end() || here->node != node) continue;
      const float speed = web_.species[std::size_t(level_.species[std::size_t(party.species_index)])].animal().speed;
      const auto onward = onward_edges(level_, party, vertices_, cost, node, speed, cell_size_);
      out.insert(out.end(), onward.begin(), onward.end());
    }
  }

  const FoodWeb& web_;
  const AnimalLevel& level_;
  const TravelGraph& graph_;
  std::span<const float> cost_;
  const std::vector<std::int32_t>& vertices_;
  double cell_size_;
  std::vector<Party> parties_;
  std::vector<std::uint16_t> counts_;
  /// Nodes where somebody may set out.
  std::vector<std::uint8_t> wanted_;
};

}  // namespace

Result<LevelMovement> compute_level_movement(const FoodWeb& web, const AnimalLevel& level, const Ground& ground,
                                             const TaskContext& context, MovementCache* cache) {
  auto travel = std::make_shared<LevelTravel>();
  if (!level.species.empty()) find_graphs(web, level, ground, cache, *travel);
  context.report("travel", 0.4);
  if (context.stopped()) return fail("stopped");
  travel->presence.resize(level.species.size());
  for (std::size_t s = 0; s < level.species.size(); ++s) {
    auto& of_region = travel->presence[s];
    of_region.resize(level.regions[s]->regions.size());
    parallel_each(of_region.size(), [&](std::size_t region) {
      if (level.population[s][region] <= 0) return;
      of_region[region] = presence_in_region(web, level, int(s), int(region));
    });
  }
  std::vector<Onward> onward;
  for (std::size_t graph = 0; graph < travel->graphs.size(); ++graph) {
    if (context.stopped()) return fail("stopped");
    EdgeFinder(web, level, *travel, graph, ground.terrain->cell_size).run(cache, onward);
    context.report("travel", 0.4 + 0.6 * double(graph + 1) / double(travel->graphs.size()));
  }
  std::sort(onward.begin(), onward.end(), [](const Onward& a, const Onward& b) {
    if (a.edge.species != b.edge.species) return a.edge.species < b.edge.species;
    return a.edge.from != b.edge.from ? a.edge.from < b.edge.from : a.edge.to < b.edge.to;
  });
  LevelMovement movement;
  for (const Onward& candidate : onward) {
    movement.edges.push_back(candidate.edge);
    travel->onward.push_back(candidate.probability);
  }
  movement.travel = std::move(travel);
  return movement;
}

}  // namespace biotope
