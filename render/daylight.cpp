#include "render/daylight.hpp"

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
};

/// From deep night to high noon; between two keys colours are interpolated.
constexpr std::array<SkyKey, 7> sky_keys{{
    {-18, {0.012F, 0.020F, 0.045F}, {0.030F, 0.042F, 0.070F}, {0.060F, 0.075F, 0.115F}},
    {-8, {0.030F, 0.055F, 0.130F}, {0.120F, 0.110F, 0.150F}, {0.050F, 0.060F, 0.090F}},
    {-2, {0.080F, 0.140F, 0.280F}, {0.480F, 0.320F, 0.270F}, {0.120F, 0.060F, 0.040F}},
    {3, {0.120F, 0.220F, 0.420F}, {0.720F, 0.520F, 0.380F}, {1.300F, 0.660F, 0.320F}},
    {10, {0.120F, 0.250F, 0.520F}, {0.640F, 0.620F, 0.580F}, {2.300F, 1.650F, 1.060F}},
    {30, {0.105F, 0.245F, 0.540F}, {0.560F, 0.670F, 0.780F}, {2.950F, 2.560F, 2.060F}},
    {90, {0.095F, 0.235F, 0.545F}, {0.540F, 0.665F, 0.790F}, {3.150F, 2.860F, 2.420F}},
}};

SkyKey sky_at(float elevation) {
  for (std::size_t i = 1; i < sky_keys.size(); ++i) {
    const SkyKey& below = sky_keys[i - 1];
    const SkyKey& above = sky_keys[i];
    if (elevation > above.elevation && i + 1 < sky_keys.size()) continue;
    const float t = glm::clamp((elevation - below.elevation) / (above.elevation - below.elevation), 0.0F, 1.0F);
    return {elevation, glm::mix(below.zenith, above.zenith, t), glm::mix(below.horizon, above.horizon, t),
            glm::mix(below.light, above.light, t)};
  }
  return sky_keys.back();
}

}  // namespace

Daylight daylight(double latitude, int month, double hour) {
  const SunPosition sun = sun_position(latitude, middle_day(month), hour);
  const float elevation = glm::degrees(float(sun.elevation));
  const SkyKey sky = sky_at(elevation);
  Daylight light;
  const auto direction = [](double height, double azimuth) {
    return glm::vec3(std::sin(azimuth) * std::cos(height), std::cos(azimuth) * std::cos(height), std::sin(height));
  };
  light.sun_direction = direction(sun.elevation, sun.azimuth);
  // Between dusk and dawn a moon stands opposite the sun, never lower than 25 degrees, so that forms keep their relief.
  const bool moonlit = elevation < -4;
  light.light_direction = moonlit ? direction(std::max(glm::radians(25.0), -sun.elevation), sun.azimuth + glm::pi<double>())
                                  : glm::normalize(light.sun_direction + glm::vec3(0, 0, elevation < 2 ? 0.08F : 0.0F));
  light.light_colour = sky.light;
  light.zenith = sky.zenith;
  light.horizon = sky.horizon;
  light.ambient_sky = 0.55F * sky.zenith + 0.35F * sky.horizon;
  light.ambient_ground = 0.16F * sky.horizon * glm::vec3(1.05F, 1.0F, 0.8F) + 0.035F * sky.light;
  light.night = glm::clamp((-2 - elevation) / 10, 0.0F, 1.0F);
  return light;
}

}  // namespace biotope
