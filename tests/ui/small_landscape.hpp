#pragma once

#include <memory>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// A landscape of 70 x 66 cells made by hand: a plane that rises to the east, one grass, one deer in two regions split by
/// column 40.
inline std::shared_ptr<MapsSnapshot> small_landscape() {
  constexpr int width = 70;
  constexpr int height = 66;
  auto terrain = std::make_shared<Terrain>();
  terrain->height = Grid<float>(width, height);
  terrain->cell_size = 10;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) terrain->height(x, y) = float(x);
  }
  auto web = std::make_shared<FoodWeb>();
  Species grass;
  grass.name = "grass";
  grass.common_name = "Grass";
  Species deer;
  deer.name = "deer";
  deer.scientific_name = "Cervus";
  deer.traits = AnimalTraits{};
  web->species = {grass, deer};
  web->level = {0, 1};
  web->levels = {{0}, {1}};
  web->diets.resize(2);
  CoverMap cover(width, height, 0);
  cover.set(3, 4, 120);
  auto level = std::make_shared<AnimalLevel>();
  level->species = {1};
  auto regions = std::make_shared<ConfinementRegions>();
  Grid<std::int32_t> label(width, height, 0);
  regions->regions.resize(2);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) label(x, y) = x < 40 ? 0 : x == 40 ? -1 : 1;
  }
  regions->label = RunMap(label);
  regions->regions[0].area = 40 * height * 100.0;
  regions->regions[1].area = 29 * height * 100.0;
  level->regions = {regions};
  level->computed_population = {{12, 0}};
  level->population = {{12, 0}};
  level->eaten = {{0}, {0}};
  auto snapshot = std::make_shared<MapsSnapshot>();
  snapshot->revision = 1;
  snapshot->document_revision = 1;
  snapshot->complete = true;
  snapshot->document.terrain = terrain;
  snapshot->web = web;
  snapshot->computed_cover = {std::make_shared<CoverMap>(cover)};
  snapshot->cover = snapshot->computed_cover;
  snapshot->plant_achieved = {1};
  snapshot->animals = {level};
  return snapshot;
}

}  // namespace biotope
