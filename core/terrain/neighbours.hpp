#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace biotope {

/// The eight neighbours clockwise from east, in the order of Hydrology::receiver (y grows southward).
inline constexpr std::array<int, 8> neighbour_dx{1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr std::array<int, 8> neighbour_dy{0, 1, 1, 1, 0, -1, -1, -1};
/// 1 / distance to each neighbour, in cells.
inline constexpr std::array<float, 8> neighbour_inverse_distance{1.0F, 0.70710678F, 1.0F, 0.70710678F, 1.0F, 0.70710678F, 1.0F, 0.70710678F};
/// Hydrology::receiver of a cell from which water leaves the map.
inline constexpr std::uint8_t leaves_map = 8;

/// The direction that leads back.
[[nodiscard]] constexpr int opposite_direction(int direction) { return (direction + 4) & 7; }

/// What to add to a cell's index to reach each neighbour on a grid of this width.
[[nodiscard]] constexpr std::array<std::ptrdiff_t, 8> neighbour_offsets(int width) {
  std::array<std::ptrdiff_t, 8> offsets{};
  for (std::size_t d = 0; d < 8; ++d) offsets[d] = std::ptrdiff_t(neighbour_dy[d]) * width + neighbour_dx[d];
  return offsets;
}

}  // namespace biotope
