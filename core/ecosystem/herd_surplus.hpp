#pragma once

#include <memory>
#include <span>

#include "core/ecosystem/animal_level.hpp"

namespace biotope {

/// What is left over where a herd lives, as shares 0..1.
struct HerdSurplus {
  /// Of its species' own yearly growth in its region, after losses and after what the levels above take.
  double own = 1;
  /// Of the yearly growth of all it can eat in its region, after all of its level ate. 1 where it finds nothing to eat at all.
  double food = 1;
};
/// Surplus of a herd of `level`, one of `levels` (all animal levels, in order).
[[nodiscard]] HerdSurplus herd_surplus(const FoodWeb& web, std::span<const std::shared_ptr<const AnimalLevel>> levels,
                                       const AnimalLevel& level, const Herd& herd);

/// Share of a herd that is younger than a year: as many as are born of the others in a year (their growth rate) and are left
/// over. Those that are taken live for a third of the year; where all food is eaten half of them grow up, where half of it or
/// more is left all; at most 35 % of a herd. Our choices.
[[nodiscard]] double young_share(const AnimalTraits& animal, const HerdSurplus& surplus);

}  // namespace biotope
