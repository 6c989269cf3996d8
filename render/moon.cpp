#include "render/moon.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace biotope {

namespace {

constexpr double synodic_month = 29.530589;
/// New moon of 2000 January 6, 18:14, as a day of the year.
constexpr double first_new_moon = 6.76;
/// Obliquity of the ecliptic whose sine is the 0.3978 of solar_declination.
const double obliquity = std::asin(0.3978);

/// Longitude of the sun on the ecliptic, as in solar_declination, radians.
double solar_longitude(double day_of_year) {
  const double j = glm::two_pi<double>() * day_of_year / 365.25;
  return j - 1.4 + 0.0355 * std::sin(j - 0.0489);
}

double right_ascension(double longitude) { return std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)); }

}  // namespace

double moon_age(double day_of_year) {
  const double age = std::fmod(day_of_year - first_new_moon, synodic_month);
  return age < 0 ? age + synodic_month : age;
}

double sidereal_angle(double day_of_year, double hour) {
  return right_ascension(solar_longitude(day_of_year)) + (hour - 12) * glm::pi<double>() / 12;
}

Moon moon_at(double latitude, double day_of_year, double hour) {
  const double moment = day_of_year + (hour - 12) / 24;
  const double elongation = glm::two_pi<double>() * moon_age(moment) / synodic_month;
  const double longitude = solar_longitude(moment) + elongation;
  const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));
  const double hour_angle = sidereal_angle(day_of_year, hour) - right_ascension(longitude);
  const double phi = glm::radians(latitude);
  Moon moon;
  moon.direction =
      glm::vec3(-std::cos(declination) * std::sin(hour_angle),
                std::sin(declination) * std::cos(phi) - std::cos(declination) * std::sin(phi) * std::cos(hour_angle),
                std::sin(phi) * std::sin(declination) + std::cos(phi) * std::cos(declination) * std::cos(hour_angle));
  moon.lit = float(0.5 - 0.5 * std::cos(elongation));
  return moon;
}

}  // namespace biotope
