#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/paint.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/ecosystem/confinement.hpp"
#include "core/ecosystem/cover.hpp"
#include "core/ecosystem/resource_access_graph.hpp"
#include "core/ecosystem/warning.hpp"
#include "core/species/species_library.hpp"

namespace biotope {

/// Animals that travel together.
struct Herd {
  int species = 0;  ///< number in the food web
  int region = 0;   ///< confinement region of that species
  int size = 0;     ///< individuals
};

struct AnimalLevel;
struct BankStretches;
struct SupplyTiles;

/// What a level was computed from, so that the next one can take over what did not change.
struct AnimalLevelBasis {
  Ground ground;
  /// Limits of each species of the level.
  std::vector<Mobility> mobility;
  std::vector<std::shared_ptr<const CoverMap>> plants;
  std::vector<std::shared_ptr<const AnimalLevel>> below;
  std::vector<std::shared_ptr<const PaintLayer>> losses;
  /// The banks, and what was summed up tile by tile.
  std::shared_ptr<const BankStretches> banks;
  std::shared_ptr<const SupplyTiles> supply;
};

/// One animal level after competition and paint.
struct AnimalLevel {
  int level = 1;
  /// Species numbers of the level; the vectors below have one entry each, in this order.
  std::vector<int> species;
  std::vector<std::shared_ptr<const ConfinementRegions>> regions;
  std::shared_ptr<const Partition> partition;
  /// Resources of the level, without spatial edges (movement adds those).
  std::shared_ptr<const GraphLevel> graph;
  /// Individuals by species and region: as competition made them, and with paint.
  std::vector<std::vector<double>> computed_population;
  std::vector<std::vector<double>> population;
  /// Where in its regions paint draws a species: by species and node of `graph`, the painted density on the node over the mean of
  /// its region (1 where nothing is painted). Empty for a species without paint.
  std::vector<std::vector<float>> attraction;
  std::vector<Herd> herds;
  /// Shares of the level's individuals; `desired` is empty when none was asked.
  std::vector<double> desired;
  std::vector<double> achieved;
  /// kg a year that the levels below left for this one, by resource species (number in the web) and piece of this level's
  /// partition: all growth in the piece's cells, whether in a node or not.
  std::vector<std::vector<double>> available;
  /// The same of each prey by its own regions.
  struct PreyShare {
    int species = 0;
    int region = 0;  ///< confinement region of the prey
    int piece = 0;
    double available = 0;
  };
  std::vector<PreyShare> prey;
  /// kg eaten in a year by resource species (number in the web) and piece of this level's partition.
  std::vector<std::vector<double>> eaten;
  /// Paint that asks for more than there is: what, where and how much.
  struct Shortage {
    int species = 0;
    int region = 0;
    std::string resource;
    double missing = 0;  ///< kg per year; 0 for "water", which has no amount
  };
  std::vector<Shortage> shortages;
  std::vector<Warning> warnings;
  AnimalLevelBasis basis;
};

/// Everything the competition of an animal level reads.
struct AnimalLevelInput {
  const FoodWeb& web;
  int level = 1;
  Ground ground;
  /// Plants in the order of web.levels[0], paint included.
  std::span<const std::shared_ptr<const CoverMap>> plants;
  /// Animal levels below, in order (level 1 first).
  std::span<const std::shared_ptr<const AnimalLevel>> below;
  /// Desired share per species of the level, or empty.
  std::vector<double> desired;
  /// Paint on each species' density (individuals / km2); null where none.
  std::vector<std::shared_ptr<const PaintLayer>> paint;
  /// Share of each species' yearly growth lost to external events (0..1 x coverage), by number in the web; null or missing: none.
  std::vector<std::shared_ptr<const PaintLayer>> losses = {};
  std::uint64_t seed = 1;
  /// The level as it was computed before with the same food web (desired shares apart), or null. Regions, partition, banks and
  /// nodes whose inputs are the same are taken over, as the same objects; the result is equal to the bit to one from scratch.
  std::shared_ptr<const AnimalLevel> previous = {};
};

/// Regions, partition, resource nodes, competition (with or without proportions), paint, herds and what is eaten.
/// A species never takes more than the yearly growth that the levels below and its rivals left. Deterministic; nothing when
/// stopped.
[[nodiscard]] Result<AnimalLevel> compute_animal_level(const AnimalLevelInput& input, const TaskContext& context = {});

/// Individuals per km2 in every cell: uniform over each region, with paint; `species_index` counts within the level.
[[nodiscard]] Grid<float> animal_density(const AnimalLevel& level, int species_index, const PaintLayer* paint);

}  // namespace biotope
