#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace biotope {

/// A closed interval; both ends belong to it.
struct Range {
  float low = 0;
  float high = 0;
  [[nodiscard]] constexpr bool contains(float value) const { return value >= low && value <= high; }
  bool operator==(const Range&) const = default;
};

/// Layers of vegetation from the tallest down; each shades those after it.
enum class Stratum : std::uint8_t { tree, shrub, herb };
inline constexpr int strata = 3;

/// How the procedural mesh of a plant is built.
struct PlantShape {
  /// Family of mesh: "broadleaf", "conifer", "mountain-pine", "juniper", "shrub", "evergreen-oak", "alder", "birch", "grass", "herb", "flower".
  std::string model = "herb";
  float height = 0.4F;          ///< m, grown
  float crown_diameter = 0.3F;  ///< m
  float trunk_fraction = 0.2F;  ///< bare stem / height
  std::array<float, 3> leaf_colour{0.35F, 0.5F, 0.2F};
  std::array<float, 3> autumn_colour{0.35F, 0.5F, 0.2F};
  std::array<float, 3> flower_colour{0, 0, 0};
  bool evergreen = false;
  bool operator==(const PlantShape&) const = default;
};

/// What a plant needs and gives. Ranges are on the 1..9 index scale (thesis table A.1).
struct PlantTraits {
  Range illumination;
  Range temperature;
  Range moisture;
  Range texture;
  /// Index points taken at full cover.
  float light_consumption = 0;
  float water_consumption = 0;
  /// Viability 0..1 by geology class: limestone, water, marl, scree, alluvium.
  std::array<float, 5> geology{1, 0, 1, 1, 1};
  Stratum stratum = Stratum::herb;
  /// Cover of one population unit.
  float unit_cover = 0.05F;
  /// Yearly growth that animals can reach and eat at full cover, kg dry matter / (m2 year).
  float growth = 0.1F;
  /// "riparian", "ubiquitous", "mediterranean" or "mountain".
  std::string biome = "ubiquitous";
  PlantShape shape;
  bool operator==(const PlantTraits&) const = default;
};

enum class Activity : std::uint8_t { diurnal, crepuscular, nocturnal, cathemeral };

/// One thing of a need: a species' name or a group ("herbs", "shrubs", "trees", "plants", "herbivores", "carnivores", "animals").
struct Food {
  std::string name;
  /// Relative preference, > 0.
  float preference = 1;
  bool operator==(const Food&) const = default;
};

/// Something an animal must have; foods of one need replace each other, needs do not.
struct Need {
  std::string name;
  std::vector<Food> foods;
  /// kg dry matter of plants, or kg of prey, per animal and day.
  float amount = 0;
  bool operator==(const Need&) const = default;
};

/// How an animal is drawn.
struct AnimalShape {
  /// "bovid", "deer", "horse", "goat", "sheep", "bear", "wolf", "cat", "fox", "boar", "rhino".
  std::string model = "deer";
  float shoulder_height = 1;  ///< m
  float body_length = 1.5F;   ///< m
  std::array<float, 3> coat_colour{0.45F, 0.35F, 0.25F};
  std::array<float, 3> belly_colour{0.6F, 0.5F, 0.4F};
  /// "none", "antlers", "palmate", "horns", "curled".
  std::string headgear = "none";
  bool operator==(const AnimalShape&) const = default;
};

/// What an animal needs and can do.
struct AnimalTraits {
  int herd_min = 1;
  int herd_max = 1;
  float mass_min = 50;  ///< kg
  float mass_max = 50;
  float speed = 1.4F;  ///< walking on flat ground, m/s
  /// Steepest ground it walks, rise / run.
  float max_slope = 0.5F;
  /// k of v = v0 exp(-k (|S + 0.05| - 0.05)).
  float slope_sensitivity = 3.5F;
  /// Deepest water it wades, m.
  float wade_depth = 0.6F;
  /// Densest tree cover it pushes through, 0..1.
  float max_tree_cover = 0.6F;
  Activity activity = Activity::diurnal;
  /// Hours it must drink a day; at least once when > 0.
  int water_visits = 2;
  /// New animals per animal and year.
  float growth_rate = 0.2F;
  std::vector<Need> diet;
  AnimalShape shape;
  [[nodiscard]] float mean_mass() const { return 0.5F * (mass_min + mass_max); }
  bool operator==(const AnimalTraits&) const = default;
};

/// One species of plant or animal.
struct Species {
  /// Unique short name in files and on the command line: lower case, digits and '-', e.g. "pinus-mugo".
  std::string name;
  std::string scientific_name;
  std::string common_name;
  std::array<float, 3> colour{0.5F, 0.5F, 0.5F};
  std::variant<PlantTraits, AnimalTraits> traits;
  /// Desired share of its level by climate name or "default"; compared after normalising over the level. Absent: none asked.
  std::map<std::string, double> proportions;
  /// Where values come from, by key: "illumination" -> "thesis table A.1".
  std::map<std::string, std::string> sources;

  [[nodiscard]] bool is_plant() const { return std::holds_alternative<PlantTraits>(traits); }
  [[nodiscard]] const PlantTraits& plant() const { return std::get<PlantTraits>(traits); }
  [[nodiscard]] const AnimalTraits& animal() const { return std::get<AnimalTraits>(traits); }
  bool operator==(const Species&) const = default;
};

}  // namespace biotope
