#pragma once

#include <string>
#include <vector>

#include "core/ecosystem/animal_competition.hpp"
#include "core/ecosystem/animal_level.hpp"

namespace biotope {

/// What a species needs over a year, as its diet says; needs of amount 0 are left out.
[[nodiscard]] std::vector<YearlyNeed> yearly_needs(const FoodWeb& web, int species);

/// A need of a species in one of its regions, kg per year.
struct NeedBalance {
  YearlyNeed need;
  double offered = 0;  ///< yearly growth in reach that the levels below left
  double left = 0;     ///< after everybody of this level ate; `offered` before the competition
};
[[nodiscard]] std::vector<NeedBalance> need_balance(const FoodWeb& web, const AnimalLevel& level, std::size_t species_index,
                                                    int region);

/// The need that allows the fewest animals when `offered` (or `left`) is shared out; -1 when there is none.
[[nodiscard]] int scarcest_need(const std::vector<NeedBalance>& balance, double NeedBalance::*amount);

/// Whether a bank lies in the region.
[[nodiscard]] bool region_has_water(const AnimalLevel& level, std::size_t species_index, int region);

/// Why competition gave a species no herd anywhere: "no region of it has water", ...
[[nodiscard]] std::string absence_reason(const FoodWeb& web, const AnimalLevel& level, std::size_t species_index);

/// Common name where there is one.
[[nodiscard]] std::string display_name(const FoodWeb& web, int species);
/// A quantity to read: whole from 10 up, one decimal below.
[[nodiscard]] std::string number_text(double value);

}  // namespace biotope
