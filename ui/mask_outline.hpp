#pragma once

#include <vector>

#include "core/base/rect.hpp"
#include "core/document/brush_filter.hpp"
#include "core/document/selection.hpp"
#include "ui/view_transform.hpp"

namespace biotope {

/// A straight piece of an outline, cell coordinates (borders of cells, not their centres).
struct OutlinePiece {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool operator==(const OutlinePiece&) const = default;
};

/// The border between what is at least half selected and what is not, inside `cells`, looked at every `step` cells. Pieces in a
/// row are joined.
[[nodiscard]] std::vector<OutlinePiece> outline_of(const SelectionMask& mask, const Rect& cells, int step);

/// A run of blocks of one row where a brush acts less: 1 (a little less) .. 4 (not at all).
struct FilmRun {
  Rect cells;
  int level = 0;
};

/// Where a filter and a selection (null: everything) keep a brush from acting, inside `cells`, looked at every `step` cells.
[[nodiscard]] std::vector<FilmRun> film_of(const BrushFilter& filter, const FilterMaps& maps, const SelectionMask* mask,
                                           const Rect& cells, int step);

/// What a mask covers, inside `cells`, looked at every `step` cells.
[[nodiscard]] std::vector<FilmRun> runs_of(const SelectionMask& mask, const Rect& cells, int step);

/// The cells a view shows, and how many of them make a block of about `pixels` on the screen.
[[nodiscard]] Rect visible_cells(const MapView& view, PixelPoint canvas, const Rect& map);
[[nodiscard]] int block_cells(const MapView& view, double pixels);

}  // namespace biotope
