#include "render/daylight.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/terrain/sun.hpp"
#include "render/frame.hpp"

using namespace biotope;

namespace {

/// Direct light on level ground.
glm::vec3 on_ground(const Daylight& light) { return light.light_colour * std::max(light.light_direction.z, 0.0F); }
float sum(const glm::vec3& colour) { return colour.r + colour.g + colour.b; }

Weather clouded(float cloud) {
  Weather weather;
  weather.cloud = cloud;
  return weather;
}

}  // namespace

TEST_CASE("light is there at every latitude, month and hour, from above and without a gap") {
  for (const double latitude : {-80.0, -35.0, 0.0, 42.85, 66.0, 80.0}) {
    for (const int month : {0, 2, 5, 8, 11}) {
      for (double hour = 0; hour < 24; hour += 0.5) {
        const Daylight light = biotope::daylight(latitude, month, hour);
        INFO(latitude << " degrees, month " << month << ", " << hour << " h");
        CHECK(glm::length(light.light_direction) == Approx(1).margin(1e-4));
        CHECK(light.light_direction.z > 0.03F);
        CHECK(sum(light.light_colour) > 0);
        CHECK(sum(light.ambient_sky) > 0);
        CHECK(light.exposure >= 0.9F);
        CHECK(light.night >= 0);
        CHECK(light.night <= 1);
      }
    }
  }
}

TEST_CASE("a low sun is weaker and warmer than a high one, and shade is bluer than sun") {
  const Daylight noon = biotope::daylight(42.85, 5, 12);
  const Daylight evening = biotope::daylight(42.85, 5, 19);
  CHECK(sum(on_ground(noon)) > 3 * sum(on_ground(evening)));
  CHECK(evening.light_colour.r / evening.light_colour.b > 1.5F * noon.light_colour.r / noon.light_colour.b);
  CHECK(noon.ambient_sky.b / noon.ambient_sky.r > 1.3F * noon.light_colour.b / noon.light_colour.r);
}

TEST_CASE("light changes smoothly through the day: no jump when the moon takes over") {
  for (const int month : {0, 5}) {
    Daylight before = biotope::daylight(42.85, month, 0);
    for (double hour = 0.05; hour <= 24; hour += 0.05) {
      const Daylight now = biotope::daylight(42.85, month, hour);
      INFO("month " << month << ", " << hour << " h");
      CHECK(sum(glm::abs(on_ground(now) - on_ground(before))) < 0.25F);
      CHECK(sum(glm::abs(now.horizon - before.horizon)) < 0.1F);
      before = now;
    }
  }
}

TEST_CASE("a moon that is up lights the night more than stars alone") {
  // January: it sets after three in the morning.
  const Daylight moonlit = biotope::daylight(42.85, 0, 21);
  const Daylight moonless = biotope::daylight(42.85, 0, 5);
  REQUIRE(moonlit.moon.direction.z > 0.3F);
  REQUIRE(moonless.moon.direction.z < 0);
  CHECK(sum(on_ground(moonlit)) > 1.5F * sum(on_ground(moonless)));
  CHECK(glm::dot(moonlit.light_direction, moonlit.moon.direction) > 0.99F);
}

TEST_CASE("a closed sky takes the sun, greys the light and leaves shade as bright as before") {
  const Daylight clear = under(biotope::daylight(42.85, 5, 11), clouded(0));
  const Daylight closed = under(biotope::daylight(42.85, 5, 11), clouded(1));
  CHECK(sum(closed.light_colour) < 0.15F * sum(clear.light_colour));
  CHECK(closed.zenith.b / closed.zenith.r < 0.5F * clear.zenith.b / clear.zenith.r);
  CHECK(sum(closed.ambient_sky) > 0.8F * sum(clear.ambient_sky));
  CHECK(clear.sharpness == 1);
  CHECK(closed.sharpness == 0);
  // Rain clouds are darker.
  Weather rain = clouded(1);
  rain.precipitation = 1;
  CHECK(sum(under(biotope::daylight(42.85, 5, 11), rain).ambient_sky) < sum(closed.ambient_sky));
}

TEST_CASE("the moons are those of the year 2000") {
  CHECK(moon_age(6.76) == Approx(0).margin(0.01));
  // New on 6 January with the sun, full on 21 January (4:40) opposite to it.
  const auto sun_at = [](double day, double hour) {
    const SunPosition sun = sun_position(0, day, hour);
    return glm::vec3(std::sin(sun.azimuth) * std::cos(sun.elevation), std::cos(sun.azimuth) * std::cos(sun.elevation),
                     std::sin(sun.elevation));
  };
  const Moon new_moon = moon_at(0, 7, 6.24);
  CHECK(new_moon.lit < 0.01F);
  CHECK(glm::dot(new_moon.direction, sun_at(7, 6.24)) > 0.99F);
  const Moon full = moon_at(0, 22, 0);
  CHECK(full.lit > 0.98F);
  CHECK(glm::dot(full.direction, sun_at(22, 0)) < -0.98F);
  // In the middle of every month it is bright enough to see by.
  for (int month = 0; month < 12; ++month) CHECK(moon_at(42.85, middle_day(month), 22).lit > 0.45F);
}

TEST_CASE("the moon rises about fifty minutes later every day") {
  const auto rise = [](double day) {
    for (double hour = 6; hour < 30; hour += 0.02) {
      if (moon_at(0, day, hour).direction.z > 0 && moon_at(0, day, hour - 0.02).direction.z <= 0) return hour;
    }
    return 0.0;
  };
  CHECK((rise(14) - rise(13)) * 60 == Approx(50).margin(12));
}

TEST_CASE("the stars turn once in a day and a little more") {
  const double day = sidereal_angle(100, 24) - sidereal_angle(100, 0);
  CHECK(day == Approx(glm::two_pi<double>()));
  double drift = sidereal_angle(101, 12) - sidereal_angle(100, 12);
  CHECK(drift == Approx(glm::two_pi<double>() / 365.25).margin(0.003));
}

TEST_CASE("fog takes sight down to about sixty metres") {
  FrameUniforms frame;
  Weather fog;
  const AirLayer air{0, 400, 4096, 2};
  fog.fog = 1;
  set_air(frame, fog, air);
  // 2 % of contrast is left.
  CHECK(std::exp(-frame.fog.x * 60) == Approx(0.02).margin(0.003));
  fog.fog = 0.5F;
  set_air(frame, fog, air);
  CHECK(std::exp(-frame.fog.x * 60) > 0.7F);
  fog.fog = 0;
  set_air(frame, fog, air);
  CHECK(std::exp(-frame.fog.x * 1000) > 0.8F);
}

TEST_CASE("snow lies where the climate says, lower where it is falling, and on the other side south of the equator") {
  FrameUniforms frame;
  Weather weather;
  const SnowLine line{1800, 120, 60};
  const SnowfallHeight fall{1500, 300};
  set_snow(frame, line, fall, 42, weather);
  CHECK(frame.snow == glm::vec4(1800, 120, 60, 1));
  set_snow(frame, line, fall, -42, weather);
  CHECK(frame.snow.z == -60);
  weather.precipitation = 0.5F;
  set_snow(frame, line, fall, 42, weather);
  CHECK(frame.snow.x == 1650);
  weather.snow_cover = false;
  set_snow(frame, line, fall, 42, weather);
  CHECK(frame.snow.w == 0);
}
