#include "core/ecosystem/animal_warnings.hpp"

#include <cmath>
#include <numeric>

#include "core/ecosystem/animal_needs.hpp"
#include "core/terrain/ground_coordinates.hpp"

namespace biotope {
namespace {

/// Middle of the animals that paint added, or of the region.
PathPoint middle_of(const Settlement& place, const PaintedPopulation& paint, const AnimalLevel& level) {
  const auto& added = paint.added[std::size_t(place.region)];
  const Rect& bounds = level.regions[std::size_t(place.species_index)]->regions[std::size_t(place.region)].bounds;
  if (added.individuals <= 0) return {float((bounds.x0 + bounds.x1) / 2), float((bounds.y0 + bounds.y1) / 2)};
  return {float(std::lround(added.sum_x / added.individuals)), float(std::lround(added.sum_y / added.individuals))};
}

std::string near(const AnimalLevel& level, PathPoint place) {
  return near_text(*level.basis.ground.terrain, double(place.x), double(place.y));
}

}  // namespace

void record_shortages(const FoodWeb& web, const Settlement& place, std::span<const YearlyNeed> needs, const Meal& meal,
                      const PaintedPopulation& paint, AnimalLevel& level) {
  const int species = level.species[std::size_t(place.species_index)];
  const std::string name = display_name(web, species);
  const PathPoint middle = middle_of(place, paint, level);
  const std::string where = " in region " + std::to_string(place.region) + " " + near(level, middle);
  if (!place.has_water) {
    level.shortages.push_back({species, place.region, "water", 0});
    level.warnings.push_back({name + ": no water to drink" + where, species, middle});
  }
  for (std::size_t i = 0; i < needs.size(); ++i) {
    const double missing = meal.missing[i];
    if (missing <= 0) continue;
    level.shortages.push_back({species, place.region, needs[i].name, missing});
    const double met = needs[i].kilograms * place.population - missing;
    const double percent = met > 0 ? 100 * missing / met : 0;
    const std::string amount = percent <= 0 ? "painted where no " + needs[i].name + " grows,"
                               : percent <= 1000
                                   ? number_text(percent) + " % more " + needs[i].name + " asked than grows"
                                   : number_text(missing) + " kg a year more " + needs[i].name + " asked than grows";
    level.warnings.push_back({name + ": " + amount + where, species, middle, missing, "kg/yr"});
  }
}

void warn_of_uninhabitable_paint(const FoodWeb& web, int species, const PaintedPopulation& paint, AnimalLevel& level) {
  if (paint.uninhabitable_cells == 0) return;
  const PathPoint first{float(paint.uninhabitable_x), float(paint.uninhabitable_y)};
  const std::string cells = std::to_string(paint.uninhabitable_cells) + (paint.uninhabitable_cells == 1 ? " cell" : " cells");
  level.warnings.push_back({display_name(web, species) + ": painted on " + cells + " that it cannot reach " + near(level, first),
                            species, first, double(paint.uninhabitable_cells), "cells"});
}

void warn_of_scarce_species(const FoodWeb& web, int species_index, AnimalLevel& level) {
  if (species_index < 0) return;
  const auto& regions = level.computed_population[std::size_t(species_index)];
  const int species = level.species[std::size_t(species_index)];
  level.warnings.push_back({display_name(web, species) + ": finds no place for more than " +
                                number_text(std::accumulate(regions.begin(), regions.end(), 0.0)) +
                                "; to keep to its share the others stay fewer than the land could feed",
                            species});
}

void warn_of_absent_species(const FoodWeb& web, AnimalLevel& level) {
  for (std::size_t i = 0; i < level.species.size(); ++i) {
    const auto& regions = level.computed_population[i];
    const bool asked = level.desired.empty() || level.desired[i] > 0;
    if (!asked || std::accumulate(regions.begin(), regions.end(), 0.0) > 0) continue;
    const int species = level.species[i];
    level.warnings.push_back({display_name(web, species) + ": " + absence_reason(web, level, i), species});
  }
}

}  // namespace biotope
