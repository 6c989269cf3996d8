#include <algorithm>
#include <functional>

#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// Prey species of one level that share a map of regions.
struct PreyGroup {
  const AnimalLevel* own_level = nullptr;
  const ConfinementRegions* regions = nullptr;
  std::vector<int> species;
  std::vector<std::size_t> index;  ///< of each species in the level
};

std::vector<PreyGroup> prey_groups(const ResourceSources& sources) {
  std::vector<PreyGroup> groups;
  const std::vector<char> edible = edible_to_level(sources.web, sources.level);
  for (const auto& level : sources.below) {
    for (std::size_t i = 0; i < level->species.size(); ++i) {
      if (!edible[std::size_t(level->species[i])]) continue;
      auto group = std::find_if(groups.begin(), groups.end(), [&](const PreyGroup& own) {
        return own.own_level == level.get() && own.regions == level->regions[i].get();
      });
      if (group == groups.end()) group = groups.insert(groups.end(), {level.get(), level->regions[i].get(), {}, {}});
      group->species.push_back(level->species[i]);
      group->index.push_back(i);
    }
  }
  return groups;
}

/// Overlap of a region with a piece, and the zones of what was eaten in it.
struct Overlap {
  std::int64_t region = 0;
  std::int64_t piece = 0;
  Area area;
  NearestCell nearest;
  std::vector<std::pair<std::int64_t, std::size_t>> cells_of_zone;
};

/// Runs of a group's regions and the pieces, value = region * pieces + piece, from those of its level's partition, which is
/// finer.
RunTable region_runs(const RunTable& paired, const PreyGroup& group, std::int64_t pieces) {
  const auto& own_pieces = group.own_level->partition->pieces;
  RunTable table{paired.width, paired.height, {}, {0}};
  table.runs.reserve(paired.runs.size());
  table.row_start.reserve(paired.row_start.size());
  for (int y = 0; y < paired.height; ++y) {
    for (const CellRun& run : paired.row(y)) {
      const std::int64_t region = own_pieces[std::size_t(run.value / pieces)].region[group.index.front()];
      if (region < 0) continue;
      const std::int64_t value = region * pieces + run.value % pieces;
      const bool continues =
          table.runs.size() > table.row_start.back() && table.runs.back().x1 == run.x0 && table.runs.back().value == value;
      if (continues) {
        table.runs.back().x1 = run.x1;
      } else {
        table.runs.push_back({run.x0, run.x1, value});
      }
    }
    table.row_start.push_back(table.runs.size());
  }
  return table;
}

std::vector<Overlap> find_overlaps(RunTable table, std::int64_t pieces, const EatenZones& zones) {
  const std::vector<std::int64_t> values = number_values(table);
  RunTable pair_table;
  for (const std::int64_t value : values) pair_table.runs.push_back({0, 1, value / zones.count()});
  const std::vector<std::int64_t> pairs = number_values(pair_table);

  std::vector<Area> areas(pairs.size());
  std::vector<std::size_t> cells(values.size());
  std::vector<std::int32_t> pair_of_run(table.runs.size());
  for (int y = 0; y < table.height; ++y) {
    for (std::size_t i = table.row_start[std::size_t(y)]; i < table.row_start[std::size_t(y) + 1]; ++i) {
      const CellRun& run = table.runs[i];
      pair_of_run[i] = std::int32_t(pair_table.runs[std::size_t(run.value)].value);
      cells[std::size_t(run.value)] += std::size_t(run.x1 - run.x0);
      areas[std::size_t(pair_of_run[i])].add_run(y, run);
    }
  }
  const std::vector<NearestCell> nearest = nearest_to_centroid(table, pair_of_run, areas);
  std::vector<Overlap> overlaps;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    overlaps.push_back({pairs[i] / pieces, pairs[i] % pieces, areas[i], nearest[i], {}});
  for (std::size_t i = 0; i < values.size(); ++i) {
    overlaps[std::size_t(pair_table.runs[i].value)].cells_of_zone.emplace_back(values[i] % zones.count(), cells[i]);
  }
  return overlaps;
}

