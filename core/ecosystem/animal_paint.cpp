#include "core/ecosystem/animal_paint.hpp"

#include <algorithm>
#include <array>

#include "core/base/parallel.hpp"

namespace biotope {
namespace {

constexpr double square_metres_per_km2 = 1e6;

/// Change that one tile's paint makes to one region.
struct Change {
  std::int32_t region = -1;
  double individuals = 0;
  PaintedPopulation::Added added;
};

struct TileChange {
  std::vector<Change> regions;
  std::size_t uninhabitable_cells = 0;
  int uninhabitable_x = 0;
  int uninhabitable_y = 0;
};

Change& change_of(std::vector<Change>& changes, std::int32_t region) {
  if (!changes.empty() && changes.back().region == region) return changes.back();
  const auto found = std::find_if(changes.begin(), changes.end(), [&](const Change& c) { return c.region == region; });
  if (found != changes.end()) {
    std::iter_swap(found, changes.end() - 1);
    return changes.back();
  }
  return changes.emplace_back(Change{region, 0, {}});
}

TileChange change_of_tile(const ConfinementRegions& regions, std::span<const double> computed, const PaintLayer& paint,
                          std::size_t tile, double cell_km2) {
  TileChange result;
  const Rect rect = paint.tile_rect(tile);
  const PaintLayer::Tile& cells = *paint.tile(tile);
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const Paint& cell = cells[PaintLayer::offset(x, y)];
      if (cell.coverage <= 0) continue;
      const std::int32_t region = regions.label(x, y);
      if (region < 0) {
        if (cell.value <= 0) continue;
        if (result.uninhabitable_cells++ == 0) {
          result.uninhabitable_x = x;
          result.uninhabitable_y = y;
        }
        continue;
      }
      const float uniform = float(uniform_density(regions.regions[std::size_t(region)], computed[std::size_t(region)]));
      const double difference = double(std::max(0.0F, painted(uniform, cell)) - uniform) * cell_km2;
      Change& change = change_of(result.regions, region);
      change.individuals += difference;
      if (difference > 0) {
        change.added.individuals += difference;
        change.added.sum_x += difference * x;
        change.added.sum_y += difference * y;
      }
    }
  }
  return result;
}

}  // namespace

namespace {

/// Change of the density sum (individuals per km2, over cells) of one node under one tile's paint.
struct NodeChange {
  std::int32_t node = 0;
  double density = 0;
};

void add_change(std::vector<NodeChange>& changes, std::int32_t node, double density) {
  auto found = std::find_if(changes.rbegin(), changes.rend(), [&](const NodeChange& own) { return own.node == node; });
  if (found != changes.rend()) {
    found->density += density;
  } else {
    changes.push_back({node, density});
  }
}

/// What one tile's paint changes at the nodes under it.
std::vector<NodeChange> node_changes(const GraphLevel& graph, const ConfinementRegions& regions, std::span<const double> computed,
                                     const PaintLayer& paint, std::size_t tile) {
  std::vector<NodeChange> changes;
  const Rect rect = paint.tile_rect(tile);
  const PaintLayer::Tile& cells = *paint.tile(tile);
  std::array<std::int32_t, tile_side> nodes{};
  const auto row_of_nodes = std::span(nodes).first(std::size_t(rect.width()));
  for (int y = rect.y0; y < rect.y1; ++y) {
    const Paint* row = cells.data() + PaintLayer::offset(rect.x0, y);
    if (std::all_of(row, row + rect.width(), [](const Paint& cell) { return cell.coverage <= 0; })) continue;
    for (const auto& map : graph.node_of_cell) {
      if (!map) continue;
      map->read_row(y, rect.x0, row_of_nodes);
      for (int x = rect.x0; x < rect.x1; ++x) {
        const std::int32_t node = nodes[std::size_t(x - rect.x0)];
        const Paint& cell = row[x - rect.x0];
        const std::int32_t region = node >= 0 && cell.coverage > 0 ? regions.label(x, y) : -1;
        if (region < 0) continue;
        const auto uniform = float(uniform_density(regions.regions[std::size_t(region)], computed[std::size_t(region)]));
        add_change(changes, node, double(std::max(0.0F, painted(uniform, cell)) - uniform));
      }
    }
  }
  return changes;
}

}  // namespace

std::vector<float> node_attraction(const GraphLevel& graph, const ConfinementRegions& regions, std::span<const double> computed,
                                   std::span<const double> population, const PaintLayer& paint) {
  std::vector<std::vector<NodeChange>> of_tile(paint.tile_count());
  parallel_each(of_tile.size(), [&](std::size_t tile) {
    if (paint.tile(tile)) of_tile[tile] = node_changes(graph, regions, computed, paint, tile);
  });
  std::vector<double> change(graph.nodes.size(), 0.0);
  for (const auto& tile : of_tile) {
    for (const NodeChange& own : tile) change[std::size_t(own.node)] += own.density;
  }
  std::vector<float> attraction(graph.nodes.size(), 1.0F);
  for (std::size_t i = 0; i < attraction.size(); ++i) {
    const ResourceNode& node = graph.nodes[i];
    const std::int32_t region = regions.label(node.x, node.y);
    if (node.kind == NodeKind::prey || region < 0 || node.cells == 0) continue;
    const auto& of = regions.regions[std::size_t(region)];
    const double mean = uniform_density(of, population[std::size_t(region)]);
    if (mean <= 0) continue;
    const double here = uniform_density(of, computed[std::size_t(region)]) + change[i] / double(node.cells);
    attraction[i] = float(std::max(0.0, here / mean));
  }
  return attraction;
}

double uniform_density(const ConfinementRegions::Region& region, double individuals) {
  return individuals / (region.area / square_metres_per_km2);
}

PaintedPopulation painted_population(const ConfinementRegions& regions, std::span<const double> computed, const PaintLayer& paint,
                                     double cell_size) {
  PaintedPopulation result;
  result.population.assign(computed.begin(), computed.end());
  result.added.resize(computed.size());
  const double cell_km2 = cell_size * cell_size / square_metres_per_km2;
  std::vector<TileChange> changes(paint.tile_count());
  parallel_each(changes.size(), [&](std::size_t tile) {
    if (paint.tile(tile)) changes[tile] = change_of_tile(regions, computed, paint, tile, cell_km2);
  });
  for (const TileChange& tile : changes) {
    for (const Change& change : tile.regions) {
      result.population[std::size_t(change.region)] += change.individuals;
      auto& added = result.added[std::size_t(change.region)];
      added.individuals += change.added.individuals;
      added.sum_x += change.added.sum_x;
      added.sum_y += change.added.sum_y;
    }
    if (result.uninhabitable_cells == 0 && tile.uninhabitable_cells > 0) {
      result.uninhabitable_x = tile.uninhabitable_x;
      result.uninhabitable_y = tile.uninhabitable_y;
    }
    result.uninhabitable_cells += tile.uninhabitable_cells;
  }
  // Rounding must not leave a trace of animals where all were painted away.
  for (double& individuals : result.population) individuals = individuals < 1e-6 ? 0 : individuals;
  return result;
}

}  // namespace biotope
