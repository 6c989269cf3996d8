#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace biotope {

inline constexpr int colour_maps = 7;
inline constexpr int colour_table_width = 256;
/// Categories have this many colours and then start again.
inline constexpr int category_colours = 12;

/// Colour of a category (a region, a geology class): category modulo category_colours.
[[nodiscard]] std::array<float, 3> category_colour(int category);

/// All colour maps as RGBA bytes, a row of colour_table_width a map, in the order of ColourMap.
[[nodiscard]] std::vector<std::uint8_t> colour_table();

}  // namespace biotope
