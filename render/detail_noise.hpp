#pragma once

#include "render/ground_maps.hpp"

namespace biotope {

/// A tile of noise that repeats without seams: red and green the slope of small bumps (128 is flat), blue grain and rounded
/// stones (32 a side), alpha soft clouds. Mean of every channel is about 128.
[[nodiscard]] Grid<Rgba> detail_noise(int side = 512);

}  // namespace biotope
