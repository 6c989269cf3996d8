#pragma once

#include <memory>
#include <optional>

#include "core/document/brush_filter.hpp"
#include "render/map_renderer.hpp"
#include "render/mipmaps.hpp"

namespace biotope {

/// What is laid over the 3D view: a map, where the brush may not act, and what is locked. Two that are equal look the same, but
/// for cells that changed in place.
struct DrapeSource {
  std::optional<MapOverlay> overlay;
  /// The film of a filter; nothing: not shown.
  struct Film {
    BrushFilter filter;
    FilterMaps maps;
    std::shared_ptr<const SelectionMask> selection;
  };
  std::optional<Film> film;
  std::shared_ptr<const SelectionMask> locked_area;
};
[[nodiscard]] bool same_drape(const DrapeSource& a, const DrapeSource& b);

/// Cells a side that one texel stands for, so that no side has more than 2048 texels.
[[nodiscard]] int drape_step(int width, int height);

/// Makes the texels of some cells (premultiplied, a texel for step x step cells) again. Parallel over rows.
void colour_drape(const DrapeSource& source, int step, const Rect& cells, Grid<Rgba>& texels);

}  // namespace biotope
