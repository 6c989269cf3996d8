#pragma once

#include <glm/glm.hpp>

namespace biotope {

/// The moon of one moment.
struct Moon {
  glm::vec3 direction{0, 0, -1};  ///< toward it; z below 0: it has set
  float lit = 0;                  ///< share of its disc that the sun lights, 0 new .. 1 full
};

/// Days since new moon on a day of the year (1..366, fractions allowed), 0..29.53. A year of ours has no number, so it has the
/// moons of the year 2000, whose first new moon was on 6 January at 18:14 (Meeus, Astronomical Algorithms): in the middle of
/// every month the moon is then between its first quarter and a few days past full.
[[nodiscard]] double moon_age(double day_of_year);

/// Moon at a latitude (degrees), day of the year and local solar hour. It keeps to the ecliptic (the true one strays by 5
/// degrees).
[[nodiscard]] Moon moon_at(double latitude, double day_of_year, double hour);

/// Right ascension of the sun plus its hour angle: how far the stars have turned, radians.
[[nodiscard]] double sidereal_angle(double day_of_year, double hour);

}  // namespace biotope
