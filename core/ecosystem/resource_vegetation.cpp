#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// The plants of one stratum that the level eats.
struct EdibleStratum {
  std::vector<int> species;
  std::vector<const CoverMap*> covers;
  RunTable present;
  Areas areas;
  Patches patches;
  /// Summed cover by patch and plant, in 1/full_cover cells.
  std::vector<std::uint64_t> sums;
  /// Node of each patch, -1 when it was not kept.
  std::vector<std::int32_t> node_of_patch;
};

std::array<EdibleStratum, strata> edible_strata(const ResourceSources& sources) {
  std::array<EdibleStratum, strata> result;
  const std::vector<char> edible = edible_to_level(sources.web, sources.level);
  for (std::size_t i = 0; i < sources.plants.size(); ++i) {
    const int species = sources.web.levels[0][i];
    if (!edible[std::size_t(species)] || !sources.plants[i]) continue;
    EdibleStratum& stratum = result[std::size_t(sources.web.species[std::size_t(species)].plant().stratum)];
    stratum.species.push_back(species);
    stratum.covers.push_back(sources.plants[i].get());
  }
  return result;
}

/// Runs of the pieces where the stratum is present.
RunTable present_runs(const EdibleStratum& stratum, const Partition& partition) {
  const int threshold = int(presence_cover * full_cover + 0.5F);
  return collect_runs(partition.label.width(), partition.label.height(), [&](int y, std::span<std::int64_t> out) {
    const auto piece = partition.label.row(y);
    std::vector<std::uint16_t> sum(out.size());
    std::vector<Cover> cover(out.size());
    for (const CoverMap* map : stratum.covers) {
      map->read_row(y, 0, cover);
      for (std::size_t x = 0; x < sum.size(); ++x) sum[x] = std::uint16_t(sum[x] + cover[x]);
    }
    for (std::size_t x = 0; x < sum.size(); ++x) out[x] = sum[x] >= threshold ? piece[x] : -1;
  });
}

/// Sums of cover by group (the runs' values) and map. Whole numbers, so any order of adding gives the same.
std::vector<std::uint64_t> cover_sums(const RunTable& table, std::size_t groups, const std::vector<const CoverMap*>& covers) {
  const std::size_t maps = covers.size();
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> partial([&] { return std::vector<std::uint64_t>(groups * maps); });
  parallel_rows(0, table.height, [&](int y) {
    const auto runs = table.row(y);
    if (runs.empty()) return;
    auto& sums = partial.local();
    std::vector<Cover> cover(static_cast<std::size_t>(table.width));
    for (std::size_t map = 0; map < maps; ++map) {
      covers[map]->read_row(y, 0, cover);
      for (const CellRun& run : runs) {
        sums[std::size_t(run.value) * maps + map] += std::accumulate(cover.begin() + run.x0, cover.begin() + run.x1, std::uint64_t{0});
      }
    }
  });
  std::vector<std::uint64_t> total(groups * maps);
  for (const auto& sums : partial) {
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += sums[i];
  }
  return total;
}

/// Yearly growth of a summed cover, kg.
double growth_of(const FoodWeb& web, int plant, std::uint64_t cover_sum, double cell_area) {
  return double(cover_sum) / full_cover * cell_area * double(web.species[std::size_t(plant)].plant().growth);
}

/// Makes nodes of the patches that grow most, over all strata.
void keep_richest(const ResourceSources& sources, std::array<EdibleStratum, strata>& all, GraphLevel& graph) {
  struct Candidate {
    std::size_t stratum = 0;
    std::size_t patch = 0;
    double kilograms = 0;
  };
  const double cell_area = sources.ground.terrain->cell_area();
  std::vector<Candidate> candidates;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const std::size_t plants = all[s].species.size();
    all[s].node_of_patch.assign(all[s].patches.patches.size(), -1);
    for (std::size_t patch = 0; patch < all[s].patches.patches.size(); ++patch) {
      double kilograms = 0;
      for (std::size_t i = 0; i < plants; ++i) kilograms += growth_of(sources.web, all[s].species[i], all[s].sums[patch * plants + i], cell_area);
      if (kilograms > 0) candidates.push_back({s, patch, kilograms});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.kilograms > b.kilograms; });
  if (candidates.size() > most_vegetation_nodes) candidates.resize(most_vegetation_nodes);
  for (const Candidate& kept : candidates) all[kept.stratum].node_of_patch[kept.patch] = 0;

  for (std::size_t s = 0; s < all.size(); ++s) {
    if (all[s].patches.patches.empty()) continue;
    std::vector<std::int32_t> patch_of_run(all[s].patches.runs.runs.size());
    for (std::size_t i = 0; i < patch_of_run.size(); ++i) patch_of_run[i] = std::int32_t(all[s].patches.runs.runs[i].value);
    const auto nearest = nearest_to_centroid(all[s].patches.runs, patch_of_run, all[s].patches.patches);
    const std::size_t plants = all[s].species.size();
    for (std::size_t patch = 0; patch < nearest.size(); ++patch) {
      if (all[s].node_of_patch[patch] < 0) continue;
      all[s].node_of_patch[patch] = std::int32_t(graph.nodes.size());
      ResourceNode node = node_of_area(all[s].patches.patches[patch], nearest[patch], cell_area);
      node.kind = NodeKind::vegetation;
      node.group = int(s);
      node.piece = int(all[s].patches.patches[patch].value);
      for (std::size_t i = 0; i < plants; ++i) {
        const double kilograms = growth_of(sources.web, all[s].species[i], all[s].sums[patch * plants + i], cell_area);
        if (kilograms > 0) node.quantities.push_back({all[s].species[i], kilograms, kilograms});
      }
      graph.nodes.push_back(std::move(node));
    }
  }
}

