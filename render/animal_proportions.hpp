#pragma once

#include <string_view>

namespace biotope {

/// Build of a quadruped, as fractions of its shoulder height unless said otherwise. Our drawing's choices, from field guides' silhouettes.
struct AnimalProportions {
  float trunk_length = 1.1F;   ///< rump to chest
  float trunk_height = 0.4F;   ///< depth of the chest
  float trunk_width = 0.3F;
  float hump = 0;              ///< how much the withers rise above the back
  float leg_radius = 0.045F;
  float neck_length = 0.4F;
  float neck_angle = 45;       ///< degrees above the horizon when standing
  float neck_radius = 0.1F;
  float head_length = 0.3F;
  float head_radius = 0.085F;
  float ear_length = 0.1F;
  float tail_length = 0.2F;
  float tail_radius = 0.03F;
  float tail_angle = -70;
};

/// Proportions of AnimalShape::model; an unknown model is drawn as a deer.
[[nodiscard]] AnimalProportions animal_proportions(std::string_view model);

}  // namespace biotope
