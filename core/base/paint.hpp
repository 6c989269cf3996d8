#pragma once

#include "core/base/tiled_map.hpp"

namespace biotope {

/// Paint over one cell of a map: a value in the map's unit and how much of it covers what was computed (0..1).
struct Paint {
  float value = 0;
  float coverage = 0;
  bool operator==(const Paint&) const = default;
};

/// Paint over one map; coverage 0 where nothing was painted.
using PaintLayer = TiledMap<Paint>;

/// final = lerp(computed, value, coverage).
[[nodiscard]] constexpr float painted(float computed, Paint paint) {
  return computed + (paint.value - computed) * paint.coverage;
}

}  // namespace biotope
