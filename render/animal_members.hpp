#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// One animal of a herd, where it stands at an hour.
struct HerdMember {
  /// Metres east and north of the terrain's south-west corner.
  glm::dvec2 place{0};
  float heading = 0;   ///< radians clockwise from north
  float walked = 0;    ///< m it would have walked at its flat pace since midnight; drives the legs
  float speed = 0;     ///< m/s
  float head_down = 0; ///< 0 up .. 1 at the ground
  float size = 1;      ///< of the species' size; the young are smaller
};

/// The members of a herd at an hour: a pure function of (plan, hour, seed). Walking, they follow each other in file along the herd's way; standing, they
/// spread over the ground around it. Nobody stands in water deeper than the herd's own place.
[[nodiscard]] std::vector<HerdMember> herd_members(const MapsSnapshot& maps, const DailyPlan& plan, std::size_t plan_number, double hour);

}  // namespace biotope
