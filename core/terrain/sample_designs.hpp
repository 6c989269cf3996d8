#pragma once

#include "core/terrain/dissection.hpp"

namespace biotope {

/// Tautavel as the 2021 paper shows it: a river from north to south through limestone and marl, 60..470 m. 4.608 km a side.
[[nodiscard]] LandscapeDesign valley_design();

/// A glacial valley between peaks, 1000..2200 m. 9.216 km a side. The lake is dug afterwards (see alpine_lake).
[[nodiscard]] LandscapeDesign alpine_design();

/// A dry plateau cut by a canyon of layered cliffs, 700..1750 m. 9.216 km a side.
[[nodiscard]] LandscapeDesign canyon_design();

/// A hollow that ice has dug along part of a river's course.
struct Overdeepening {
  double from_y = 0;  ///< m from the northern edge
  double to_y = 0;
  double half_width = 0;  ///< m
  double depth = 0;       ///< m
};
[[nodiscard]] Overdeepening alpine_lake();

}  // namespace biotope
