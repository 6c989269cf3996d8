#pragma once

#include "core/base/grid.hpp"

namespace biotope {

/// One implicit step of diffusion along rows, then along columns: for each line the tridiagonal system of
/// w - d/dx(D dw/dx) = w_before, solved by elimination. `conductance` is D times the step over the squared cell size, of each cell; a
/// negative one marks a cell that keeps its water. Borders are closed. Positive water stays positive whatever the step.
void spread_water(Grid<float>& water, const Grid<float>& conductance);

}  // namespace biotope
