#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/ecosystem/plant_competition.hpp"

/// The competition of one cell written as plainly as the documents say it: thesis eq. 5.4 in doubles, one unit at a time.
namespace biotope::plant_reference {

/// Thesis eq. 5.4 for one resource, each month lowered by what was taken.
inline double resource_fitness(Range range, const std::array<float, months>& values, double taken) {
  double sum = 0;
  for (std::size_t m = 0; m < months; ++m) {
    const double a = double(values[m]) - taken;
    const double b = double(values[(m + 1) % months]) - taken;
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    if (high == low) {
      sum += low >= double(range.low) && low <= double(range.high) ? 1 : 0;
    } else {
      sum += std::max(0.0, std::min(double(range.high), high) - std::max(double(range.low), low)) / (high - low);
    }
  }
  return sum / months;
}

/// What competition in a cell has come to.
struct CellState {
  std::vector<int> cover;  ///< steps of 1/240
  std::array<int, strata> ground{full_cover, full_cover, full_cover};
  double light_taken = 0;
  double water_taken = 0;
};

inline int unit_of(const PlantTraits& plant) { return std::max(1, int(std::lround(plant.unit_cover * float(full_cover)))); }
inline double unit_taken(float consumption, int unit) {
  return std::round(double(consumption) * unit / full_cover * 65536) / 65536;
}
inline double mean(const std::array<float, months>& values) {
  double sum = 0;
  for (const float value : values) sum += double(value);
  return sum / months;
}

/// Fitness of a plant with what is left, in steps of 1/240; 0 where a need is not available.
inline double fitness_left(const PlantTraits& plant, const CellEnvironment& cell, const CellState& state, int cover) {
  const int unit = unit_of(plant);
  const auto& light = cell.monthly[std::size_t(Resource::illumination)];
  const auto& warmth = cell.monthly[std::size_t(Resource::temperature)];
  const auto& water = cell.monthly[std::size_t(Resource::moisture)];
  if (state.ground[std::size_t(plant.stratum)] < unit) return 0;
  if (mean(light) - state.light_taken <= unit_taken(plant.light_consumption, unit)) return 0;
  if (mean(water) - state.water_taken <= unit_taken(plant.water_consumption, unit)) return 0;
  if (!plant.texture.contains(cell.texture)) return 0;
  double fitness = double(plant.geology[std::size_t(cell.geology)]);
  fitness = std::min(fitness, resource_fitness(plant.temperature, warmth, 0));
  fitness = std::min(fitness, resource_fitness(plant.illumination, light, state.light_taken));
  fitness = std::min(fitness, resource_fitness(plant.moisture, water, state.water_taken));
  if (fitness < double(least_fitness)) return 0;
  return std::min(fitness * full_cover, double(full_cover - cover));
}

inline void give_unit(const PlantTraits& plant, CellState& state, std::size_t i) {
  const int unit = unit_of(plant);
  state.cover[i] += unit;
  state.ground[std::size_t(plant.stratum)] -= unit;
  state.light_taken += unit_taken(plant.light_consumption, unit);
  state.water_taken += unit_taken(plant.water_consumption, unit);
}

/// Competition in one cell. `narrowest` receives how close the closest decision was, in steps of fitness: a caller that
/// compares with a computation in floats leaves out cells where it is below rounding.
inline CellState compete(const FoodWeb& web, const CellEnvironment& cell, double* narrowest = nullptr) {
  CellState state;
  state.cover.assign(web.levels[0].size(), 0);
  double margin = full_cover;
  for (int stratum = 0; stratum < strata; ++stratum) {
    while (true) {
      double best = 0;
      int chosen = -1;
      double second = 0;
      for (std::size_t i = 0; i < web.levels[0].size(); ++i) {
        const PlantTraits& plant = web.species[std::size_t(web.levels[0][i])].plant();
        if (int(plant.stratum) != stratum) continue;
        const double fitness = fitness_left(plant, cell, state, state.cover[i]);
        if (fitness > 0) margin = std::min(margin, fitness - double(least_fitness) * full_cover);
        if (fitness > best) {
          second = best;
          best = fitness;
          chosen = int(i);
        } else {
          second = std::max(second, fitness);
        }
      }
      if (chosen < 0) break;
      if (best != second) margin = std::min(margin, best - second);
      give_unit(web.species[std::size_t(web.levels[0][std::size_t(chosen)])].plant(), state, std::size_t(chosen));
    }
  }
  if (narrowest != nullptr) *narrowest = margin;
  return state;
}

}  // namespace biotope::plant_reference
