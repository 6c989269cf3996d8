#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_competition_kernel.hpp"
#include "core/ecosystem/plant_flora_fitness.hpp"
#include "core/ecosystem/plant_priority.hpp"

namespace biotope {

/// Cells are compared by fitness in steps of 1/20 (12/240), like the cover of a unit: what differs by less counts as equal, and
/// the order of cells decides. Finer steps find hardly fitter cells, and have to look at each of them again whenever a little
/// light is gone.
inline constexpr int share_key_step = 12;
/// Keys are 0 (no place) to 20.
inline constexpr int share_keys = full_cover / share_key_step + 1;

/// A plant that somebody wants: its number in the level and what one unit takes.
struct WantedPlant {
  int plant = 0;
  const PlantTraits* traits = nullptr;
  Cover unit = 1;
  float light_taken = 0;
  float water_taken = 0;
};
/// The plants of web.levels[0] whose desired share is above 0.
[[nodiscard]] std::vector<WantedPlant> wanted_plants(const FoodWeb& web, std::span<const double> desired);

/// Cells of a map, in the order in which equally fit ones are taken.
using CellList = std::vector<std::array<int, 2>>;

/// Some or all cells of a terrain while their plants are given out unit by unit (paper algorithm 1).
class SharedLandscape {
 public:
  /// The wanted plants, the environment and the cells must outlive it.
  SharedLandscape(const std::vector<WantedPlant>& wanted, const PlantEnvironment& environment, const CellList& cells);

  /// Whether some cell may still feed a unit of the wanted plant i.
  [[nodiscard]] bool has_place(std::size_t i) const { return priority_[i].best() > 0; }

  /// A cell that got a unit, and its key (see share_keys); key 0: no cell can feed it after all.
  struct Place {
    std::size_t cell = 0;
    int key = 0;
  };
  /// Gives one unit of the wanted plant i to the fittest cell, the first in order of equals.
  Place place(std::size_t i);

  /// Cover of the wanted plant i as a map of width x height cells; tiles where it does not grow stay null.
  [[nodiscard]] CoverMap cover_map(std::size_t i, int width, int height) const;

 private:
  void start_cell(std::size_t cell, std::vector<std::uint8_t>& keys);
  [[nodiscard]] std::uint8_t ceiling(std::size_t cell, std::size_t i) const;
  void keys_of(std::size_t cell, FloraFitness::Room& room, std::span<std::uint8_t> keys) const;
  std::uint8_t look_at(std::size_t cell, std::size_t i);
  void give_unit(std::size_t cell, std::size_t i);
  void prefetch(std::size_t cell) const;
  [[nodiscard]] bool someone_has_too_much(std::size_t cell) const;

  /// What is left in a cell.
  struct Stock {
    float light_taken = 0;
    float water_taken = 0;
    std::array<Cover, strata> ground{full_cover, full_cover, full_cover};
  };

  /// What a cell's year brings.
  struct Years {
    YearIntervals light;
    YearIntervals water;
  };

  // Numbers by cell and wanted plant lie side by side for each cell.
  const std::vector<WantedPlant>& wanted_;
  const PlantEnvironment& environment_;
  const CellList& cells_;
  FloraFitness fitness_;
  std::vector<Years> years_;
  std::vector<Stock> stock_;
  std::vector<std::uint8_t> fixed_;  ///< fitness that nothing consumes, steps of 1/240
  std::vector<Cover> cover_;
  std::vector<CellPriority> priority_;
  // Room for the keys of one cell.
  FloraFitness::Room room_;
  std::vector<std::uint8_t> keys_;
};

}  // namespace biotope