/// Supplies of one species of a group.
void add_supplies(const ResourceSources& sources, const PreyGroup& group, std::size_t member,
                  const std::vector<Overlap>& overlaps, const EatenZones& zones, std::vector<PreySupply>& out) {
  const AnimalTraits& animal = sources.web.species[std::size_t(group.species[member])].animal();
  const std::vector<double> lost = mean_losses(*group.regions, loss_of(sources.losses, group.species[member]));
  for (const Overlap& overlap : overlaps) {
    const double individuals = group.own_level->population[group.index[member]][std::size_t(overlap.region)];
    const double growth_of_cell = individuals * double(animal.growth_rate) * double(animal.mean_mass()) *
                                  (1 - lost[std::size_t(overlap.region)]) /
                                  double(group.regions->regions[std::size_t(overlap.region)].cells);
    PreySupply supply{
        group.species[member], int(overlap.region), int(overlap.piece), growth_of_cell * double(overlap.area.cells), 0,
        overlap.area,          overlap.nearest};
    for (const auto& [zone, cells] : overlap.cells_of_zone)
      supply.available += growth_of_cell * double(cells) * zones.left(zone, member);
    supply.available = std::min(supply.available, supply.growth);
    if (supply.available > 0) out.push_back(supply);
  }
}

/// Nodes of the prey's own level in its region.
std::vector<int> nodes_in_region(const ResourceSources& sources, const PreySupply& supply) {
  std::vector<int> nodes;
  const AnimalLevel& own = *sources.below[std::size_t(sources.web.level[std::size_t(supply.species)]) - 1];
  const std::size_t index = std::size_t(std::find(own.species.begin(), own.species.end(), supply.species) - own.species.begin());
  for (std::size_t i = 0; i < own.graph->nodes.size(); ++i) {
    if (own.graph->nodes[i].kind == NodeKind::waypoint) continue;
    if (own.partition->pieces[std::size_t(own.graph->nodes[i].piece)].region[index] == supply.region) nodes.push_back(int(i));
  }
  return nodes;
}

}  // namespace

std::vector<PreySupply> find_prey(const ResourceSources& sources) {
  const std::vector<PreyGroup> groups = prey_groups(sources);
  const std::int64_t pieces = std::int64_t(sources.partition.pieces.size());
  /// By level below: runs of the pairs of its pieces and this level's, value = piece below * pieces + piece.
  std::vector<RunTable> paired(sources.below.size());
  for (const PreyGroup& group : groups) {
    const auto own = std::size_t(group.own_level->level) - 1;
    if (!paired[own].row_start.empty()) continue;
    paired[own] = intersected(*piece_runs(*group.own_level), sources.pieces,
                              [pieces](std::int64_t below, std::int64_t piece) { return below * pieces + piece; });
  }
  std::vector<std::vector<PreySupply>> found(groups.size());
  parallel_each(groups.size(), [&](std::size_t g) {
    const EatenZones zones(sources.below, groups[g].species);
    RunTable runs = zones.refined(region_runs(paired[std::size_t(groups[g].own_level->level) - 1], groups[g], pieces));
    const std::vector<Overlap> overlaps = find_overlaps(std::move(runs), pieces, zones);
    for (std::size_t i = 0; i < groups[g].species.size(); ++i) add_supplies(sources, groups[g], i, overlaps, zones, found[g]);
  });
  std::vector<PreySupply> all;
  for (const auto& own : found) all.insert(all.end(), own.begin(), own.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.species < b.species; });
  return all;
}

void add_prey_nodes(const ResourceSources& sources, std::span<const PreySupply> prey, GraphLevel& graph) {
  const std::size_t minimum = minimum_region_cells(sources.ground.terrain->cell_size);
  std::vector<double> amounts;
  for (const PreySupply& supply : prey) {
    if (supply.area.cells >= minimum) amounts.push_back(supply.available);
  }
  double first_left_out = 0;
  const std::size_t most = node_limits(sources.level).prey;
  if (amounts.size() > most) {
    std::nth_element(amounts.begin(), amounts.begin() + std::ptrdiff_t(most), amounts.end(), std::greater<>());
    first_left_out = amounts[most];
  }
  for (const PreySupply& supply : prey) {
    if (supply.area.cells < minimum || supply.available <= first_left_out) continue;
    ResourceNode node = node_of_area(supply.area, supply.nearest, sources.ground.terrain->cell_area());
    node.kind = NodeKind::prey;
    node.group = supply.species;
    node.prey_region = supply.region;
    node.piece = supply.piece;
    node.quantities.push_back({supply.species, supply.growth, supply.available});
    node.built_from = nodes_in_region(sources, supply);
    graph.nodes.push_back(std::move(node));
  }
}

}  // namespace biotope
