#pragma once

#include <memory>
#include <span>

#include "core/base/grid.hpp"
#include "core/ecosystem/animal_level.hpp"

namespace biotope {

// `loss` is paint of the species' share of growth lost to an external event (0..1 x coverage); null: none is lost. An animal's
// loss is the mean over its region.

/// What is left of a plant's yearly growth after every level that eats it: kg dry matter / (m2 year) in every cell. Parallel.
[[nodiscard]] Grid<float> plant_surplus(const FoodWeb& web, int plant, const CoverMap& cover,
                                        std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                        const PaintLayer* loss = nullptr);

/// What is left of an animal's yearly growth after its predators: individuals / (km2 year), uniform over each region.
[[nodiscard]] Grid<float> animal_surplus(const FoodWeb& web, int species, const AnimalLevel& own_level,
                                         std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                         const PaintLayer* loss = nullptr);

/// Totals over the map: kg / year for a plant, individuals / year for an animal.
struct SurplusTotal {
  double growth = 0;
  double eaten = 0;
  [[nodiscard]] double surplus() const { return growth - eaten; }
};
[[nodiscard]] SurplusTotal surplus_total(const FoodWeb& web, int species, const CoverMap* cover, double cell_area,
                                         std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                         const PaintLayer* loss = nullptr);

}  // namespace biotope
