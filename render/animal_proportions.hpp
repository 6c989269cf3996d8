#pragma once

#include <string_view>

#include "core/species/species.hpp"

namespace biotope {

/// Headgear of an animal's build.
enum class Headgear : unsigned char {
  none,
  red_antlers,
  palmate_antlers,
  caribou_antlers,
  forked_antlers,
  bison_horns,
  ibex_horns,
  curled_horns,
  prong_horns,
  nose_horns
};

/// Build of a quadruped, as fractions of its shoulder height unless said otherwise. Our drawing's choices, from field guides'
/// silhouettes.
struct AnimalBuild {
  // The trunk: its length, the heights of its upper line (the withers are at 1) and of its lower line, and half widths.
  float trunk = 1.05F;
  float rump = 0.97F;
  float back = 0.95F;
  float hump = 0;  ///< how much the shoulders rise above the withers
  float chest = 0.47F;
  float belly = 0.50F;
  float groin = 0.58F;
  float rump_width = 0.13F;
  float belly_width = 0.165F;
  float shoulder_width = 0.15F;
  // Neck: degrees above the horizon, half heights and half widths at its ends.
  float neck_length = 0.45F;
  float neck_angle = 52;
  float neck_base = 0.16F;
  float neck_top = 0.075F;
  float neck_width = 0.09F;
  float neck_top_width = 0.05F;
  // Head: degrees below the horizon; half heights and half widths at the cheeks and at the muzzle.
  float head_length = 0.34F;
  float head_angle = 32;
  float head_depth = 0.085F;
  float muzzle_depth = 0.045F;
  float head_width = 0.062F;
  float muzzle_width = 0.038F;
  // Legs: half thickness of the shank, of the thigh and of the upper arm; height of hock and knee; paws instead of hooves.
  float shank = 0.024F;
  float thigh = 0.13F;
  float upper_arm = 0.085F;
  float hock = 0.30F;
  float knee = 0.28F;
  bool paws = false;
  // Ears, tail.
  float ear_length = 0.16F;
  float ear_width = 0.04F;
  float ear_out = 55;  ///< degrees from upright
  bool ear_tufts = false;
  float tail_length = 0.12F;
  float tail_radius = 0.03F;
  float tail_angle = -60;  ///< degrees above the horizon
  // Hair.
  float beard = 0;        ///< below the chin, length
  float mane = 0;         ///< crest of the neck, height
  float throat_mane = 0;  ///< how much neck and chest swell below
  bool hair_tail = false;
  Headgear headgear = Headgear::none;
  float headgear_size = 0.6F;
  /// Size of the females' headgear beside the males'.
  float female_headgear = 0;
  // Colours: shares of dark or pale on the coat.
  float dark_legs = 0.3F;
  float dark_front = 0;  ///< head, neck and shoulders
  float pale_front = 0;  ///< neck and shoulders
  float pale_rump = 0;
  float dorsal_stripe = 0.25F;
  float belly_share = 1;  ///< how much of the lower side is pale
  float dark_muzzle = 0.8F;
  float pale_muzzle = 0;
  float pale_chin = 0.55F;
  float eye_rings = 0.35F;
  float dark_face = 0;
  float saddle = 0;  ///< pale patch on the flanks
  float spots = 0;   ///< pale ones; below 0 dark ones
  float socks = 0;   ///< pale feet
  float dark_tail_tip = 0;
  float pale_tail_tip = 0;
};

/// The build of a species: by its genus where that has one of its own, else by AnimalShape::model; an unknown model is drawn as a
/// deer.
[[nodiscard]] AnimalBuild animal_build(const AnimalShape& shape, std::string_view scientific_name);

}  // namespace biotope
