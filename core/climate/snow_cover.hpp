#pragma once

#include <array>

#include "core/climate/climate.hpp"

namespace biotope {

/// Share of precipitation that falls as snow at a temperature (deg C): 1 up to -1, 0 from +3, linear between.
[[nodiscard]] double solid_share(double temperature);

/// Monthly mean temperature at `height` m by the climate's lapse rate, deg C.
[[nodiscard]] double mean_temperature(const Climate& climate, int month, double height);

/// Where precipitation turns from rain into snow in a month: half of it is solid at mean temperature there (+1 deg C), all of it
/// `spread` metres higher, nothing `spread` metres lower.
struct SnowfallHeight {
  double height = 0;  ///< m
  double spread = 0;  ///< m
};
[[nodiscard]] SnowfallHeight snowfall_height(const Climate& climate, int month);

/// How fast snow melts on a slope, mm of water for each deg C above freezing and day. Our choice within the usual 2..5.
enum class SnowExposure { shaded, level, sunny };
[[nodiscard]] double melt_factor(SnowExposure exposure);

/// Snow that lies in the middle of every month at `height` m, mm of water. Daily: precipitation spread evenly over a month, daily
/// mean temperature between those of the months, solid share as above, melt by degree-days; the same year again and again until
/// it repeats itself. Of snow that outlasts the summer no more than 1500 mm stay: the rest is ice that flows off.
[[nodiscard]] MonthlyValues snow_water(const Climate& climate, double height, SnowExposure exposure = SnowExposure::level);

/// Where snow covers the ground in a month.
struct SnowLine {
  /// Half of level ground is covered at this height, m; nearly nothing `spread` metres lower, nearly all `spread` metres higher.
  double height = 0;
  double spread = 0;
  /// On slopes turned away from the noon sun snow lies this much lower, on those turned to it as much higher, m.
  double aspect = 0;

  bool operator==(const SnowLine&) const = default;
};
/// Height of a line that no ground reaches, m.
inline constexpr double no_snow_line = 20000;

/// Snow lines of the twelve months. A climate that does not cool with height has snow everywhere (a line at -no_snow_line) or
/// nowhere.
[[nodiscard]] std::array<SnowLine, months> snow_lines(const Climate& climate);

}  // namespace biotope
