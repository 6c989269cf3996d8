#include "core/terrain/sun.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace biotope;

namespace {

constexpr double midsummer = 172;
constexpr double midwinter = 355;
double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

TEST_CASE("the sun's declination swings between the tropics and is nil at the equinoxes") {
  CHECK(degrees(solar_declination(midsummer)) == Approx(23.44).margin(0.05));
  CHECK(degrees(solar_declination(midwinter)) == Approx(-23.44).margin(0.05));
  CHECK(degrees(solar_declination(80)) == Approx(0).margin(0.6));
  CHECK(degrees(solar_declination(266)) == Approx(0).margin(0.6));
}

TEST_CASE("at latitude 42.85 the midsummer noon sun stands 70.6 degrees up, due south") {
  const SunPosition noon = sun_position(42.85, midsummer, 12);
  CHECK(degrees(noon.elevation) == Approx(70.6).margin(0.05));
  CHECK(degrees(noon.azimuth) == Approx(180).margin(1e-6));
}

TEST_CASE("the sun rises in the east, stands south at noon and sets in the west") {
  const SunPosition morning = sun_position(45, 80, 6);
  CHECK(degrees(morning.elevation) == Approx(0).margin(0.5));
  CHECK(degrees(morning.azimuth) == Approx(90).margin(1));
  CHECK(degrees(sun_position(45, 80, 18).azimuth) == Approx(270).margin(1));
  CHECK(degrees(sun_position(45, midsummer, 5).azimuth) < 90);
  CHECK(degrees(sun_position(45, midwinter, 9).azimuth) > 90);
}

TEST_CASE("south of the tropics the noon sun stands in the north") {
  const double azimuth = degrees(sun_position(-35, midwinter, 12).azimuth);
  CHECK(std::cos(azimuth * std::numbers::pi / 180) == Approx(1));
}

TEST_CASE("mornings mirror afternoons about noon") {
  for (const double hours : {0.5, 2.0, 5.5}) {
    const SunPosition before = sun_position(42.85, 100, 12 - hours);
    const SunPosition after = sun_position(42.85, 100, 12 + hours);
    CHECK(before.elevation == Approx(after.elevation));
    CHECK(before.azimuth == Approx(2 * std::numbers::pi - after.azimuth));
  }
}

TEST_CASE("days last 12 hours on the equator, all night or all day beyond the polar circles") {
  for (const double day : {1.0, 80.0, midsummer, 266.0, midwinter}) CHECK(day_length(0, day) == Approx(12));
  CHECK(day_length(70, midwinter) == 0);
  CHECK(day_length(70, midsummer) == Approx(24));
  CHECK(day_length(-70, midwinter) == Approx(24));
  CHECK(day_length(90, midsummer) == Approx(24));
  CHECK(day_length(-90, midsummer) == 0);
  CHECK(day_length(42.85, midsummer) == Approx(15.1).margin(0.15));
  CHECK(day_length(42.85, midsummer) + day_length(42.85, midwinter) == Approx(24).margin(0.02));
}

TEST_CASE("the sun is on the horizon when the day begins and ends") {
  for (const double latitude : {-50.0, 10.0, 42.85, 60.0}) {
    for (int month = 0; month < 12; ++month) {
      const double half = day_length(latitude, middle_day(month)) / 2;
      CHECK(sun_position(latitude, middle_day(month), 12 - half).elevation == Approx(0).margin(1e-9));
    }
  }
}

TEST_CASE("the middle day of a month lies in it") {
  CHECK(middle_day(0) == 16);
  CHECK(middle_day(5) == Approx(166.5));
  CHECK(middle_day(11) == 350);
  for (int month = 1; month < 12; ++month) CHECK(middle_day(month) - middle_day(month - 1) == Approx(30.4).margin(1.5));
}
