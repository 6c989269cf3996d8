#pragma once

#include <string>

#include "render/image.hpp"

namespace biotope::test {

/// How far two pictures of one size are apart, 0..255. Compared by the mean colours of blocks of 8 x 8 pixels, so that neither a
/// leaf that moved by a pixel nor another rounding of a driver counts, but a wrong colour, a missing crown or a hole do.
struct ImageDifference {
  double mean = 0;    ///< of all blocks
  double worst = 0;   ///< of the block that differs most
  double unlike = 0;  ///< share of blocks that are more than 24 apart
};
[[nodiscard]] ImageDifference difference(const Image& a, const Image& b);

/// Half the size: means of 2 x 2 pixels.
[[nodiscard]] Image halved(const Image& image);

}  // namespace biotope::test
