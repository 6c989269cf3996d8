#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/base/grid.hpp"
#include "core/base/path_point.hpp"
#include "core/base/tiled_map.hpp"

namespace biotope {

/// How much of each cell is selected: 0..255. Masks made here have background 0; their full tiles are one shared tile.
using SelectionMask = TiledMap<std::uint8_t>;

/// How a new selection meets the one that is there. For any a and b: subtract(a, a) is nothing, add(a, inverted(a)) is
/// everything, and add(intersect(a, b), subtract(a, b)) is a.
enum class SelectionMode : std::uint8_t {
  replace,
  add,       ///< sum, at most 255
  subtract,  ///< difference, at least 0
  intersect  ///< the lesser
};

/// The cells under two corners of an axis-parallel rectangle and those between, cut at the map's border.
[[nodiscard]] SelectionMask rectangle_selection(int width, int height, PathPoint corner, PathPoint opposite);
/// Cells inside a closed line (even-odd rule); partly covered cells are partly selected. Points that are no numbers are left out.
[[nodiscard]] SelectionMask lasso_selection(int width, int height, std::span<const PathPoint> line);
/// Cells whose value lies in [low, high]; outside, selection falls to 0 over `softness` (in the map's unit). Cells without a
/// number are not selected.
[[nodiscard]] SelectionMask range_selection(const Grid<float>& values, float low, float high, float softness);
/// The share that was not selected, cell by cell.
[[nodiscard]] SelectionMask inverted(const SelectionMask& mask);

/// A selection of `share(x, y)` (0..1) of every cell. Parallel: `share` is called from several threads.
[[nodiscard]] SelectionMask selection_of(int width, int height, const std::function<float(int x, int y)>& share);

/// The selection after another one met it; null stands for 'everything is selected' before and after. An empty result is a
/// mask of zeros, not null; a full one is null.
[[nodiscard]] std::shared_ptr<const SelectionMask> combined(const std::shared_ptr<const SelectionMask>& before,
                                                            SelectionMask with, SelectionMode mode);

/// Share of a cell that is selected, 0..1; 1 everywhere without a selection.
[[nodiscard]] inline float selected(const SelectionMask* mask, int x, int y) {
  return mask == nullptr ? 1.0F : float((*mask)(x, y)) * (1.0F / 255);
}

/// Share of a cell that is locked, 0..1; 0 everywhere without a locked area.
[[nodiscard]] inline float locked_share(const SelectionMask* locked_area, int x, int y) {
  return locked_area == nullptr ? 0.0F : float((*locked_area)(x, y)) * (1.0F / 255);
}

}  // namespace biotope
