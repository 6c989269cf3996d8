#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/cell_runs.hpp"

namespace biotope {

/// Summed cover above which a stratum counts as present (authors' public code).
inline constexpr float presence_cover = 0.2F;
/// Longest stretch of bank that is one node, m.
inline constexpr double longest_bank = 300;
/// Nodes that a level keeps at most, by kind. Our choice: a graph that people can read and travel times that stay cheap. Banks may be more
/// where that many regions would otherwise have no water.
inline constexpr std::size_t most_vegetation_nodes = 180;
inline constexpr std::size_t most_prey_nodes = 120;
inline constexpr std::size_t most_bank_nodes = 120;

/// What the nodes of a level are made from.
struct ResourceSources {
  const FoodWeb& web;
  int level = 1;
  const Ground& ground;
  const Partition& partition;
  /// Plants in the order of web.levels[0], paint included.
  std::span<const std::shared_ptr<const CoverMap>> plants;
  /// Animal levels below, level 1 first.
  std::span<const std::shared_ptr<const AnimalLevel>> below;
};

/// Banks, vegetation and prey that the species of a level can reach, with quantities; see paper section 5.
[[nodiscard]] GraphLevel build_resource_nodes(const ResourceSources& sources, const TaskContext& context = {});

/// Whether some species of the level eats it, by species number.
[[nodiscard]] std::vector<char> edible_to_level(const FoodWeb& web, int level);

/// What a level found of a resource in each piece of its partition, kg per year.
[[nodiscard]] std::vector<double> available_by_piece(const GraphLevel& graph, std::size_t pieces, int resource);

/// Share 0..1 of what it found of a resource in each piece that a level ate; empty when it ate nothing of it.
[[nodiscard]] std::vector<double> eaten_share(const AnimalLevel& level, int resource);

/// Side (cells) of the lattice that cuts large meadows and woods when `present_cells` cells of strata are covered: 400 m, a tenth of the map's
/// longer side, and wide enough that about 150 squares are present. Our choice.
[[nodiscard]] int patch_side(const Terrain& terrain, std::size_t present_cells);

/// Parts of the nodes, in the order in which they are numbered. Each fills the kind's nodes and, but for prey, the grid of its cells.
void add_vegetation_nodes(const ResourceSources& sources, GraphLevel& graph);
void add_prey_nodes(const ResourceSources& sources, GraphLevel& graph);
/// Last: only regions that have something to eat need water.
void add_bank_nodes(const ResourceSources& sources, GraphLevel& graph);

/// A node over an area.
[[nodiscard]] ResourceNode node_of_area(const Area& area, NearestCell position, double cell_area);

/// Replaces the values of the runs by 0, 1, ... in order of appearance; returns the values.
[[nodiscard]] std::vector<std::int64_t> number_values(RunTable& table);

}  // namespace biotope
