#include <algorithm>
#include <array>

#include "core/ecosystem/eaten_zones.hpp"
#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {
namespace {

/// The plants of one stratum that the level eats.
struct EdibleStratum {
  std::vector<int> species;
  std::vector<std::size_t> maps;  ///< their places among the level's plants
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
    stratum.maps.push_back(i);
  }
  return result;
}

/// Runs of the pieces where the stratum is present.
RunTable present_runs(const EdibleStratum& stratum, const PresentTiles& tiles, const Partition& partition) {
  const int threshold = int(presence_cover * full_cover + 0.5F);
  return collect_runs<std::int32_t>(partition.label.width(), partition.label.height(), [&](int y, std::span<std::int32_t> out) {
    const auto piece = partition.label.row(y);
    const std::size_t width = out.size();
    for (int column = 0; column < tiles.columns(); ++column) {
      std::array<std::uint16_t, tile_side> sum{};
      for (const std::size_t map : stratum.maps) {
        const Cover* cover = tiles.row(map, column, y);
        if (cover == nullptr) continue;
        for (std::size_t x = 0; x < sum.size(); ++x) sum[x] = std::uint16_t(sum[x] + cover[x]);
      }
      const std::size_t x0 = std::size_t(column) * tile_side;
      const std::size_t cells = std::min(width - x0, sum.size());
      for (std::size_t x = 0; x < cells; ++x) out[x0 + x] = sum[x] >= threshold ? piece[x0 + x] : -1;
    }
  });
}

/// Quantities of a patch.
std::vector<ResourceQuantity> patch_quantities(const ResourceSources& sources, const EdibleStratum& stratum, std::size_t patch) {
  std::vector<ResourceQuantity> quantities;
  const std::size_t plants = stratum.species.size();
  for (std::size_t i = 0; i < plants; ++i) {
    const double kilograms =
        growth_of(sources.web, stratum.species[i], stratum.sums[patch * plants + i], sources.ground.terrain->cell_area());
    if (kilograms > 0) quantities.push_back({stratum.species[i], kilograms, kilograms});
  }
  return quantities;
}

/// Makes nodes of the patches that are kept, over all strata.
void make_nodes(const ResourceSources& sources, std::array<EdibleStratum, strata>& all, GraphLevel& graph) {
  std::vector<VegetationPatch> candidates;
  for (const EdibleStratum& stratum : all) {
    for (std::size_t patch = 0; patch < stratum.patches.patches.size(); ++patch) {
      candidates.push_back({int(stratum.patches.patches[patch].value), patch_quantities(sources, stratum, patch)});
    }
  }
  const std::vector<char> keep = choose_patches(sources, candidates);
  std::size_t candidate = 0;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const Patches& own = all[s].patches;
    all[s].node_of_patch.assign(own.patches.size(), -1);
    std::vector<std::int32_t> patch_of_run(own.runs.runs.size());
    for (std::size_t i = 0; i < patch_of_run.size(); ++i) patch_of_run[i] = std::int32_t(own.runs.runs[i].value);
    const auto nearest = nearest_to_centroid(own.runs, patch_of_run, own.patches);
    for (std::size_t patch = 0; patch < own.patches.size(); ++patch, ++candidate) {
      if (!keep[candidate]) continue;
      all[s].node_of_patch[patch] = std::int32_t(graph.nodes.size());
      ResourceNode node = node_of_area(own.patches[patch], nearest[patch], sources.ground.terrain->cell_area());
      node.kind = NodeKind::vegetation;
      node.group = int(s);
      node.piece = candidates[candidate].piece;
      node.quantities = std::move(candidates[candidate].quantities);
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

/// Subtracts from the nodes' quantities what levels below ate there.
void subtract_eaten(const ResourceSources& sources, const EdibleStratum& stratum, std::size_t s, GraphLevel& graph) {
  const EatenZones zones(sources.below, stratum.species);
  if (zones.nothing_eaten()) return;
  const Grid<std::int32_t>& own = *graph.node_of_cell[s];
  RunTable table = collect_runs(own.width(), own.height(), [&](int y, std::span<std::int64_t> out) {
    std::copy(own.row(y).begin(), own.row(y).end(), out.begin());
    zones.refine_row(y, out);
  });
  const std::vector<std::int64_t> values = number_values(table);
  const std::vector<std::uint64_t> sums = cover_sums(table, values.size(), sources.tiles, stratum.maps);
  const std::size_t plants = stratum.species.size();
  for (ResourceNode& node : graph.nodes) {
    if (node.group != int(s)) continue;
    for (ResourceQuantity& quantity : node.quantities) quantity.available = 0;
  }
  for (std::size_t group = 0; group < values.size(); ++group) {
    ResourceNode& node = graph.nodes[std::size_t(values[group] / zones.count())];
    for (ResourceQuantity& quantity : node.quantities) {
      const auto plant =
          std::size_t(std::find(stratum.species.begin(), stratum.species.end(), quantity.species) - stratum.species.begin());
      quantity.available +=
          zones.left(values[group] % zones.count(), plant) *
          growth_of(sources.web, quantity.species, sums[group * plants + plant], sources.ground.terrain->cell_area());
      quantity.available = std::min(quantity.available, quantity.kilograms_per_year);
    }
  }
}

}  // namespace

void add_vegetation_nodes(const ResourceSources& sources, GraphLevel& graph) {
  std::array<EdibleStratum, strata> all = edible_strata(sources);
  std::size_t present_cells = 0;
  for (EdibleStratum& stratum : all) {
    if (stratum.species.empty()) continue;
    stratum.present = present_runs(stratum, sources.tiles, sources.partition);
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
    stratum.sums = cover_sums(stratum.patches.runs, stratum.patches.patches.size(), sources.tiles, stratum.maps);
  });
  make_nodes(sources, all, graph);
  for (std::size_t s = 0; s < all.size(); ++s) {
    if (all[s].patches.patches.empty()) continue;
    graph.node_of_cell[s] = node_grid(all[s]);
    subtract_eaten(sources, all[s], s, graph);
  }
}

}  // namespace biotope
