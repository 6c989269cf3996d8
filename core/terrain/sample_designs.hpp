#pragma once

#include "core/terrain/dissection.hpp"

namespace biotope {

/// Tautavel as the 2021 paper shows it: a river from north to south through limestone and marl, 60..560 m. 4.608 km a side.
[[nodiscard]] LandscapeDesign valley_design();

}  // namespace biotope
