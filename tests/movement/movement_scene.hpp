#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/movement/daily_plan.hpp"

namespace biotope::test {

/// A landscape, a food web and animal levels laid out by hand. Species 0 is a grass; animals follow.
struct MovementScene {
  FoodWeb web;
  Ground ground;
  Grid<std::uint8_t> blocked;
  std::vector<std::shared_ptr<const AnimalLevel>> levels;
  std::vector<LevelMovement> movement;

  MovementScene(int width, int height, double cell_size, const std::function<float(int, int)>& elevation = [](int, int) { return 0.0F; })
      : blocked(width, height) {
    Terrain terrain;
    terrain.cell_size = cell_size;
    terrain.height = Grid<float>(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) terrain.height(x, y) = elevation(x, y);
    }
    Hydrology hydrology;
    hydrology.water_depth = Grid<float>(width, height);
    ground.terrain = std::make_shared<const Terrain>(std::move(terrain));
    ground.hydrology = std::make_shared<const Hydrology>(std::move(hydrology));
    Species grass;
    grass.name = "grass";
    grass.traits = PlantTraits{};
    web.species.push_back(grass);
    web.level = {0};
    web.levels = {{0}};
    web.diets.resize(1);
  }

  int animal(const std::string& name, int level, AnimalTraits traits, const std::vector<int>& foods) {
    const int number = int(web.species.size());
    Species species;
    species.name = name;
    species.traits = std::move(traits);
    web.species.push_back(std::move(species));
    web.level.push_back(level);
    if (web.levels.size() <= std::size_t(level)) web.levels.resize(std::size_t(level) + 1);
    web.levels[std::size_t(level)].push_back(number);
    web.diets.push_back({{foods, std::vector<float>(foods.size(), 1.0F), 5.0F}});
    return number;
  }

  static ResourceNode node(NodeKind kind, int x, int y, double area, double kilograms, int group = 0) {
    ResourceNode result;
    result.kind = kind;
    result.group = group;
    result.x = x;
    result.y = y;
    result.centroid_x = float(x);
    result.centroid_y = float(y);
    result.area = area;
    result.bounds = {x, y, x + 1, y + 1};
    if (kind == NodeKind::vegetation) result.quantities = {{0, kilograms}};
    if (kind == NodeKind::prey) {
      result.quantities = {{group, kilograms}};
      result.prey_region = 0;
    }
    return result;
  }

  /// A level whose species share the obstacles of `blocked`; every region holds `population` of each species.
  AnimalLevel level(int number, const std::vector<ResourceNode>& nodes, double population = 100) const {
    AnimalLevel result;
    result.level = number;
    result.species = web.levels[std::size_t(number)];
    const auto regions = std::make_shared<const ConfinementRegions>(confinement_regions(blocked, ground.terrain->cell_size));
    for (std::size_t i = 0; i < result.species.size(); ++i) {
      result.regions.push_back(regions);
      result.population.emplace_back(regions->regions.size(), population);
    }
    result.computed_population = result.population;
    result.partition = std::make_shared<const Partition>(finest_partition(result.regions, ground.terrain->cell_size));
    GraphLevel graph;
    graph.level = number;
    graph.nodes = nodes;
    for (ResourceNode& place : graph.nodes) place.piece = result.partition->label(place.x, place.y);
    result.graph = std::make_shared<const GraphLevel>(std::move(graph));
    return result;
  }

  void add(AnimalLevel level) {
    levels.push_back(std::make_shared<const AnimalLevel>(std::move(level)));
    auto result = compute_level_movement(web, *levels.back(), ground);
    REQUIRE(result);
    movement.push_back(std::move(*result));
  }

  [[nodiscard]] TrailNetwork trails() const {
    return trails(nullptr);
  }
  [[nodiscard]] TrailNetwork trails(MovementCache* cache) const {
    auto result = compute_trails(web, levels, movement, ground, {}, cache);
    REQUIRE(result);
    return std::move(*result);
  }
  [[nodiscard]] std::vector<DailyPlan> plans(std::uint64_t seed = 1) const {
    auto result = compute_daily_plans(web, levels, movement, ground, seed);
    REQUIRE(result);
    return std::move(*result);
  }
  [[nodiscard]] std::vector<DailyPlan> plans_on(const TrailNetwork& network) const {
    auto result = compute_daily_plans(web, levels, movement, ground, 1, {}, &network);
    REQUIRE(result);
    return std::move(*result);
  }
};

}  // namespace biotope::test
