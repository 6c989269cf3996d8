#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/ecosystem/confinement.hpp"

namespace biotope {

/// What bars an animal's way somewhere.
struct Barrier {
  Obstacle kind = Obstacle::none;
  /// The nearest cell of it.
  int x = 0;
  int y = 0;
  /// The worst that was met: rise / run, depth in m, or cover 0..1.
  double worst = 0;
};

/// The obstacle that holds most of the straight line between two cells; none when nothing on it blocks.
[[nodiscard]] std::optional<Barrier> barrier_between(const Ground& ground, const Mobility& mobility, int x, int y, int to_x,
                                                     int to_y);

/// The obstacle that holds most of the border of the passable ground around a cell, as long as that has at most `most_cells`
/// cells.
[[nodiscard]] std::optional<Barrier> barrier_around(const Ground& ground, const Mobility& mobility, int x, int y,
                                                    std::size_t most_cells);

/// "a river deeper than it wades (1.4 m), 120 m to the south-east" of a cell.
[[nodiscard]] std::string barrier_text(const Ground& ground, const Barrier& barrier, int from_x, int from_y);

/// The cell nearest to (x, y) that lies in a region whose number `wanted` holds; ties go to the first in row order of its ring.
struct RegionCell {
  int x = 0;
  int y = 0;
  int region = 0;
};
[[nodiscard]] std::optional<RegionCell> nearest_region_cell(const RunMap& label, std::span<const double> population, int x,
                                                            int y);

}  // namespace biotope