std::shared_ptr<const Grid<std::int32_t>> node_grid(const EdibleStratum& stratum) {
  const RunTable& runs = stratum.patches.runs;
  auto grid = std::make_shared<Grid<std::int32_t>>(runs.width, runs.height, -1);
  parallel_rows(0, runs.height, [&](int y) {
    const auto row = grid->row(y);
    for (const CellRun& run : runs.row(y)) {
      const std::int32_t node = stratum.node_of_patch[std::size_t(run.value)];
      if (node >= 0) std::fill(row.begin() + run.x0, row.begin() + run.x1, node);
    }
  });
  return grid;
}

/// What a level below took of the stratum.
struct EatenBelow {
  const GraphLevel* graph = nullptr;
  const Grid<std::int32_t>* node_of_cell = nullptr;
  std::int64_t pieces = 0;
  /// Share eaten by plant of the stratum and piece; empty when none was.
  std::vector<std::vector<double>> share;
};

std::vector<EatenBelow> eaten_below(const ResourceSources& sources, const EdibleStratum& stratum, std::size_t s) {
  std::vector<EatenBelow> result;
  for (const auto& level : sources.below) {
    EatenBelow own{level->graph.get(), level->graph->node_of_cell[s].get(), std::int64_t(level->partition->pieces.size()), {}};
    bool anything = false;
    for (const int plant : stratum.species) {
      own.share.push_back(eaten_share(*level, plant));
      anything = anything || !own.share.back().empty();
    }
    if (anything) result.push_back(std::move(own));
  }
  return result;
}

/// Subtracts from the nodes' quantities what levels below ate there, cell by cell: a level's share applies to the cells of its own nodes.
void subtract_eaten(const ResourceSources& sources, const EdibleStratum& stratum, std::size_t s, GraphLevel& graph) {
  const std::vector<EatenBelow> below = eaten_below(sources, stratum, s);
  if (below.empty()) return;
  std::int64_t zones = 1;
  for (const EatenBelow& level : below) zones *= level.pieces + 1;
  const Grid<std::int32_t>& own = *graph.node_of_cell[s];
  RunTable table = collect_runs(own.width(), own.height(), [&](int y, std::span<std::int64_t> out) {
    const auto nodes = own.row(y);
    for (std::size_t x = 0; x < out.size(); ++x) {
      std::int64_t zone = 0;
      for (std::size_t i = 0; nodes[x] >= 0 && i < below.size(); ++i) {
        const std::int32_t node = below[i].node_of_cell->row(y)[x];
        zone = zone * (below[i].pieces + 1) + (node < 0 ? 0 : below[i].graph->nodes[std::size_t(node)].piece + 1);
      }
      out[x] = nodes[x] < 0 ? -1 : nodes[x] * zones + zone;
    }
  });
  const std::vector<std::int64_t> values = number_values(table);
  const std::vector<std::uint64_t> sums = cover_sums(table, values.size(), stratum.covers);
  const std::size_t plants = stratum.species.size();
  std::vector<std::vector<double>> available(graph.nodes.size());
  for (std::size_t group = 0; group < values.size(); ++group) {
    auto& node = available[std::size_t(values[group] / zones)];
    node.resize(plants);
    for (std::size_t plant = 0; plant < plants; ++plant) {
      double left = 1;
      std::int64_t zone = values[group] % zones;
      for (std::size_t i = below.size(); i-- > 0; zone /= below[i].pieces + 1) {
        const std::int64_t piece = zone % (below[i].pieces + 1) - 1;
        if (piece >= 0 && !below[i].share[plant].empty()) left *= 1 - below[i].share[plant][std::size_t(piece)];
      }
      node[plant] += left * growth_of(sources.web, stratum.species[plant], sums[group * plants + plant], sources.ground.terrain->cell_area());
    }
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (available[n].empty()) continue;
    for (ResourceQuantity& quantity : graph.nodes[n].quantities) {
      const auto plant = std::find(stratum.species.begin(), stratum.species.end(), quantity.species) - stratum.species.begin();
      quantity.available = std::min(quantity.kilograms_per_year, available[n][std::size_t(plant)]);
    }
  }
}

}  // namespace

void add_vegetation_nodes(const ResourceSources& sources, GraphLevel& graph) {
  std::array<EdibleStratum, strata> all = edible_strata(sources);
  std::size_t present_cells = 0;
  for (EdibleStratum& stratum : all) {
    if (stratum.species.empty()) continue;
    stratum.present = present_runs(stratum, sources.partition);
    for (const CellRun& run : stratum.present.runs) present_cells += std::size_t(run.x1 - run.x0);
  }
  SplitRule rule;
  rule.side = patch_side(*sources.ground.terrain, present_cells);
  rule.minimum_cells = minimum_region_cells(sources.ground.terrain->cell_size);
  rule.sliver_cells = std::max(rule.minimum_cells, std::size_t(rule.side) * std::size_t(rule.side) / 8);
  parallel_each(all.size(), [&](std::size_t s) {
    EdibleStratum& stratum = all[s];
    if (stratum.present.runs.empty()) return;
    stratum.areas = connected_areas(stratum.present);
    stratum.patches = split_into_patches(stratum.present, stratum.areas, rule);
    stratum.sums = cover_sums(stratum.patches.runs, stratum.patches.patches.size(), stratum.covers);
  });
  keep_richest(sources, all, graph);
  for (std::size_t s = 0; s < all.size(); ++s) {
    if (all[s].patches.patches.empty()) continue;
    graph.node_of_cell[s] = node_grid(all[s]);
    subtract_eaten(sources, all[s], s, graph);
  }
}

}  // namespace biotope
