#include "render/daylight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/terrain/sun.hpp"

namespace biotope {

namespace {

/// Colours at one elevation of the sun.
struct SkyKey {
  float elevation;  ///< degrees
  glm::vec3 zenith;
  glm::vec3 horizon;
  glm::vec3 light;
  glm::vec3 glow;
  float exposure;
};

/// From deep night to high noon; between two keys colours are interpolated.
constexpr std::array<SkyKey, 9> sky_keys{{
    {-18, {0.0035F, 0.0060F, 0.0150F}, {0.0090F, 0.0130F, 0.0240F}, {0, 0, 0}, {0, 0, 0}, 3.6F},
    {-12, {0.0060F, 0.0120F, 0.0340F}, {0.0180F, 0.0240F, 0.0460F}, {0, 0, 0}, {0.030F, 0.018F, 0.014F}, 3.3F},
    {-6, {0.0130F, 0.0420F, 0.1200F}, {0.0700F, 0.0960F, 0.1420F}, {0.020F, 0.014F, 0.016F}, {0.330F, 0.120F, 0.040F}, 2.9F},
    {-2, {0.0340F, 0.1000F, 0.2350F}, {0.2500F, 0.2380F, 0.2520F}, {0.200F, 0.090F, 0.060F}, {0.900F, 0.330F, 0.080F}, 2.2F},
    {1.5F, {0.0560F, 0.1500F, 0.3400F}, {0.4150F, 0.3900F, 0.3800F}, {1.250F, 0.600F, 0.260F}, {1.300F, 0.560F, 0.170F}, 1.65F},
    {6, {0.0760F, 0.1800F, 0.4200F}, {0.5000F, 0.4900F, 0.5000F}, {2.250F, 1.400F, 0.740F}, {1.100F, 0.640F, 0.290F}, 1.34F},
    {14, {0.0730F, 0.1950F, 0.4700F}, {0.5000F, 0.5800F, 0.6700F}, {2.800F, 2.100F, 1.400F}, {0.700F, 0.500F, 0.320F}, 1.07F},
    {32, {0.0660F, 0.1900F, 0.4900F}, {0.4600F, 0.6050F, 0.7700F}, {3.150F, 2.680F, 2.100F}, {0.330F, 0.290F, 0.240F}, 0.98F},
    {90, {0.0580F, 0.1780F, 0.4900F}, {0.4300F, 0.6000F, 0.7900F}, {3.300F, 2.980F, 2.520F}, {0.260F, 0.240F, 0.210F}, 0.94F},
}};

SkyKey sky_at(float elevation) {
  for (std::size_t i = 1; i < sky_keys.size(); ++i) {
    const SkyKey& below = sky_keys[i - 1];
    const SkyKey& above = sky_keys[i];
    if (elevation > above.elevation && i + 1 < sky_keys.size()) continue;
    const float t = glm::clamp((elevation - below.elevation) / (above.elevation - below.elevation), 0.0F, 1.0F);
    const auto mixed = [&](const auto& of) { return glm::mix(below.*of, above.*of, t); };
    return {elevation,
            mixed(&SkyKey::zenith),
            mixed(&SkyKey::horizon),
            mixed(&SkyKey::light),
            mixed(&SkyKey::glow),
            mixed(&SkyKey::exposure)};
  }
  return sky_keys.back();
}

glm::vec3 direction(double height, double azimuth) {
  return {std::sin(azimuth) * std::cos(height), std::cos(azimuth) * std::cos(height), std::sin(height)};
}

/// Light of a full moon high in the sky, and of the darkest night sky, which keeps the land readable.
constexpr glm::vec3 full_moon_light{0.098F, 0.120F, 0.163F};
constexpr glm::vec3 starlight{0.022F, 0.028F, 0.042F};

/// Sets what moon and stars give; `dark` is 0 by day and 1 once the sun's light is gone.
void set_night_light(Daylight& light, float dark) {
  if (dark <= 0) return;
  const float height = glm::smoothstep(-0.02F, 0.25F, light.moon.direction.z);
  const float moonlight = height * light.moon.lit * light.moon.lit;
  glm::vec3 toward = light.moon.direction;
  // A moon near the horizon, or none: light from high up that side of the sky, so that forms keep their relief.
  toward.z = std::max(toward.z, 0.35F);
  light.light_direction = glm::normalize(toward);
  light.light_colour = dark * (full_moon_light * moonlight + starlight);
  light.shadows = std::max(light.shadows * (1 - dark), dark * moonlight / (moonlight + 0.12F));
  light.zenith += dark * moonlight * glm::vec3(0.005F, 0.009F, 0.020F);
  light.horizon += dark * moonlight * glm::vec3(0.008F, 0.011F, 0.018F);
}

}  // namespace

Daylight daylight(double latitude, int month, double hour) {
  const double day = middle_day(month);
  const SunPosition sun = sun_position(latitude, day, hour);
  const float elevation = glm::degrees(float(sun.elevation));
  const SkyKey sky = sky_at(elevation);
  Daylight light;
  light.moon = moon_at(latitude, day, hour);
  light.sidereal = float(sidereal_angle(day, hour));
  light.sun_direction = direction(sun.elevation, sun.azimuth);
  // The last light comes from the bright sky above the place where the sun went down.
  light.light_direction = direction(std::max(sun.elevation, glm::radians(2.5)), sun.azimuth);
  light.light_colour = sky.light;
  light.zenith = sky.zenith;
  light.horizon = sky.horizon;
  light.glow = sky.glow;
  light.exposure = sky.exposure;
  light.shadows = glm::smoothstep(-2.5F, 1.0F, elevation);
  light.night = glm::clamp((-2 - elevation) / 10, 0.0F, 1.0F);
  set_night_light(light, elevation < -6 ? glm::smoothstep(6.0F, 10.0F, -elevation) : 0.0F);
  // In shade one sees the blue of the sky above; from below comes what sunlit ground sends back.
  light.ambient_sky = 0.62F * light.zenith + 0.30F * light.horizon + 0.03F * light.glow;
  light.ambient_ground = 0.11F * light.horizon * glm::vec3(1.1F, 1.0F, 0.78F) + 0.034F * light.light_colour;
  // With the sun low most of the light is the sky's.
  light.ambient_sky *= 1 + glm::mix(0.85F, 0.45F, light.night) * glm::smoothstep(20.0F, 4.0F, elevation);
  light.ambient_sky += light.night * glm::vec3(0.006F, 0.008F, 0.013F);
  return light;
}

Daylight under(const Daylight& clear, const Weather& weather) {
  Daylight light = clear;
  // Scattered clouds only throw shadows; from half of the sky on they close to a veil.
  const float closed = glm::smoothstep(0.5F, 1.0F, weather.cloud);
  const float murk = std::max(closed, glm::smoothstep(0.0F, 0.6F, weather.fog));
  const float dark = 1 - 0.42F * weather.precipitation * closed;
  const float horizon_light = glm::dot(clear.horizon, glm::vec3(0.3F, 0.4F, 0.3F));
  const float sun_light = glm::dot(clear.light_colour, glm::vec3(0.3F, 0.5F, 0.2F)) * std::max(clear.light_direction.z, 0.0F);
  const glm::vec3 grey_tone = glm::mix(glm::vec3(0.93F, 1.0F, 1.08F), glm::vec3(0.86F, 0.97F, 1.2F), clear.night);
  const glm::vec3 grey = grey_tone * (0.55F * horizon_light + 0.13F * sun_light) * dark;
  light.sharpness = 1 - murk;
  light.shadows = clear.shadows * light.sharpness;
  light.light_colour = clear.light_colour * glm::mix(1.0F, 0.10F * dark, murk);
  light.glow = clear.glow * glm::mix(1.0F, 0.06F, murk);
  light.horizon = glm::mix(clear.horizon, grey * 1.12F, murk);
  light.zenith = glm::mix(clear.zenith, grey * glm::mix(0.86F, 1.0F, weather.fog), murk);
  const float thin = 0.55F * weather.cloud * (1 - murk);
  light.ambient_sky = glm::mix(clear.ambient_sky * (1 + 0.25F * thin), grey * 1.18F, murk);
  light.ambient_ground = glm::mix(clear.ambient_ground, grey * glm::vec3(0.30F, 0.28F, 0.22F), murk);
  light.exposure = clear.exposure * glm::mix(1.0F, 1.10F, murk);
  return light;
}

}  // namespace biotope
