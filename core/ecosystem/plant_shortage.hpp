#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/warning.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

/// Paint of a plant where it cannot live: kept, but told.
struct PlantShortage {
  int species = 0;  ///< number in the food web
  double area = 0;  ///< m2 of ground painted over although nothing of the species could settle there
  int x = 0;        ///< a cell in the middle of it
  int y = 0;
  LimitingFactor limiting = LimitingFactor::none;  ///< of most of the area
  /// Coverage 1 there.
  std::shared_ptr<const PaintLayer> where;
};

/// Least painted cover that counts as a plant being there.
inline constexpr float told_cover = 0.05F;

/// Where each plant of web.levels[0] was painted (final cover at least told_cover) although its fitness before competition is
/// below least_fitness. `paint` and `covers` are in the order of the level; plants without paint have none. At most about 50 000
/// cells a plant are looked at, evenly over its painted tiles: squares of cells then stand for one. Parallel over plants.
[[nodiscard]] std::vector<PlantShortage> plant_shortages(const FoodWeb& web, const PlantEnvironment& environment,
                                                         std::span<const std::shared_ptr<const CoverMap>> covers,
                                                         std::span<const std::shared_ptr<const PaintLayer>> paint,
                                                         double cell_size);

/// "Oak: painted over 3.2 ha where the moisture does not suit it (near x 1200 m, y 340 m)".
[[nodiscard]] Warning shortage_warning(const FoodWeb& web, const Terrain& terrain, const PlantShortage& shortage);

}  // namespace biotope
