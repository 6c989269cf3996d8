#pragma once

#include <span>

#include "core/ecosystem/animal_competition.hpp"
#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/animal_paint.hpp"

namespace biotope {

/// Records what an incomplete meal of painted animals lacks, and missing water, with a warning that names species, place and
/// resource.
void record_shortages(const FoodWeb& web, const Settlement& place, std::span<const YearlyNeed> needs, const Meal& meal,
                      const PaintedPopulation& paint, AnimalLevel& level);

/// Animals painted where the species has no region.
void warn_of_uninhabitable_paint(const FoodWeb& web, int species, const PaintedPopulation& paint, AnimalLevel& level);

/// The species that held the others back (index in the level; -1 when none did).
void warn_of_scarce_species(const FoodWeb& web, int species_index, AnimalLevel& level);

/// Species that found no place, with the reason.
void warn_of_absent_species(const FoodWeb& web, AnimalLevel& level);

}  // namespace biotope
