#pragma once

#include <glm/glm.hpp>

namespace biotope {

/// Light of one moment in linear colour: what sky, ground, plants and animals are lit by. All values are our choice, made to look natural.
struct Daylight {
  /// Toward the light that casts shadows: the sun, or at night a moon that keeps the land readable.
  glm::vec3 light_direction{0, 0, 1};
  glm::vec3 light_colour{1, 1, 1};
  /// Toward the sun itself, also when it is below the horizon.
  glm::vec3 sun_direction{0, 0, 1};
  glm::vec3 ambient_sky{0.3F, 0.4F, 0.5F};
  glm::vec3 ambient_ground{0.15F, 0.14F, 0.1F};
  glm::vec3 horizon{0.6F, 0.7F, 0.8F};
  glm::vec3 zenith{0.15F, 0.3F, 0.6F};
  /// 0 by day, 1 in the deep of night.
  float night = 0;
};

/// Light at a latitude (degrees), month (0 is January) and local solar hour.
[[nodiscard]] Daylight daylight(double latitude, int month, double hour);

}  // namespace biotope
