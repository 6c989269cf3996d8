#include <algorithm>
#include <functional>
#include <set>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// A prey species of the level and who ate of it between its own level and this one.
struct Prey {
  int species = 0;
  const AnimalLevel* own_level = nullptr;
  std::size_t index = 0;  ///< in own_level->species
  /// Levels between that ate of it, with the shares and the (region, piece) pairs where they found it.
  struct Eaters {
    const AnimalLevel* level = nullptr;
    std::vector<double> share;
    std::set<std::pair<int, int>> found;
  };
  std::vector<Eaters> eaters;

  [[nodiscard]] const ConfinementRegions& regions() const { return *own_level->regions[index]; }
};

std::vector<Prey> prey_of_level(const ResourceSources& sources) {
  std::vector<Prey> result;
  const std::vector<char> edible = edible_to_level(sources.web, sources.level);
  for (const auto& level : sources.below) {
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      const int species = level->species[i];
      if (!edible[std::size_t(species)]) continue;
      Prey prey{species, level.get(), i, {}};
      for (const auto& above : sources.below) {
        std::vector<double> share = above->level > level->level ? eaten_share(*above, species) : std::vector<double>{};
        if (share.empty()) continue;
        Prey::Eaters& eaters = prey.eaters.emplace_back(Prey::Eaters{above.get(), std::move(share), {}});
        for (const ResourceNode& node : above->graph->nodes) {
          if (node.kind == NodeKind::prey && node.group == species) eaters.found.insert({node.prey_region, node.piece});
        }
      }
      result.push_back(std::move(prey));
    }
  }
  return result;
}

/// Where the regions of a prey overlap the pieces of this level; one map serves all prey that share regions and eaters.
struct Overlaps {
  const ConfinementRegions* regions = nullptr;
  std::vector<const AnimalLevel*> eaters;
  /// Runs numbered by (region, piece, piece of each eater).
  RunTable table;
  struct Zone {
    std::int32_t pair = 0;  ///< in `pairs`
    std::vector<std::int64_t> eater_piece;
    std::size_t cells = 0;
  };
  std::vector<Zone> zones;
  struct Pair {
    std::int64_t region = 0;
    std::int64_t piece = 0;
  };
  std::vector<Pair> pairs;
  std::vector<Area> areas;  ///< by pair
  std::vector<NearestCell> nearest;
};

Overlaps find_overlaps(const Prey& prey, const Partition& partition) {
  Overlaps result;
  result.regions = &prey.regions();
  for (const auto& eaters : prey.eaters) result.eaters.push_back(eaters.level);
  const std::int64_t pieces = std::int64_t(partition.pieces.size());
  const Grid<std::int32_t>& label = partition.label;
  result.table = collect_runs(label.width(), label.height(), [&](int y, std::span<std::int64_t> out) {
    const auto region = result.regions->label.row(y);
    const auto piece = label.row(y);
    for (std::size_t x = 0; x < out.size(); ++x) {
      std::int64_t value = (region[x] | piece[x]) < 0 ? -1 : std::int64_t(region[x]) * pieces + piece[x];
      for (std::size_t i = 0; value >= 0 && i < result.eaters.size(); ++i) {
        const Partition& other = *result.eaters[i]->partition;
        value = value * std::int64_t(other.pieces.size() + 1) + other.label.row(y)[x] + 1;
      }
      out[x] = value;
    }
  });
  const std::vector<std::int64_t> values = number_values(result.table);
  RunTable pair_table;
  pair_table.runs.reserve(values.size());
  for (std::int64_t value : values) {
    Overlaps::Zone zone;
    for (std::size_t i = result.eaters.size(); i-- > 0;) {
      const std::int64_t base = std::int64_t(result.eaters[i]->partition->pieces.size()) + 1;
      zone.eater_piece.insert(zone.eater_piece.begin(), value % base - 1);
      value /= base;
    }
    pair_table.runs.push_back({0, 1, value});
    result.zones.push_back(std::move(zone));
  }
  for (const std::int64_t pair : number_values(pair_table)) result.pairs.push_back({pair / pieces, pair % pieces});
  for (std::size_t i = 0; i < result.zones.size(); ++i) result.zones[i].pair = std::int32_t(pair_table.runs[i].value);

  result.areas.resize(result.pairs.size());
  std::vector<std::int32_t> pair_of_run(result.table.runs.size());
  for (int y = 0; y < label.height(); ++y) {
    for (std::size_t i = result.table.row_start[std::size_t(y)]; i < result.table.row_start[std::size_t(y) + 1]; ++i) {
      const CellRun& run = result.table.runs[i];
      Overlaps::Zone& zone = result.zones[std::size_t(run.value)];
      zone.cells += std::size_t(run.x1 - run.x0);
      pair_of_run[i] = zone.pair;
      result.areas[std::size_t(zone.pair)].add_run(y, run);
    }
  }
  result.nearest = nearest_to_centroid(result.table, pair_of_run, result.areas);
  return result;
}

