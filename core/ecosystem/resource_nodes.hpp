#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/cell_runs.hpp"
#include "core/ecosystem/losses.hpp"
#include "core/ecosystem/tile_sums.hpp"

namespace biotope {

/// Summed cover above which a stratum counts as present (authors' public code).
inline constexpr float presence_cover = 0.2F;
/// A waypoint or exit stands on passable ground at most this far from where it was placed, m. Our choice.
inline constexpr double waypoint_reach = 20;
/// Longest stretch of bank that is one node, m.
inline constexpr double longest_bank = 300;
/// Nodes that a level keeps at most, by kind. Our choice: a graph that people can read and travel times that stay cheap. Banks
/// may be more where that many regions would otherwise have no water.
struct NodeLimits {
  std::size_t vegetation = 180;
  std::size_t prey = 0;
  std::size_t banks = 120;
};
[[nodiscard]] NodeLimits node_limits(int level);

/// Stretches of bank in the pieces of a partition, before those worth a node are chosen.
struct BankStretches {
  Patches patches;
  std::vector<NearestCell> nearest;
  /// Cells from which water can be drunk, whoever can stand there.
  std::shared_ptr<const RunTable> shore;
};
/// All stretches of some pieces from which water can be drunk. `shore` is that of the same terrain and water where it is known,
/// or null.
[[nodiscard]] std::shared_ptr<const BankStretches> find_banks(const Ground& ground, const RunTable& pieces,
                                                              std::shared_ptr<const RunTable> shore = nullptr);

/// Rows of cover maps by tile, without the tiles that hold none: most species are absent from most of a map. With them the losses
/// of growth in those tiles.
class PresentTiles {
 public:
  /// `losses` is paint by cover map; null or missing where nothing is lost.
  explicit PresentTiles(std::span<const std::shared_ptr<const CoverMap>> covers,
                        std::span<const std::shared_ptr<const PaintLayer>> losses = {});
  /// The tile_side cells of row y in a column of tiles; null where all are 0.
  [[nodiscard]] const Cover* row(std::size_t map, int column, int y) const {
    const Cover* tile =
        tiles_[(map * std::size_t(rows_) + std::size_t(y / tile_side)) * std::size_t(columns_) + std::size_t(column)];
    return tile == nullptr ? nullptr : tile + y % tile_side * tile_side;
  }
  /// Losses of the same cells in steps of 1/whole_loss; null where nothing is lost or nothing grows.
  [[nodiscard]] const std::uint16_t* lost_row(std::size_t map, int column, int y) const {
    if (lost_.empty()) return nullptr;
    const auto& tile =
        lost_[(map * std::size_t(rows_) + std::size_t(y / tile_side)) * std::size_t(columns_) + std::size_t(column)];
    return tile == nullptr ? nullptr : tile->data() + y % tile_side * tile_side;
  }
  [[nodiscard]] bool nothing_lost() const { return lost_.empty(); }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }

 private:
  using LostTile = std::array<std::uint16_t, std::size_t(tile_side) * tile_side>;

  void find_losses(std::span<const std::shared_ptr<const PaintLayer>> losses);

  int columns_ = 0;
  int rows_ = 0;
  /// By map, row and column of tiles.
  std::vector<const Cover*> tiles_;
  /// What stands for the tiles that a map lacks; null where that is no cover.
  std::vector<CoverMap::TilePointer> background_;
  /// As tiles_; empty when nothing is lost anywhere.
  std::vector<std::unique_ptr<LostTile>> lost_;
};

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
  /// Tiles of `plants` and their losses.
  const PresentTiles& tiles;
  const BankStretches& banks;
  /// Share of each species' yearly growth lost to external events, by number in the web; null or missing: none.
  std::span<const std::shared_ptr<const PaintLayer>> losses = {};
  /// Runs of the pieces of `partition`.
  const RunTable& pieces;
  /// What an earlier computation over the same kinds of plants found.
  TileReuse reuse = {};
};
/// Runs of the pieces of a level's partition; those it keeps, or new ones.
[[nodiscard]] std::shared_ptr<const RunTable> piece_runs(const AnimalLevel& level);

/// The losses of plants, in the order of web.levels[0].
[[nodiscard]] std::vector<std::shared_ptr<const PaintLayer>> plant_losses(
    const FoodWeb& web, std::span<const std::shared_ptr<const PaintLayer>> losses);

/// Prey of one species that lives in one of its regions and in one piece of this level.
struct PreySupply {
  int species = 0;
  int region = 0;
  int piece = 0;
  double growth = 0;     ///< kg per year
  double available = 0;  ///< what the levels below this one left
  Area area;
  NearestCell nearest;
};
/// All prey of the level with something left, by species.
[[nodiscard]] std::vector<PreySupply> find_prey(const ResourceSources& sources);

/// kg a year that the levels below left, by resource species and piece: of plants all growth in the piece's cells.
[[nodiscard]] std::vector<std::vector<double>> available_supply(const ResourceSources& sources, std::span<const PreySupply> prey);

/// Banks, vegetation and prey that the species of a level can reach, with quantities; see paper section 5.
[[nodiscard]] GraphLevel build_resource_nodes(const ResourceSources& sources, std::span<const PreySupply> prey,
                                              const TaskContext& context = {});

/// Whether some species of the level eats it, by species number.
[[nodiscard]] std::vector<char> edible_to_level(const FoodWeb& web, int level);

/// Yearly growth of a summed cover (1/full_cover cells), kg.
[[nodiscard]] double growth_of(const FoodWeb& web, int plant, double cover_sum, double cell_area);

/// Side (cells) of the lattice that cuts large meadows and woods when `present_cells` cells of strata are covered: 400 m, a tenth
/// of the map's longer side, and wide enough that about 150 squares are present. Our choice.
[[nodiscard]] int patch_side(const Terrain& terrain, std::size_t present_cells);

/// Parts of the nodes, in the order in which they are numbered. Each fills the kind's nodes and, but for prey, the grid of its
/// cells.
void add_vegetation_nodes(const ResourceSources& sources, GraphLevel& graph);
void add_prey_nodes(const ResourceSources& sources, std::span<const PreySupply> prey, GraphLevel& graph);
/// After those: only regions that have something to eat need water.
void add_bank_nodes(const ResourceSources& sources, GraphLevel& graph);
/// A node for every waypoint and exit that some species of the level can reach, in the order in which they were placed:
/// waypoints, then exits.
void add_waypoint_nodes(const ResourceSources& sources, GraphLevel& graph);

/// A patch of vegetation that may become a node.
struct VegetationPatch {
  int piece = 0;
  std::vector<ResourceQuantity> quantities;
};
/// The patches that are kept, at most `node_limits`: up to half of them the richest of each region for each need, from the region
/// that grows most on, so that a region of some weight is not forgotten over the largest; then those that grow most.
[[nodiscard]] std::vector<char> choose_patches(const ResourceSources& sources, std::span<const VegetationPatch> patches);

/// A node over an area.
[[nodiscard]] ResourceNode node_of_area(const Area& area, NearestCell position, double cell_area);

/// Replaces the values of the runs by 0, 1, ... in order of appearance; returns the values.
[[nodiscard]] std::vector<std::int64_t> number_values(RunTable& table);

}  // namespace biotope
