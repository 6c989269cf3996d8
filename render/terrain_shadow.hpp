#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/base/grid.hpp"

namespace biotope {

/// Share of direct light (0..255) that reaches each cell of a surface from `light` (unit vector toward it, z up): one sweep from the side
/// of the light that carries the height of the shadow along, O(cells). Edges are soft over about `softness` metres of height.
[[nodiscard]] Grid<std::uint8_t> sweep_shadows(const Grid<float>& surface, double cell_size, const glm::vec3& light, float softness);

/// Every `stride`-th cell of a surface.
[[nodiscard]] Grid<float> thinned(const Grid<float>& surface, int stride);

}  // namespace biotope
