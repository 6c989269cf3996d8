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
  std::vector<std::shared_ptr<const PresenceTile>> presence;
  RunTable present;
  Areas areas;
  Patches patches;
  /// Summed cover by patch and plant.
  CoverSums sums;
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

/// Quantities of a patch.
std::vector<ResourceQuantity> patch_quantities(const ResourceSources& sources, const EdibleStratum& stratum, std::size_t patch) {
  std::vector<ResourceQuantity> quantities;
  const std::size_t plants = stratum.species.size();
  for (std::size_t i = 0; i < plants; ++i) {
    const double kilograms =
        growth_of(sources.web, stratum.species[i], stratum.sums.growing(patch * plants + i), sources.ground.terrain->cell_area());
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

std::shared_ptr<const RunMap> node_map(const EdibleStratum& stratum) {
  const RunTable& runs = stratum.patches.runs;
  return std::make_shared<const RunMap>(collect_rows(runs.width, runs.height, [&](int y, std::vector<CellRun>& out) {
    const std::size_t begin = out.size();
    for (const CellRun& run : runs.row(y)) {
      const std::int32_t node = stratum.node_of_patch[std::size_t(run.value)];
      if (node >= 0) append_run(out, begin, {run.x0, run.x1, node});
    }
  }));
}

/// Subtracts from the nodes' quantities what levels below ate there.
void subtract_eaten(const ResourceSources& sources, const EdibleStratum& stratum, std::size_t s, GraphLevel& graph) {
  const EatenZones zones(sources.below, stratum.species);
  if (zones.nothing_eaten()) return;
  RunTable table = zones.refined(graph.node_of_cell[s]->runs());
  const std::vector<std::int64_t> values = number_values(table);
  const TileReuse& reuse = sources.reuse;
  const CoverSums sums =
      cover_sums(table, values.size(), sources.tiles, stratum.maps, reuse.changed,
                 reuse.before ? &reuse.before->nodes[s] : nullptr, reuse.found ? &reuse.found->nodes[s] : nullptr);
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
          growth_of(sources.web, quantity.species, sums.growing(group * plants + plant), sources.ground.terrain->cell_area());
      quantity.available = std::min(quantity.available, quantity.kilograms_per_year);
    }
  }
}

}  // namespace

void add_vegetation_nodes(const ResourceSources& sources, GraphLevel& graph) {
  std::array<EdibleStratum, strata> all = edible_strata(sources);
  const TileReuse& reuse = sources.reuse;
  std::size_t present_cells = 0;
  for (std::size_t s = 0; s < all.size(); ++s) {
    EdibleStratum& stratum = all[s];
    if (stratum.species.empty()) continue;
    stratum.presence =
        presence_tiles(sources.tiles, stratum.maps, reuse.changed, reuse.before ? &reuse.before->presence[s] : nullptr);
    stratum.present = present_parts(sources.pieces, stratum.presence);
    if (reuse.found) reuse.found->presence[s] = stratum.presence;
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
    stratum.sums =
        cover_sums(stratum.patches.runs, stratum.patches.patches.size(), sources.tiles, stratum.maps, reuse.changed,
                   reuse.before ? &reuse.before->patches[s] : nullptr, reuse.found ? &reuse.found->patches[s] : nullptr);
  });
  make_nodes(sources, all, graph);
  for (std::size_t s = 0; s < all.size(); ++s) {
    if (all[s].patches.patches.empty()) continue;
    graph.node_of_cell[s] = node_map(all[s]);
    subtract_eaten(sources, all[s], s, graph);
  }
}

}  // namespace biotope
