#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/ecosystem/animal_level.hpp"
#include "core/ecosystem/confinement.hpp"

namespace biotope::test {

/// Flat, dry, treeless ground that a test then shapes.
struct Landscape {
  Terrain terrain;
  Derivatives derivatives;
  Hydrology hydrology;
  Grid<Cover> trees;

  explicit Landscape(int width, int height, double cell_size = 100) {
    terrain.height = Grid<float>(width, height, 100.0F);
    terrain.cell_size = cell_size;
    derivatives.slope = Grid<float>(width, height);
    hydrology.water_depth = Grid<float>(width, height);
    hydrology.discharge = Grid<float>(width, height);
    hydrology.water = Grid<WaterKind>(width, height, WaterKind::dry);
    trees = Grid<Cover>(width, height);
  }

  void cliff_column(int x, float slope = 2) {
    for (int y = 0; y < terrain.height.height(); ++y) derivatives.slope(x, y) = slope;
  }
  void river_column(int x, float depth, float discharge = 1) {
    for (int y = 0; y < terrain.height.height(); ++y) {
      hydrology.water(x, y) = WaterKind::river;
      hydrology.water_depth(x, y) = depth;
      hydrology.discharge(x, y) = discharge;
    }
  }
  /// A brook that any animal steps over.
  void brook_row(int y) {
    for (int x = 0; x < terrain.height.width(); ++x) hydrology.discharge(x, y) = 0.02F;
  }

  [[nodiscard]] Ground ground() const {
    return {std::make_shared<const Terrain>(terrain), std::make_shared<const Derivatives>(derivatives),
            std::make_shared<const Hydrology>(hydrology), std::make_shared<const Grid<Cover>>(trees)};
  }
};

/// A food web built by hand; foods are named by species.
class WebBuilder {
 public:
  int plant(const std::string& name, float growth, Stratum stratum = Stratum::herb) {
    PlantTraits traits;
    traits.growth = growth;
    traits.stratum = stratum;
    return add(named(name, traits), 0, {});
  }
  struct Diet {
    std::string need;
    std::vector<int> foods;
    float kilograms_per_day = 1;
    std::vector<float> preferences = {};
  };
  int animal(const std::string& name, int level, AnimalTraits traits, const std::vector<Diet>& diet) {
    std::vector<FoodWeb::ResolvedNeed> needs;
    for (const Diet& own : diet) {
      Need need{own.need, {}, own.kilograms_per_day};
      for (const int food : own.foods) need.foods.push_back({web.species[std::size_t(food)].name, 1});
      traits.diet.push_back(need);
      needs.push_back({own.foods, own.preferences, own.kilograms_per_day});
      if (own.preferences.empty()) needs.back().preferences.assign(own.foods.size(), 1.0F);
    }
    return add(named(name, traits), level, std::move(needs));
  }
  FoodWeb web;

 private:
  static Species named(const std::string& name, std::variant<PlantTraits, AnimalTraits> traits) {
    Species species;
    species.name = name;
    species.traits = std::move(traits);
    return species;
  }
  int add(Species species, int level, std::vector<FoodWeb::ResolvedNeed> diet) {
    const int number = int(web.species.size());
    web.species.push_back(std::move(species));
    web.level.push_back(level);
    web.diets.push_back(std::move(diet));
    if (web.levels.size() <= std::size_t(level)) web.levels.resize(std::size_t(level) + 1);
    web.levels[std::size_t(level)].push_back(number);
    return number;
  }
};

/// Everything a test computes levels from.
struct Scene {
  Landscape land;
  FoodWeb web;
  std::vector<std::shared_ptr<const CoverMap>> plants;
  std::vector<std::shared_ptr<const AnimalLevel>> levels;

  Scene(Landscape landscape, FoodWeb food_web) : land(std::move(landscape)), web(std::move(food_web)) {
    for (std::size_t i = 0; i < web.levels[0].size(); ++i) cover(i, full_cover);
  }
  /// The same cover of a plant everywhere.
  void cover(std::size_t plant, int value) {
    const auto& height = land.terrain.height;
    if (plants.size() <= plant) plants.resize(plant + 1);
    plants[plant] = std::make_shared<const CoverMap>(CoverMap(height.width(), height.height(), Cover(value)));
  }
  void cover(std::size_t plant, const Grid<Cover>& grid) { plants[plant] = std::make_shared<const CoverMap>(tiled(grid)); }

  std::shared_ptr<const AnimalLevel> solve(int level, std::vector<double> desired = {},
                                           std::vector<std::shared_ptr<const PaintLayer>> paint = {}) const {
    const AnimalLevelInput input{web, level, land.ground(), plants, levels, std::move(desired), std::move(paint), {}, 1};
    auto result = compute_animal_level(input);
    REQUIRE(result);
    return std::make_shared<const AnimalLevel>(std::move(*result));
  }
};

inline double total(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

/// Whether two levels agree to the bit.
inline bool same_level(const AnimalLevel& a, const AnimalLevel& b) {
  if (a.partition->label != b.partition->label || a.population != b.population || a.eaten != b.eaten || a.warnings != b.warnings)
    return false;
  if (a.herds.size() != b.herds.size() || a.graph->nodes.size() != b.graph->nodes.size()) return false;
  for (std::size_t i = 0; i < a.herds.size(); ++i) {
    if (a.herds[i].size != b.herds[i].size || a.herds[i].region != b.herds[i].region) return false;
  }
  for (std::size_t i = 0; i < a.graph->nodes.size(); ++i) {
    const ResourceNode& x = a.graph->nodes[i];
    const ResourceNode& y = b.graph->nodes[i];
    if (x.x != y.x || x.y != y.y || x.cells != y.cells || x.quantities.size() != y.quantities.size()) return false;
    for (std::size_t q = 0; q < x.quantities.size(); ++q) {
      if (x.quantities[q].available != y.quantities[q].available) return false;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (*a.graph->node_of_cell[i] != *b.graph->node_of_cell[i]) return false;
  }
  return true;
}

inline std::shared_ptr<const PaintLayer> paint_rect(int width, int height, const Rect& rect, float value, float coverage = 1) {
  PaintLayer layer(width, height);
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) layer.set(x, y, {value, coverage});
  }
  return std::make_shared<const PaintLayer>(std::move(layer));
}

/// An animal that walks up to slope 0.5, wades 0.5 m and forms herds of one size.
inline AnimalTraits walker(int herd = 10, int largest = 0) {
  AnimalTraits traits;
  traits.herd_min = herd;
  traits.herd_max = largest > 0 ? largest : herd;
  traits.max_slope = 0.5F;
  traits.wade_depth = 0.5F;
  traits.max_tree_cover = 0.6F;
  traits.water_visits = 2;
  traits.mass_min = traits.mass_max = 100;
  traits.growth_rate = 0.2F;
  return traits;
}

}  // namespace biotope::test
