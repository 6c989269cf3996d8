#pragma once

#include <cstdint>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// A small shaded picture of a landscape seen from above, north up, RGBA with the northern row first.
struct ReliefPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Heights tinted from valley to peak, shaded from the north-west, darker under trees, with water; its longer side has `side`
/// pixels.
[[nodiscard]] ReliefPicture make_relief_picture(const MapsSnapshot& maps, int side);

}  // namespace biotope
