#pragma once

#include <string_view>

#include "render/season.hpp"

namespace biotope {

/// A species' coat in a month: how it differs from the one of summer, whose colours AnimalShape has.
struct AnimalCoat {
  float grey = 0;         ///< share by which its colours are duller
  float pale = 0;         ///< and paler
  float shade = 1;        ///< times its colours
  float hair = 0;         ///< longer by so much, of the shoulder height
  float spots = 1;        ///< share of its spots that shows
  float young_spots = 0;  ///< and how much the young are spotted, where the grown are not
};
/// `month`: 0 is January on the northern hemisphere. Told apart by genus; others have a somewhat duller, thicker coat in winter.
[[nodiscard]] AnimalCoat animal_coat(std::string_view scientific_name, int month);

/// How far an animal's antlers have grown.
struct AntlerState {
  float grown = 1;  ///< 0 cast .. 1 all of it
  bool velvet = false;
};
/// Of a deer of a species in a month; `early` 0..1: how late in the month it is for this one, since old ones cast and clean
/// first. Animals that have no antlers keep what they have.
[[nodiscard]] AntlerState antlers(std::string_view scientific_name, bool male, int month, float early);

}  // namespace biotope
