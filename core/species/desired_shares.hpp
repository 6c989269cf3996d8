#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/species/species_library.hpp"

namespace biotope {

/// The species with a desired share (0..1 of the whole level) for the one named `name`; the others of its level share the rest as
/// they did before, so that nobody is driven out. Where nobody asked for a share yet, "before" is what the level achieves now
/// (`achieved`, one a species of web.levels[level]; even where it is empty). Writes the shares of the climate if a species of the
/// level has its own ones for it, else the default ones, to four decimals. The species must be of that level.
[[nodiscard]] std::vector<Species> with_desired_share(std::vector<Species> all, const FoodWeb& web, int level,
                                                      std::string_view climate, std::string_view name, double share,
                                                      std::span<const double> achieved);

}  // namespace biotope
