#include "core/species/species_words.hpp"

namespace biotope {

std::span<const std::string> stratum_words() {
  static const std::array<std::string, 3> words{"tree", "shrub", "herb"};
  return words;
}

std::span<const std::string> activity_words() {
  static const std::array<std::string, 4> words{"diurnal", "crepuscular", "nocturnal", "cathemeral"};
  return words;
}

std::span<const std::string> geology_words() {
  static const std::array<std::string, 5> words{"limestone", "water", "marl", "scree", "alluvium"};
  return words;
}

std::span<const std::string> biome_words() {
  static const std::array<std::string, 4> words{"riparian", "ubiquitous", "mediterranean", "mountain"};
  return words;
}

std::span<const std::string> plant_models() {
  static const std::array<std::string, 11> words{"broadleaf", "conifer", "mountain-pine", "juniper", "shrub", "evergreen-oak",
                                                 "alder",     "birch",   "grass",         "herb",    "flower"};
  return words;
}

std::span<const std::string> animal_models() {
  static const std::array<std::string, 11> words{"bovid", "deer", "horse", "goat", "sheep", "bear",
                                                 "wolf",  "cat",  "fox",   "boar", "rhino"};
  return words;
}

std::span<const std::string> headgear_words() {
  static const std::array<std::string, 5> words{"none", "antlers", "palmate", "horns", "curled"};
  return words;
}

std::span<const std::string> group_words() {
  static const std::array<std::string, 7> words{"herbs",      "shrubs",     "trees",  "plants",
                                                "herbivores", "carnivores", "animals"};
  return words;
}

}  // namespace biotope
