#include "core/climate/snow_cover.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace biotope {
namespace {

constexpr std::array<int, months> days_in_month{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
constexpr double middle_of_month = 15;
/// Mean temperatures at which all and nothing of what falls is solid, deg C.
constexpr double all_solid = -1;
constexpr double none_solid = 3;
/// Most snow that is left when a month's snow is least, mm of water. Our choice.
constexpr double most_old_snow = 1500;
/// Years until the snow of a year repeats itself (what lies longer is capped).
constexpr int spin_up_years = 3;
/// Snow that covers nearly nothing, half and nearly all of the ground, mm of water. Our choice: snow lies in patches first.
constexpr double scattered_snow = 1.5;
constexpr double patchy_snow = 8;
constexpr double closed_snow = 25;
/// Heights at which the line is looked for, m.
constexpr double lowest_height = -500;
constexpr double highest_height = 8500;
constexpr double height_step = 60;
/// Least spread and aspect: days differ from the mean of their month, and sun melts snow below freezing too. Our choice.
constexpr double least_spread = 80;
constexpr double least_aspect = 50;
constexpr double most_spread = 450;
constexpr double most_aspect = 350;

/// Between the middles of two months.
double between(const MonthlyValues& values, int month, double day) {
  const double from_middle = (day - middle_of_month) / 30.5;
  const int other = (month + (from_middle < 0 ? months - 1 : 1)) % months;
  const double t = std::abs(from_middle);
  return values[std::size_t(month)] * (1 - t) + values[std::size_t(other)] * t;
}

/// One day's change of the snow: what falls solid, less what melts.
double after_a_day(double snow, double temperature, double precipitation, double factor) {
  return std::max(0.0, snow + solid_share(temperature) * precipitation - factor * std::max(0.0, temperature));
}

/// The height at which the snow of a month reaches `amount`, by heights of the table.
double height_of(const std::vector<MonthlyValues>& table, std::size_t month, double amount) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double here = table[i][month];
    if (here < amount) continue;
    if (i == 0) return lowest_height;
    const double below = table[i - 1][month];
    return lowest_height + height_step * (double(i - 1) + (amount - below) / (here - below));
  }
  return no_snow_line;
}

std::vector<MonthlyValues> snow_by_height(const Climate& climate, SnowExposure exposure) {
  std::vector<MonthlyValues> table;
  for (double height = lowest_height; height <= highest_height; height += height_step) {
    table.push_back(snow_water(climate, height, exposure));
  }
  return table;
}

}  // namespace

double solid_share(double temperature) { return std::clamp((none_solid - temperature) / (none_solid - all_solid), 0.0, 1.0); }

double mean_temperature(const Climate& climate, int month, double height) {
  return climate.temperature_mean[std::size_t(month)] - climate.lapse_rate * (height - climate.reference_height) / 1000;
}

SnowfallHeight snowfall_height(const Climate& climate, int month) {
  const double sea_level = mean_temperature(climate, month, 0);
  const double half_solid = 0.5 * (all_solid + none_solid);
  if (climate.lapse_rate <= 0) return {sea_level < half_solid ? -no_snow_line : no_snow_line, 1};
  return {1000 * (sea_level - half_solid) / climate.lapse_rate, 500 * (none_solid - all_solid) / climate.lapse_rate};
}

double melt_factor(SnowExposure exposure) {
  switch (exposure) {
    case SnowExposure::shaded:
      return 2;
    case SnowExposure::sunny:
      return 5;
    case SnowExposure::level:
      break;
  }
  return 3.2;
}

MonthlyValues snow_water(const Climate& climate, double height, SnowExposure exposure) {
  const double colder = climate.lapse_rate * (height - climate.reference_height) / 1000;
  const double factor = melt_factor(exposure);
  MonthlyValues middle{};
  double snow = 0;
  for (int year = 0; year <= spin_up_years; ++year) {
    double least = snow;
    for (int month = 0; month < months; ++month) {
      const auto m = std::size_t(month);
      const double daily = climate.precipitation[m] / days_in_month[m];
      for (int day = 1; day <= days_in_month[m]; ++day) {
        snow = after_a_day(snow, between(climate.temperature_mean, month, day) - colder, daily, factor);
        if (day == int(middle_of_month)) middle[m] = snow;
      }
      least = std::min(least, snow);
    }
    const double ice = std::max(0.0, least - most_old_snow);
    snow -= ice;
    for (double& amount : middle) amount -= ice;
  }
  return middle;
}

std::array<SnowLine, months> snow_lines(const Climate& climate) {
  std::array<SnowLine, months> lines;
  if (climate.lapse_rate <= 0) {
    const MonthlyValues snow = snow_water(climate, climate.reference_height);
    for (std::size_t m = 0; m < lines.size(); ++m)
      lines[m] = {snow[m] >= patchy_snow ? -no_snow_line : no_snow_line, least_spread, 0};
    return lines;
  }
  const std::vector<MonthlyValues> level = snow_by_height(climate, SnowExposure::level);
  const std::vector<MonthlyValues> shaded = snow_by_height(climate, SnowExposure::shaded);
  for (std::size_t m = 0; m < lines.size(); ++m) {
    const double line = height_of(level, m, patchy_snow);
    lines[m] = {line, least_spread, 0};
    if (line >= no_snow_line) continue;
    const double low = height_of(level, m, scattered_snow);
    const double high = std::min(height_of(level, m, closed_snow), line + most_spread);
    lines[m].spread = std::clamp(0.5 * (high - low), least_spread, most_spread);
    lines[m].aspect = std::clamp(line - height_of(shaded, m, patchy_snow), least_aspect, most_aspect);
  }
  return lines;
}

}  // namespace biotope
