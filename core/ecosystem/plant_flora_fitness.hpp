#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_lanes.hpp"

namespace biotope {

/// The month-to-month intervals of a resource at a cell.
struct YearIntervals {
  std::array<float, months> low{};
  std::array<float, months> high{};
  std::array<float, months> inverse_length{};
  float mean = 0;
  float most = 0;  ///< of the year
};
[[nodiscard]] YearIntervals year_intervals(const std::array<float, months>& year);

/// Fitness of many plants in one cell by one resource. Plants share most of the ends of their ranges (table A.1 has 9 for the
/// moisture of 18 plants), so sums over the year are found by end, an end a lane, and looked up by plant.
class FloraFitness {
 public:
  /// Working room of one thread.
  struct Room {
    std::vector<LaneValues> below;
    std::vector<LaneValues> above;
  };

  explicit FloraFitness(std::span<const PlantTraits* const> plants);

  /// Lowers each plant's key to its fitness by a resource of which `taken` is used up, in whole steps of 1/240: 0 below
  /// least_fitness, else at least 1. Keys are as many as plants.
  void limit(Resource resource, const YearIntervals& year, float taken, Room& room, std::span<std::uint8_t> keys) const;

  /// The key of one plant by a resource: what `limit` would lower it to.
  [[nodiscard]] std::uint8_t key_of(std::size_t plant, Resource resource, const YearIntervals& year, float taken) const;

 private:
  struct Ends {
    std::vector<LaneValues> lows;
    std::vector<LaneValues> highs;
    /// Lane of each plant's ends.
    std::vector<std::uint32_t> low_of;
    std::vector<std::uint32_t> high_of;
  };
  std::array<Ends, monthly_resources> ends_;
};

}  // namespace biotope
