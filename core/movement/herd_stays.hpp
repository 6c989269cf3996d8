#pragma once

#include <vector>

#include "core/movement/herd_world.hpp"

namespace biotope {

/// Half the width of the room that a standing herd takes, m: its members stand about this far from its middle.
[[nodiscard]] double herd_radius(double body_length, int members);

/// A herd's stay at one stop of its day.
struct HerdStay {
  int plan = 0;
  std::size_t stop = 0;
  Place centre;  ///< the plan's place in the middle of the stay
  double arrive = 0;
  double leave = 0;  ///< hours as in the plan
  double body_length = 1;
  int members = 0;
  bool at_water = false;
  bool operator==(const HerdStay&) const = default;
};

/// All stays of a day, to tell which herds share a place. A pure function of the world.
class HerdStays {
 public:
  explicit HerdStays(const HerdWorld& world);
  /// Stays of plans with lower numbers at the same place (their room meets this one's) and time as a stop of `plan`, by rising
  /// number.
  [[nodiscard]] std::vector<HerdStay> before(int plan, std::size_t stop) const;

 private:
  /// By rising x of their centres.
  std::vector<HerdStay> stays_;
  double widest_ = 0;
};

}  // namespace biotope
