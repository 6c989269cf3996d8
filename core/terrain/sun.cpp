#include "core/terrain/sun.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace biotope {
namespace {
constexpr double pi = std::numbers::pi;
constexpr double radians(double degrees) { return degrees * pi / 180; }
}  // namespace

double solar_declination(double day_of_year) {
  const double j = 2 * pi * day_of_year / 365.25;
  return std::asin(0.3978 * std::sin(j - 1.4 + 0.0355 * std::sin(j - 0.0489)));
}

SunPosition sun_position(double latitude, double day_of_year, double hour) {
  const double phi = radians(latitude);
  const double declination = solar_declination(day_of_year);
  const double hour_angle = (hour - 12) * pi / 12;
  const double east = -std::cos(declination) * std::sin(hour_angle);
  const double north = std::sin(declination) * std::cos(phi) - std::cos(declination) * std::sin(phi) * std::cos(hour_angle);
  const double up = std::sin(phi) * std::sin(declination) + std::cos(phi) * std::cos(declination) * std::cos(hour_angle);
  double azimuth = std::atan2(east, north);
  if (azimuth < 0) azimuth += 2 * pi;
  return {std::asin(std::clamp(up, -1.0, 1.0)), azimuth};
}

double day_length(double latitude, double day_of_year) {
  const double cosine = -std::tan(radians(latitude)) * std::tan(solar_declination(day_of_year));
  return 24 / pi * std::acos(std::clamp(cosine, -1.0, 1.0));
}

double middle_day(int month) {
  constexpr std::array<double, 13> first_day{1, 32, 60, 91, 121, 152, 182, 213, 244, 274, 305, 335, 366};
  const auto m = std::size_t(month);
  return (first_day[m] + first_day[m + 1] - 1) / 2;
}

}  // namespace biotope
