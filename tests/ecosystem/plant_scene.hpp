#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/ecosystem/plant_competition.hpp"

/// Small landscapes and floras made by hand for the tests of plants.
namespace biotope::plant_scene {

using Year = std::array<float, months>;

/// The same index in all months.
inline Year constant(float value) {
  Year year{};
  year.fill(value);
  return year;
}

/// An environment of explicit cells.
struct Scene {
  Scene(int width, int height) : width_(width), height_(height) {
    for (auto& resource : values_) resource.assign(months, Grid<float>(width, height, 5));
    texture_ = Grid<float>(width, height, 5);
    geology_ = Grid<Geology>(width, height, Geology::limestone);
  }
  void set(Resource resource, int x, int y, const Year& year) {
    for (std::size_t m = 0; m < months; ++m) values_[std::size_t(resource)][m](x, y) = year[m];
  }
  void fill(Resource resource, const Year& year) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) set(resource, x, y, year);
    }
  }
  Grid<float>& texture() { return texture_; }
  Grid<Geology>& geology() { return geology_; }

  [[nodiscard]] PlantEnvironment environment() const {
    auto maps = std::make_shared<EnvironmentMaps>();
    for (std::size_t r = 0; r < monthly_resources; ++r) {
      for (const Grid<float>& layer : values_[r]) {
        maps->monthly[r].layers.push_back(std::make_shared<const Grid<float>>(layer));
      }
    }
    maps->texture = std::make_shared<const Grid<float>>(texture_);
    maps->geology = std::make_shared<const Grid<Geology>>(geology_);
    return PlantEnvironment{maps, {}, {}};
  }

 private:
  int width_;
  int height_;
  std::array<std::vector<Grid<float>>, monthly_resources> values_;
  Grid<float> texture_;
  Grid<Geology> geology_;
};

/// A plant that is content with everything and takes nothing.
inline PlantTraits easy_plant(Stratum stratum = Stratum::herb) {
  PlantTraits plant;
  plant.illumination = plant.temperature = plant.moisture = plant.texture = {1, 9};
  plant.geology = {1, 1, 1, 1, 1};
  plant.stratum = stratum;
  return plant;
}

inline FoodWeb web_of(std::vector<std::pair<std::string, PlantTraits>> plants) {
  FoodWeb web;
  web.levels.resize(1);
  for (auto& [name, traits] : plants) {
    web.levels[0].push_back(int(web.species.size()));
    web.level.push_back(0);
    Species species;
    species.name = name;
    species.scientific_name = name;
    species.common_name = name;
    species.traits = traits;
    web.species.push_back(std::move(species));
    web.diets.emplace_back();
  }
  return web;
}

/// One row of the thesis's table A.1: ranges and consumptions, viability by geology.
inline std::pair<std::string, PlantTraits> flora_row(std::string name, Stratum stratum, Range light, float light_taken,
                                                     Range warmth, Range water, float water_taken, Range texture,
                                                     std::array<float, 5> geology = {1, 0, 1, 1, 1}) {
  PlantTraits plant;
  plant.stratum = stratum;
  plant.illumination = light;
  plant.light_consumption = light_taken;
  plant.temperature = warmth;
  plant.moisture = water;
  plant.water_consumption = water_taken;
  plant.texture = texture;
  plant.geology = geology;
  return {std::move(name), plant};
}

/// The 18 plants of the thesis's table A.1; strata are ours.
inline FoodWeb thesis_flora() {
  using enum Stratum;
  return web_of({
      flora_row("Cupressaceae", shrub, {7, 9}, 2, {2, 9}, {2, 4}, 2, {2, 8}),
      flora_row("Pinus", tree, {7, 9}, 5, {6, 9}, {2, 5}, 3, {1, 7}),
      flora_row("Pistacia", shrub, {7, 9}, 2, {7, 9}, {3, 4}, 2, {3, 4}),
      flora_row("Alnus", tree, {7, 9}, 5, {2, 8}, {4, 8}, 5, {1, 4}, {0, 0.8F, 0, 0, 1}),
      flora_row("Apiaceae", herb, {3, 9}, 0.2F, {1, 9}, {2, 6}, 0.2F, {1, 7}),
      flora_row("Cichorium", herb, {7, 9}, 0.2F, {6, 9}, {4, 6}, 0.2F, {3, 4}),
      flora_row("Poaceae", herb, {5, 9}, 0.2F, {1, 9}, {1, 8}, 0.2F, {1, 9}),
      flora_row("Asteraceae", herb, {4, 9}, 0.2F, {3, 9}, {1, 7}, 0.2F, {1, 8}),
      flora_row("Quercus", tree, {7, 9}, 5, {5, 8}, {3, 6}, 5, {2, 5}),
      flora_row("Artemisia", herb, {7, 9}, 0.2F, {2, 5}, {2, 8}, 0.2F, {2, 6}),
      flora_row("Betula", tree, {7, 9}, 3, {3, 5}, {4, 7}, 3, {1, 6}),
      flora_row("Carpinus", tree, {6, 7}, 5, {6, 7}, {4, 5}, 4, {3, 4}),
      flora_row("Corylus", shrub, {5, 6}, 4, {5, 6}, {4, 5}, 4, {3, 4}),
      flora_row("Plantago", herb, {5, 9}, 0.2F, {1, 9}, {2, 7}, 0.2F, {2, 5}),
      flora_row("Pinus mugo", shrub, {7, 9}, 3, {2, 4}, {3, 7}, 3, {2, 7}),
      flora_row("Quercus ilex", tree, {7, 9}, 4, {7, 9}, {4, 7}, 4, {2, 6}),
      flora_row("Rubiaceae", herb, {3, 9}, 0.2F, {2, 9}, {2, 6}, 0.2F, {1, 9}),
      flora_row("Fabaceae", herb, {6, 9}, 0.2F, {2, 9}, {2, 6}, 0.2F, {2, 8}),
  });
}

}  // namespace biotope::plant_scene
