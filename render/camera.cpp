#include "render/camera.hpp"

#include <cmath>

namespace biotope {

glm::vec3 Camera::forward() const {
  const float turn = glm::radians(heading);
  const float rise = glm::radians(pitch);
  return {std::sin(turn) * std::cos(rise), std::cos(turn) * std::cos(rise), std::sin(rise)};
}

glm::vec3 Camera::right() const {
  const float turn = glm::radians(heading);
  return {std::cos(turn), -std::sin(turn), 0};
}

}  // namespace biotope
