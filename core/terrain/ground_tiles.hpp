#pragma once

#include "core/base/grid.hpp"
#include "core/base/paint.hpp"
#include "core/base/rect.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/terrain.hpp"

namespace biotope {

// Operators on the ground that are local to cells, for a rectangle at a time.

/// Writes some cells of heights with paint (null: none) on them: final = lerp(height, value, coverage).
void paint_heights(const Grid<float>& height, const PaintLayer* paint, const Rect& cells, Grid<float>& out);

/// Writes the derivatives of some cells, as compute_derivatives makes them; reads heights one cell around.
void differentiate(const Terrain& terrain, const Rect& cells, Derivatives& out);

}  // namespace biotope
