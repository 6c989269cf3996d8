#pragma once

#include <cmath>
#include <limits>

#include "core/base/paint.hpp"
#include "core/document/document.hpp"

namespace biotope {

/// What a layer's map holds at a cell once its paint is over what was computed, in the layer's unit.
[[nodiscard]] inline float final_value(LayerKind kind, float computed, Paint paint) {
  if (kind == LayerKind::geology) return paint.coverage >= 0.5F ? std::round(paint.value) : computed;
  return painted(computed, paint);
}

/// Classes of the map of obstacles and passages: an obstacle, a way open to all, or neither.
inline constexpr float obstacle_class = 0;
inline constexpr float open_class = 1;
inline constexpr float no_passage_class = -1;

/// What the map that shows a layer (map_of_layer) holds at a cell: the final value; of the ground how much it was raised or
/// lowered (NaN where nothing is painted); of obstacles and passages their class.
[[nodiscard]] inline float shown_value(LayerKind kind, float computed, Paint paint) {
  const float value = final_value(kind, computed, paint);
  if (kind == LayerKind::ground) {
    return paint.coverage > 0 ? value - computed : std::numeric_limits<float>::quiet_NaN();
  }
  if (kind == LayerKind::passage) return value >= 0.5F ? obstacle_class : value <= -0.5F ? open_class : no_passage_class;
  return value;
}

}  // namespace biotope
