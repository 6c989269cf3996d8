#pragma once

#include <span>
#include <vector>

#include "core/movement/herd_cast.hpp"

namespace biotope {

/// The room that an animal's trunk and neck take on the ground: everything within `radius` of a line along its heading, m. Legs
/// and the end of the head may touch others.
struct HerdBody {
  Place at;
  Place along{0, 1};  ///< its heading, unit vector
  double back = 0;    ///< the line reaches from so far behind `at`
  double front = 0;   ///< to so far ahead of it
  double radius = 0.3;
  double speed = 0;  ///< m/s along the heading
  /// Names it among all animals; ascending where bodies are listed.
  std::uint64_t name = 0;
  const HerdCast* cast = nullptr;
};
[[nodiscard]] HerdBody herd_body(const HerdCast& cast, double size, Place at, double heading, double speed, std::uint64_t name);

/// How far two bodies reach into each other, m; 0 or less when they are apart.
[[nodiscard]] double overlap(const HerdBody& a, const HerdBody& b);
/// The same of a body and a trunk.
[[nodiscard]] double overlap(const HerdBody& body, const Stem& stem);

/// Farthest along the ground from a body that another one can matter to where it is settled, m.
inline constexpr double settling_reach = 40;

/// Moves animals that walk around trunks, and then all that stand in each other or in trunks apart, on ground that they may stand
/// on: a pure function of where they all are, whatever else is listed farther than settling_reach away, for any number of
/// threads. The heavier moves less.
void settle(const HerdWorld& world, std::vector<HerdBody>& bodies);

}  // namespace biotope
