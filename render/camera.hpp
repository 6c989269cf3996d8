#pragma once

#include <glm/glm.hpp>

namespace biotope {

/// A point of view in metres: x east and y north from the terrain's south-west corner, z up (above sea level).
struct Camera {
  glm::dvec3 position{0, 0, 100};
  float heading = 0;          ///< degrees clockwise from north
  float pitch = -10;          ///< degrees above the horizon
  float vertical_field = 50;  ///< degrees

  bool operator==(const Camera&) const = default;
  [[nodiscard]] glm::vec3 forward() const;
  [[nodiscard]] glm::vec3 right() const;
};

}  // namespace biotope
