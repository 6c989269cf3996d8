#pragma once

#include "ui/map_builder.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Colour scale of a map with round values and its unit, or its classes, in the lower left corner of a canvas. `updating`: the
/// values are of an older state. Returns its size, nothing where there is no map.
ImVec2 draw_legend(const Theme& theme, ImVec2 origin, ImVec2 size, const MapEntry& map, float low, float high, bool updating);
/// A bar of a round length in the lower right corner; above a legend of that size where both do not fit beside one another.
void draw_scale_bar(const Theme& theme, ImVec2 origin, ImVec2 size, double metres_per_pixel, ImVec2 legend);
/// A small north arrow in the upper right corner, turned by `heading` degrees.
void draw_north_arrow(const Theme& theme, ImVec2 origin, ImVec2 size, float heading);

/// The ends of a map's colour scale: the entry's own, else those of the values, rounded outward where it helps reading.
struct ScaleRange {
  float low = 0;
  float high = 1;
};
[[nodiscard]] ScaleRange scale_range(const MapEntry& map, float least, float greatest);
/// The least of 1, 2 and 5 times a power of ten that is not below a positive value; other values as they are.
[[nodiscard]] float round_up(float value);
/// A round difference for iso-lines of a scale; 0 when there is none.
[[nodiscard]] float line_step(const ScaleRange& range);

}  // namespace biotope
