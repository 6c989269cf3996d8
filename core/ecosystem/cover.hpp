#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/tiled_map.hpp"

namespace biotope {

/// Covered fraction of a cell in steps of 1/240, so that units of 1/20, 1/16, 1/12 or 1/10 are exact.
using Cover = std::uint8_t;
inline constexpr int full_cover = 240;
using CoverMap = TiledMap<Cover>;

[[nodiscard]] constexpr float cover_fraction(Cover cover) { return float(cover) / float(full_cover); }
[[nodiscard]] inline Cover to_cover(float fraction) {
  return Cover(std::lround(std::clamp(fraction, 0.0F, 1.0F) * float(full_cover)));
}

}  // namespace biotope
