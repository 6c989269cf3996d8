#pragma once

#include <span>

#include "ui/widgets.hpp"

namespace biotope {

/// Pictures a second that a level must keep to be chosen: what a graphics card is for, or what still looks like motion where the
/// processor draws.
[[nodiscard]] constexpr double wanted_frames(bool software) { return software ? 24 : 60; }

/// The highest level that should keep the wanted frames, from what pictures at level low took (s each, the quickest counts). Never
/// less than low.
[[nodiscard]] QualityLevel measured_level(std::span<const double> seconds_at_low, bool software);

/// The choice of the level in the settings.
void draw_quality_setting(const UiContext& ui);
/// What drawing costs, in a corner of the 3D view.
struct DrawnFigures {
  std::size_t plants = 0;
  std::size_t animals = 0;
  std::size_t triangles = 0;
  int draw_calls = 0;
  std::size_t instance_bytes = 0;
  std::size_t most_instance_bytes = 0;
  int width = 0;
  int height = 0;
  double seconds = 0;  ///< of the last picture; 0: not known
};
void draw_figures(const UiContext& ui, ImVec2 corner, const DrawnFigures& figures);

}  // namespace biotope
