#pragma once

#include <array>
#include <string>

#include "core/climate/environment.hpp"
#include "core/species/species.hpp"

namespace biotope {

/// Months by number, true where something holds.
using MonthSet = std::array<bool, months>;

/// "all year", "in June", "from May to September", "in March and from May to June"; empty when no month is in the set.
/// Runs go round the year's end.
[[nodiscard]] std::string months_text(const MonthSet& set);

/// Where a year lies outside a range, and by how much.
struct YearMisfit {
  MonthSet too_low{};
  MonthSet too_high{};
  int months_low = 0;
  int months_high = 0;
  /// The month that is furthest outside, and how far, in index points.
  int worst_month = 0;
  float missing = 0;
  float excess = 0;
};
[[nodiscard]] YearMisfit year_misfit(Range range, const std::array<float, months>& year);

/// "too dry from May to September", "too cold in January and too warm in July"; empty where the year fits.
[[nodiscard]] std::string misfit_text(Resource resource, const YearMisfit& misfit);

/// An index with one decimal, temperature with degrees beside it: "3.2 (-4 deg C)".
[[nodiscard]] std::string index_text(Resource resource, float index);

/// "Illumination", "Temperature" or "Moisture".
[[nodiscard]] std::string resource_text(Resource resource);
[[nodiscard]] std::string month_text(int month);

/// A number with a fixed count of decimals.
[[nodiscard]] std::string number_text(double value, int decimals);
/// "45 %"
[[nodiscard]] std::string percent_text(double fraction);

}  // namespace biotope
