#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/climate/environment.hpp"
#include "core/ecosystem/cover.hpp"
#include "core/ecosystem/fitness.hpp"
#include "core/species/species_library.hpp"

namespace biotope {

/// A person's paint on the soil; null where nothing is painted. Texture: final = lerp(computed, value, coverage), clamped
/// to 1..9; geology: the painted class where coverage is at least 0.5.
struct SoilPaint {
  std::shared_ptr<const PaintLayer> texture;
  std::shared_ptr<const PaintLayer> geology;
  bool operator==(const SoilPaint&) const = default;
};
/// Texture of a cell under its paint; where nothing covers it the computed one, to the bit.
[[nodiscard]] inline float painted_texture(float computed, Paint paint) {
  return paint.coverage > 0 ? std::clamp(painted(computed, paint), 1.0F, 9.0F) : computed;
}
/// Geology of a cell under its paint. Values between two classes count as the nearest.
[[nodiscard]] inline Geology painted_geology(Geology computed, Paint paint) {
  if (!(paint.coverage >= 0.5F)) return computed;
  return Geology(int(std::clamp(paint.value, 0.0F, float(geology_classes - 1)) + 0.5F));
}

/// What plants feel: computed maps with a person's paint on the yearly mean of a resource. Paint shifts all months alike
/// (month + coverage * (value - mean)), so the seasons stay; null where nothing is painted.
struct PlantEnvironment {
  std::shared_ptr<const EnvironmentMaps> maps;
  std::array<std::shared_ptr<const PaintLayer>, monthly_resources> paint;
  SoilPaint soil = {};

  /// The twelve months of a resource at a cell, paint included, each clamped to 1..9.
  [[nodiscard]] std::array<float, months> year(Resource resource, int x, int y) const;

  /// Soil of a cell, paint included.
  [[nodiscard]] float texture(int x, int y) const;
  [[nodiscard]] Geology geology(int x, int y) const;

  /// The twelve months of every resource and the soil at a cell.
  [[nodiscard]] CellEnvironment cell(int x, int y) const;
};

/// Competition of the plants of `web` in the cells of one tile, each cell by itself (paper algorithm 2): in every stratum from
/// the tallest down, repeatedly one unit of cover to the fittest species whose needs are still available. (Trees before shrubs
/// before herbs is our choice: light comes from above, so the tall take it first, and what grows under them has their shade.)
/// What a unit takes of light and water shifts the index of every month for all that come after; a stratum's ground is shared
/// (its covers sum to at most 1), and a species crowds itself: its fitness is never more than the ground it has not yet taken, 1
/// - cover. More light and water must be left of the yearly mean index than a unit takes. A plant does not settle below
/// least_fitness. Ties go to species order. `out[i]` receives plant i of web.levels[0]. Does not depend on the tile's borders.
void compete_in_tile(const FoodWeb& web, const PlantEnvironment& environment, const Rect& tile_rect,
                     std::span<CoverMap::Tile* const> out);

/// All tiles of compete_in_tile in parallel.
[[nodiscard]] Result<std::vector<CoverMap>> compete_without_proportions(const FoodWeb& web, const PlantEnvironment& environment,
                                                                        const TaskContext& context = {});

/// Competition over the whole terrain that keeps to desired shares of cover (paper algorithm 1): repeatedly the species whose
/// unit brings the level closest to the target (squared error) is placed in its fittest cell that can still feed it; a species
/// that can no longer be placed sits out, unless another's shade or thirst makes a place for it, and the others go on. Cells are
/// compared by fitness in steps of 1/20, then by row order. Strata share light and water in the order in which units are placed.
/// `desired` sums to 1 over web.levels[0]; a species whose share is 0 is not placed at all. Sequential: about 10 us a cell with
/// 18 plants.
[[nodiscard]] Result<std::vector<CoverMap>> compete_with_proportions(const FoodWeb& web, const PlantEnvironment& environment,
                                                                     std::span<const double> desired,
                                                                     const TaskContext& context = {});

/// Fitness before competition of a plant in every cell. Parallel.
[[nodiscard]] Grid<float> fitness_map(const PlantTraits& plant, const PlantEnvironment& environment);

/// Shares of the level's cover, one per map; zeros when all are empty.
[[nodiscard]] std::vector<double> achieved_shares(std::span<const CoverMap> covers);

}  // namespace biotope
