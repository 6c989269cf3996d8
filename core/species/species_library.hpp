#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.hpp"
#include "core/species/species.hpp"

namespace biotope {

/// A food web: species ordered by level, then as listed. Level 0 are the plants; an animal's level is one more than the
/// highest level it eats.
struct FoodWeb {
  std::vector<Species> species;
  /// Level of each species.
  std::vector<int> level;
  /// Species numbers of each level.
  std::vector<std::vector<int>> levels;
  /// For every species, need and food: the species numbers that can meet it, in order, with preference.
  struct ResolvedNeed {
    std::vector<int> foods;
    std::vector<float> preferences;
    float amount = 0;  ///< kg per animal and day
  };
  std::vector<std::vector<ResolvedNeed>> diets;

  [[nodiscard]] int find(std::string_view name) const;  ///< -1 when there is none
  [[nodiscard]] int level_count() const { return int(levels.size()); }
};

/// Reads and validates species from JSON text: an object {"species": [...]}. Messages name `origin` (a file), species, key, and
/// what was expected.
[[nodiscard]] Result<std::vector<Species>> parse_species(std::string_view json, std::string_view origin);
[[nodiscard]] Result<std::vector<Species>> load_species(const std::filesystem::path& file);
[[nodiscard]] std::string species_to_json(const std::vector<Species>& species);

/// Orders species into levels and resolves diets. A diet cycle, an unknown food or two species of one name are Errors that name
/// them. A need whose group has no member in the list is an Error too.
[[nodiscard]] Result<FoodWeb> build_food_web(std::vector<Species> species);

/// Desired shares of a level's species under a climate (proportions[climate], else proportions["default"]), normalised to
/// sum 1; empty when no species of the level asks for one. A species that asks for a share under other climates only gets 0. Who
/// asks for none at all is not driven out by those who do: up to a sum of 1 shares are parts of the whole, and the silent divide
/// the rest evenly; beyond it they are weights, and each silent species weighs as much as the others on average.
[[nodiscard]] std::vector<double> desired_proportions(const FoodWeb& web, int level, std::string_view climate);

}  // namespace biotope
