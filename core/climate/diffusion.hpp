#pragma once

#include "core/base/grid.hpp"

namespace biotope {

/// One implicit step of diffusion along rows, then along columns: for each line the tridiagonal system of
/// v - d/dx(D dv/dx) = v_before, solved by elimination. `conductance` is D times the step over the squared cell size, of each cell; a
/// negative one marks a cell that keeps its value. Borders are closed: without such cells the sum is kept. Positive values stay positive
/// whatever the step. A uniform conductance k spreads a spot by a variance of 2 k cells^2 along each axis. O(cells), parallel.
void diffuse(Grid<float>& values, const Grid<float>& conductance);

}  // namespace biotope
