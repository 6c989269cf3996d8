#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"
#include "core/ecosystem/cover.hpp"
#include "core/ecosystem/places.hpp"
#include "core/ecosystem/run_map.hpp"
#include "core/species/species.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Regions smaller than this hold nobody, m2.
inline constexpr double minimum_region_area = 10000;

/// The same in cells, at least one: on coarse grids a cell is enough.
[[nodiscard]] std::size_t minimum_region_cells(double cell_size);

/// The ground as animals meet it.
struct Ground {
  std::shared_ptr<const Terrain> terrain;
  std::shared_ptr<const Derivatives> derivatives;
  std::shared_ptr<const Hydrology> hydrology;
  /// Sum of tree covers of a cell, 0..full_cover; null before plants are known.
  std::shared_ptr<const Grid<Cover>> tree_cover;
  /// Painted obstacles (final value at least 0.5) and passages (at most -0.5); null: none.
  std::shared_ptr<const PaintLayer> passage = {};
  /// Fords, exits, waypoints and trails a person placed; null: none.
  std::shared_ptr<const Places> places = {};
};

/// Two species with equal limits share their obstacles, regions and travel graph.
struct Mobility {
  float max_slope = 0;
  float wade_depth = 0;
  float max_tree_cover = 0;
  float slope_sensitivity = 0;
  bool operator==(const Mobility&) const = default;
};
[[nodiscard]] Mobility mobility_of(const AnimalTraits& animal);

/// Obstacles do not depend on how slopes tire an animal.
[[nodiscard]] bool same_obstacles(const Mobility& a, const Mobility& b);

/// What keeps an animal out of a cell; the first that applies, paint before all others.
enum class Obstacle : std::uint8_t { none, slope, deep_water, trees, painted };
[[nodiscard]] Obstacle obstacle_at(const Ground& ground, const Mobility& mobility, int x, int y);

/// Whether an animal is kept out of the same cells of both grounds, found without computing them: the same terrain, slopes and
/// water, the same fords and exits, the same painted obstacles and passages, and trees that are on the same side of its limit
/// everywhere.
[[nodiscard]] bool same_blocked_cells(const Ground& a, const Ground& b, const Mobility& mobility);

/// Cells steeper than the limit, water deeper than it wades (unless within a ford), tree cover denser than it pushes through. A
/// ford opens a disk as wide as its river, so that a corridor reaches from bank to bank; one that a person placed opens its
/// radius. A painted passage is open whatever lies there, a painted obstacle closed; within a placed exit nothing blocks.
[[nodiscard]] Grid<std::uint8_t> blocked_cells(const Ground& ground, const Mobility& mobility);

/// Connected components (4-neighbours) of passable cells.
struct ConfinementRegions {
  /// Region of each cell, -1 where blocked or in a region below the minimum area. Regions are numbered by their first cell in row
  /// order.
  RunMap label;
  struct Region {
    std::size_t cells = 0;
    double area = 0;  ///< m2
    Rect bounds;
  };
  std::vector<Region> regions;
  /// Runs of passable cells; null where they are not known.
  std::shared_ptr<const RunTable> passable = nullptr;
};
[[nodiscard]] ConfinementRegions confinement_regions(const Grid<std::uint8_t>& blocked, double cell_size);
/// The same straight from the ground, without the grid between.
[[nodiscard]] ConfinementRegions confinement_regions(const Ground& ground, const Mobility& mobility);
/// By row: whether some animal may be kept out of other cells of one ground than of the other; empty for grounds of different
/// sizes.
[[nodiscard]] std::vector<char> rows_of_other_obstacles(const Ground& a, const Ground& b);
/// The same, with the regions of an earlier ground at hand: rows but those of other obstacles are taken over. Returns the earlier
/// regions themselves where they are the same.
[[nodiscard]] std::shared_ptr<const ConfinementRegions> confinement_regions(
    const Ground& ground, const Mobility& mobility, std::span<const char> other_rows,
    const std::shared_ptr<const ConfinementRegions>& earlier);

/// The finest common partition of several species' regions: two cells are in one piece when every species has them in the same
/// region.
struct Partition {
  /// Piece of each cell, -1 where no species can be.
  RunMap label;
  struct Piece {
    std::size_t cells = 0;
    double area = 0;
    /// Region of each species (order of the regions passed in), -1 where that species cannot be. Pieces are numbered by their
    /// first cell in row order.
    std::vector<int> region;
  };
  std::vector<Piece> pieces;
};
[[nodiscard]] Partition finest_partition(std::span<const std::shared_ptr<const ConfinementRegions>> regions, double cell_size);

}  // namespace biotope
