#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "ui/plant_pick.hpp"

namespace biotope {

/// Keeps a camera that goes along with an animal out of leaves and trunks: its arm is shortened, not at once, until the animal is
/// in sight.
class FollowArm {
 public:
  /// Share of the way from the animal to where the camera would be (metres above it included), 0.2 .. 1, `seconds` after the last
  /// call.
  [[nodiscard]] double share(const PlantPlacement& plants, const glm::dvec3& animal, const glm::dvec3& eye, double seconds);
  void reset() { *this = {}; }

 private:
  std::optional<PlantsAround> around_;
  const MapsSnapshot* of_ = nullptr;
  glm::dvec3 middle_{0};
  double share_ = 1;
};

}  // namespace biotope
