#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_lanes.hpp"

namespace biotope {

/// Cells that compete side by side, one a lane. (16 lanes of AVX-512 were slower: GCC 12 takes their comparisons apart, and
/// more cells wait for the slowest.)
inline constexpr int batch_cells = lane_count;

/// Cover of one population unit in steps of 1/240, at least one step.
[[nodiscard]] Cover unit_of(const PlantTraits& plant);

/// Index points that one unit takes, rounded to 1/65536 so that sums are exact in any order.
[[nodiscard]] float unit_consumption(float consumption_at_full_cover, Cover unit);

/// The distinct ends of the ranges of a stratum for one resource: species share most of them (table A.1: 9 for moisture).
struct RangeEnds {
  std::vector<float> lows;
  /// Ends of 9 and more are left out: no index is above them.
  std::vector<float> highs;
};

/// A plant as the kernel sees it.
struct Competitor {
  int plant = 0;  ///< position in web.levels[0]
  const PlantTraits* traits = nullptr;
  std::size_t stratum = 0;
  float unit = 0;  ///< steps of 1/240
  float light_taken = 0;
  float water_taken = 0;
  /// Position of the range's ends in RangeEnds; high is -1 where nothing can be above it.
  int light_low = 0;
  int light_high = -1;
  int water_low = 0;
  int water_high = -1;
};

/// The plants of a web sorted for competition: what depends on species alone.
struct CompetitionPlan {
  struct Layer {
    std::vector<Competitor> competitors;  ///< in species order
    RangeEnds light;
    RangeEnds water;
    /// Adds plant `number` of web.levels[0].
    void add(int number, const PlantTraits& plant);
  };
  std::array<Layer, strata> layers;
  int plants = 0;
};
[[nodiscard]] CompetitionPlan competition_plan(const FoodWeb& web);

/// Twelve month-to-month intervals of a resource in every cell of a batch.
struct IntervalLanes {
  std::array<LaneValues, months> low;
  std::array<LaneValues, months> high;
  std::array<LaneValues, months> inverse_length;
  LaneValues mean;
  LaneValues year_low;
  LaneValues year_high;
};

/// Sums over the year of a resource, by position in RangeEnds, and how many active competitors need each.
struct IntervalSums {
  std::vector<LaneValues> below;
  std::vector<LaneValues> above;
  std::vector<int> low_users;
  std::vector<int> high_users;
  void forget_users() {
    std::fill(low_users.begin(), low_users.end(), 0);
    std::fill(high_users.begin(), high_users.end(), 0);
  }
};

/// What a batch needs between calls: allocated once a tile.
struct CompetitionBatch {
  explicit CompetitionBatch(const CompetitionPlan& plan);
  /// For covers of `plants` plants, at most `most` of which compete in one layer.
  CompetitionBatch(int plants, std::size_t most);

  std::array<IntervalLanes, monthly_resources> resources;
  LaneValues texture;
  std::array<LaneValues, geology_classes> on_geology;  ///< 1 where the cell is of the class, else 0

  /// Result: steps of 1/240 by position in web.levels[0].
  std::vector<LaneValues> cover;

  /// Working room of one layer: sums by range end, and by competitor the fitness that consumption cannot change.
  IntervalSums light_sums;
  IntervalSums water_sums;
  std::vector<LaneValues> fixed;
  /// Competitors that may still grow somewhere in the batch, in species order.
  std::vector<int> active;
};

/// The competition (see compete_in_tile) of `count` cells, at most batch_cells, of row y from x on, with AVX2 where the
/// processor has it. Lanes from `count` on repeat the last cell.
void compete_batch(const CompetitionPlan& plan, const PlantEnvironment& environment, int x, int y, int count,
                   CompetitionBatch& batch);

}  // namespace biotope
