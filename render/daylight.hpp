#pragma once

#include <glm/glm.hpp>

#include "render/moon.hpp"
#include "render/weather.hpp"

namespace biotope {

/// Light of one moment in linear colour: what sky, ground, plants and animals are lit by. All values are our choice, made to look
/// natural.
struct Daylight {
  /// Toward the light that casts shadows: the sun, the glow it leaves at dusk, or the moon; on nights without a moon the
  /// brightest part of the sky.
  glm::vec3 light_direction{0, 0, 1};
  glm::vec3 light_colour{1, 1, 1};
  /// Toward the sun itself, also when it is below the horizon.
  glm::vec3 sun_direction{0, 0, 1};
  glm::vec3 ambient_sky{0.3F, 0.4F, 0.5F};
  glm::vec3 ambient_ground{0.15F, 0.14F, 0.1F};
  glm::vec3 horizon{0.6F, 0.7F, 0.8F};
  glm::vec3 zenith{0.15F, 0.3F, 0.6F};
  /// Light that the air around the sun sends, also for a while after it has set.
  glm::vec3 glow{0};
  /// 0 by day, 1 in the deep of night.
  float night = 0;
  /// What the eye makes of it: light is multiplied by this before it is shown.
  float exposure = 1;
  /// Share of the sun's disc and of sharp shadows that clouds leave, 0..1.
  float sharpness = 1;
  /// How much of the light comes from one side and throws shadows, 0..1: little at dusk, without a moon, under clouds.
  float shadows = 1;
  Moon moon;
  /// Hour angle of the vernal equinox: how far the stars have turned, radians.
  float sidereal = 0;
};

/// Light under a clear sky at a latitude (degrees), in the middle of a month (0 is January) and at a local solar hour.
[[nodiscard]] Daylight daylight(double latitude, int month, double hour);

/// The same light under a weather: clouds, rain and fog take the sun's light, grey the sky and soften the shadows.
[[nodiscard]] Daylight under(const Daylight& clear, const Weather& weather);

}  // namespace biotope
