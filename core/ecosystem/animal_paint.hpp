#pragma once

#include <span>
#include <vector>

#include "core/base/paint.hpp"
#include "core/ecosystem/confinement.hpp"
#include "core/ecosystem/resource_access_graph.hpp"

namespace biotope {

/// What paint on a density makes of the populations of one species.
struct PaintedPopulation {
  /// Individuals by region: the integral of the painted density.
  std::vector<double> population;
  /// By region, where paint adds animals: their number, and its sums over x and y (cells).
  struct Added {
    double individuals = 0;
    double sum_x = 0;
    double sum_y = 0;
  };
  std::vector<Added> added;
  /// Cells painted with animals where the species cannot live, and the first of them.
  std::size_t uninhabitable_cells = 0;
  int uninhabitable_x = 0;
  int uninhabitable_y = 0;
};

/// Integrates lerp(uniform density, value, coverage) over each region; only painted tiles are read. Parallel.
[[nodiscard]] PaintedPopulation painted_population(const ConfinementRegions& regions, std::span<const double> computed,
                                                   const PaintLayer& paint, double cell_size);

/// Painted density on each node over the mean density of the node's region, for AnimalLevel::attraction. `population` is by region, with paint. Nodes
/// of prey stand for whole regions and keep 1.
[[nodiscard]] std::vector<float> node_attraction(const GraphLevel& graph, const ConfinementRegions& regions, std::span<const double> computed,
                                                 std::span<const double> population, const PaintLayer& paint);

/// Individuals per km2 of a region with so many individuals.
[[nodiscard]] double uniform_density(const ConfinementRegions::Region& region, double individuals);

}  // namespace biotope
