#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/ecosystem/plant_competition.hpp"
#include "core/ecosystem/plant_shared_landscape.hpp"

namespace biotope {

/// When plants with desired shares get their units, read off a sample of the land on which paper algorithm 1 runs as it is
/// written. Algorithm 1 gives each plant its fittest cells first, so all that a cell has to know of the rest of the terrain is at
/// which moment each plant has come down to which fitness. With that, cells compete by themselves, side by side, and a dab of
/// paint only needs its own cells again as long as the moments stay. (Our choice: the algorithm itself is sequential over all
/// cells, some 10 us a cell.)
struct ShareSchedule {
  /// Places in a queue at which the moment is known, from 0 to 1.
  static constexpr int knots = 9;

  /// Per key (see share_keys) the moments, 0..1 of all units of the sample, at which the queue of the cells of that key had come
  /// to each knot. A key that never was gets its units with the next lower one; what is lower than all at the end.
  struct Plant {
    int plant = 0;  ///< position in web.levels[0]
    std::array<std::array<float, knots>, share_keys> moments{};
    /// Mean time between two units, by key: a cell that stands first in the queue is given no more than that at once.
    std::array<float, share_keys> pace{};
    bool operator==(const Plant&) const = default;
  };
  /// The plants that are wanted; the others do not grow.
  std::vector<Plant> plants;
  bool operator==(const ShareSchedule&) const = default;
};

/// A map of at most as many cells competes whole (compete_with_proportions), a larger one by the schedule of as many.
inline constexpr int most_share_cells = 128 * 128;

/// Whether a map of this size competes by a schedule.
[[nodiscard]] constexpr bool competes_by_schedule(int width, int height) {
  return std::int64_t(width) * height > most_share_cells;
}

/// A cell's place in every queue, 0..1: hash of the cell alone, so that edits elsewhere do not move it.
[[nodiscard]] float place_in_queue(int x, int y);

/// Cells spread evenly over a map, one in each square block, at most most_share_cells; sorted by place_in_queue.
[[nodiscard]] CellList share_sample(int width, int height);

/// The schedule by which `desired` (see compete_with_proportions) is reached. Sequential: about 0.1 s. Empty where nobody is
/// wanted.
[[nodiscard]] Result<ShareSchedule> share_schedule(const FoodWeb& web, const PlantEnvironment& environment,
                                                   std::span<const double> desired, const TaskContext& context = {});

/// Competition by a schedule in the cells of one tile: in each cell, again and again a unit to the plant whose moment comes
/// first, until no wanted plant finds a place. Strata share light and water in the order of moments. `out[i]` receives plant i of
/// web.levels[0]. Does not depend on the tile's borders.
void compete_in_tile(const FoodWeb& web, const PlantEnvironment& environment, const ShareSchedule& schedule,
                     const Rect& tile_rect, std::span<CoverMap::Tile* const> out);

/// All tiles of compete_in_tile in parallel.
[[nodiscard]] Result<std::vector<CoverMap>> compete_by_schedule(const FoodWeb& web, const PlantEnvironment& environment,
                                                                const ShareSchedule& schedule, const TaskContext& context = {});

}  // namespace biotope
