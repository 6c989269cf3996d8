#include "ui/follow_arm.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace biotope {

namespace {

/// Arms longer than this look over trees, m; plants are looked up anew when the animal has gone so far.
constexpr double longest_arm = 60;
constexpr double walked = 10;
/// Where the camera is looked for, from far to near.
constexpr std::array<double, 8> shares{1, 0.86, 0.72, 0.6, 0.48, 0.38, 0.28, 0.2};
/// Seconds in which most of the way to a shorter or longer arm is made.
constexpr double shorter_within = 0.25;
constexpr double longer_within = 1.5;

}  // namespace

double FollowArm::share(const PlantPlacement& plants, const glm::dvec3& animal, const glm::dvec3& eye, double seconds) {
  const double length = glm::length(eye - animal);
  double wanted = 1;
  if (plants.snapshot() != nullptr && length < longest_arm) {
    if (!around_ || of_ != plants.snapshot() || glm::length(animal - middle_) > walked) {
      around_.emplace(plants, animal, longest_arm + walked);
      of_ = plants.snapshot();
      middle_ = animal;
    }
    for (const double share : shares) {
      if (!around_->free(animal + share * (eye - animal), animal)) continue;
      wanted = share;
      break;
    }
  }
  const double within = wanted < share_ ? shorter_within : longer_within;
  share_ += (wanted - share_) * (1 - std::exp(-std::max(seconds, 0.0) / within));
  return share_;
}

}  // namespace biotope