/// Nodes of one prey species over the pieces its regions overlap.
std::vector<ResourceNode> nodes_of_prey(const ResourceSources& sources, const Prey& prey, const Overlaps& overlaps) {
  const AnimalTraits& animal = sources.web.species[std::size_t(prey.species)].animal();
  const auto& population = prey.own_level->population[prey.index];
  const double cell_area = sources.ground.terrain->cell_area();
  const auto growth_of_cells = [&](std::int64_t region, std::size_t cells) {
    return population[std::size_t(region)] * double(animal.growth_rate) * double(animal.mean_mass()) * double(cells) /
           double(prey.regions().regions[std::size_t(region)].cells);
  };
  std::vector<double> available(overlaps.pairs.size());
  for (const Overlaps::Zone& zone : overlaps.zones) {
    const std::int64_t region = overlaps.pairs[std::size_t(zone.pair)].region;
    double left = growth_of_cells(region, zone.cells);
    for (std::size_t i = 0; i < prey.eaters.size(); ++i) {
      const int piece = int(zone.eater_piece[i]);
      if (piece >= 0 && prey.eaters[i].found.contains({int(region), piece})) left *= 1 - prey.eaters[i].share[std::size_t(piece)];
    }
    available[std::size_t(zone.pair)] += left;
  }
  std::vector<ResourceNode> nodes;
  for (std::size_t pair = 0; pair < overlaps.pairs.size(); ++pair) {
    if (available[pair] <= 0 || overlaps.areas[pair].cells < minimum_region_cells(sources.ground.terrain->cell_size)) continue;
    ResourceNode node = node_of_area(overlaps.areas[pair], overlaps.nearest[pair], cell_area);
    node.kind = NodeKind::prey;
    node.group = prey.species;
    node.prey_region = int(overlaps.pairs[pair].region);
    node.piece = int(overlaps.pairs[pair].piece);
    const double growth = growth_of_cells(overlaps.pairs[pair].region, overlaps.areas[pair].cells);
    node.quantities.push_back({prey.species, growth, std::min(growth, available[pair])});
    const AnimalLevel& own = *prey.own_level;
    for (std::size_t i = 0; i < own.graph->nodes.size(); ++i) {
      const auto& piece = own.partition->pieces[std::size_t(own.graph->nodes[i].piece)];
      if (piece.region[prey.index] == node.prey_region) node.built_from.push_back(int(i));
    }
    nodes.push_back(std::move(node));
  }
  return nodes;
}

/// Two prey with the same regions and eaters overlap the pieces alike.
bool overlap_alike(const Prey& a, const Prey& b) {
  return &a.regions() == &b.regions() && std::equal(a.eaters.begin(), a.eaters.end(), b.eaters.begin(), b.eaters.end(),
                                                    [](const auto& x, const auto& y) { return x.level == y.level; });
}

/// Keeps the nodes that offer most, in their order.
void keep_most(std::vector<ResourceNode>& nodes) {
  if (nodes.size() <= most_prey_nodes) return;
  std::vector<double> amounts;
  for (const ResourceNode& node : nodes) amounts.push_back(node.quantities.front().available);
  std::nth_element(amounts.begin(), amounts.begin() + most_prey_nodes, amounts.end(), std::greater<>());
  const double first_left_out = amounts[most_prey_nodes];
  std::erase_if(nodes, [&](const ResourceNode& node) { return node.quantities.front().available <= first_left_out; });
}

}  // namespace

void add_prey_nodes(const ResourceSources& sources, GraphLevel& graph) {
  const std::vector<Prey> all = prey_of_level(sources);
  std::vector<std::size_t> overlaps_of_prey;
  std::vector<const Prey*> first_prey;
  for (const Prey& prey : all) {
    const auto found = std::find_if(first_prey.begin(), first_prey.end(), [&](const Prey* first) { return overlap_alike(*first, prey); });
    overlaps_of_prey.push_back(std::size_t(found - first_prey.begin()));
    if (found == first_prey.end()) first_prey.push_back(&prey);
  }
  std::vector<Overlaps> overlaps(first_prey.size());
  parallel_each(overlaps.size(), [&](std::size_t i) { overlaps[i] = find_overlaps(*first_prey[i], sources.partition); });

  std::vector<ResourceNode> nodes;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (ResourceNode& node : nodes_of_prey(sources, all[i], overlaps[overlaps_of_prey[i]])) nodes.push_back(std::move(node));
  }
  keep_most(nodes);
  for (ResourceNode& node : nodes) graph.nodes.push_back(std::move(node));
}

}  // namespace biotope
