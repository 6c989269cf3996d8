#pragma once

#include "core/base/rect.hpp"
#include "core/document/brush.hpp"

namespace biotope {

/// The weight of one dab around its centre: a disk with the brush's falloff, or its stamp.
class DabShape {
 public:
  DabShape(const Brush& brush, StrokePoint at);
  /// Cells that the dab may reach, not cut at the map's border; empty for a dab of no size or at no place.
  [[nodiscard]] Rect reach() const;
  /// Weight 0..1 at a cell, without strength.
  [[nodiscard]] float operator()(int x, int y) const;

 private:
  [[nodiscard]] float disk_weight(float squared_distance) const;
  [[nodiscard]] float stamp_weight(float dx, float dy) const;

  StrokePoint centre_;
  float radius_ = 0;
  float core_ = 0;
  Falloff falloff_ = Falloff::smooth;
  const Grid<float>* stamp_ = nullptr;
  float cosine_ = 1;
  float sine_ = 0;
};

/// Radius (cells) and strength (0..1) of a dab that is pressed so hard.
[[nodiscard]] float pressed_radius(const Brush& brush, float pressure);
[[nodiscard]] float pressed_strength(const Brush& brush, float pressure);

/// Cells from a dab to the next of a stroke.
[[nodiscard]] double dab_spacing(const Brush& brush, float pressure);

}  // namespace biotope
