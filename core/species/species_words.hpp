#pragma once

#include <array>
#include <span>
#include <string>

namespace biotope {

// The words a species file may use, in the order of the enumerations or arrays they name.

/// Strata from the tallest down, as in Stratum.
[[nodiscard]] std::span<const std::string> stratum_words();
/// Activities, as in Activity.
[[nodiscard]] std::span<const std::string> activity_words();
/// Geology classes, as in PlantTraits::geology.
[[nodiscard]] std::span<const std::string> geology_words();
/// PlantTraits::biome.
[[nodiscard]] std::span<const std::string> biome_words();
/// PlantShape::model.
[[nodiscard]] std::span<const std::string> plant_models();
/// AnimalShape::model.
[[nodiscard]] std::span<const std::string> animal_models();
/// AnimalShape::headgear.
[[nodiscard]] std::span<const std::string> headgear_words();
/// Groups of species that a diet may name.
[[nodiscard]] std::span<const std::string> group_words();

}  // namespace biotope
