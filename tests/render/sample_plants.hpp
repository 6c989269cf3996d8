#pragma once

#include <catch2/catch.hpp>
#include <memory>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope::test {

inline constexpr int cells = 128;
inline constexpr double cell_size = 4;

inline Species plant(const std::string& name, Stratum stratum, const std::string& model, float height, float crown) {
  PlantTraits traits;
  traits.stratum = stratum;
  traits.shape.model = model;
  traits.shape.height = height;
  traits.shape.crown_diameter = crown;
  Species species;
  species.name = name;
  species.traits = traits;
  return species;
}

/// Level ground of 512 m a side on which an oak, a pine, a shrub and a grass may grow; nothing covers it yet.
inline std::shared_ptr<MapsSnapshot> level_landscape() {
  auto terrain = std::make_shared<Terrain>();
  terrain->height = Grid<float>(cells, cells, 100);
  terrain->cell_size = cell_size;
  auto snapshot = std::make_shared<MapsSnapshot>();
  snapshot->document.terrain = terrain;
  snapshot->document.seed = 7;
  auto web =
      build_food_web({plant("oak", Stratum::tree, "broadleaf", 16, 12), plant("pine", Stratum::tree, "conifer", 17, 7),
                      plant("gorse", Stratum::shrub, "shrub", 2, 2.2F), plant("grass", Stratum::herb, "grass", 0.6F, 0.35F)});
  REQUIRE(web);
  snapshot->web = std::make_shared<const FoodWeb>(std::move(*web));
  for (int i = 0; i < 4; ++i) snapshot->cover.push_back(std::make_shared<const CoverMap>(cells, cells, Cover(0)));
  return snapshot;
}

/// Covers the cells of `rect` with species `index` of the landscape.
inline void cover(MapsSnapshot& snapshot, std::size_t index, const Rect& rect, float fraction) {
  CoverMap map = *snapshot.cover[index];
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) map.set(x, y, to_cover(fraction));
  }
  snapshot.cover[index] = std::make_shared<const CoverMap>(std::move(map));
}

/// Covers everything.
inline void cover(MapsSnapshot& snapshot, std::size_t index, float fraction) {
  cover(snapshot, index, {0, 0, cells, cells}, fraction);
}

/// A straight river over columns [x0, x1).
inline std::shared_ptr<const Hydrology> river(int x0, int x1) {
  auto water = std::make_shared<Hydrology>();
  water->filled = Grid<float>(cells, cells, 100);
  water->catchment_area = Grid<float>(cells, cells, 0);
  water->water_depth = Grid<float>(cells, cells, 0);
  water->discharge = Grid<float>(cells, cells, 0);
  water->water = Grid<WaterKind>(cells, cells, WaterKind::dry);
  water->receiver = Grid<std::uint8_t>(cells, cells, 8);
  for (int y = 0; y < cells; ++y) {
    for (int x = x0; x < x1; ++x) {
      water->water_depth(x, y) = 0.8F;
      water->water(x, y) = WaterKind::river;
    }
  }
  // Width is 4.5 sqrt(Q).
  const float width = float(x1 - x0) * float(cell_size) / 4.5F;
  RiverReach reach;
  reach.discharge = width * width;
  for (int y = 0; y < cells; ++y) {
    reach.cells.push_back(std::uint32_t(y * cells + (x0 + x1) / 2));
    water->discharge[reach.cells.back()] = reach.discharge;
  }
  reach.width = float(x1 - x0) * float(cell_size);
  reach.depth = 0.8F;
  water->reaches.push_back(reach);
  return water;
}

}  // namespace biotope::test
