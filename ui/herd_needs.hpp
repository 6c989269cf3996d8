#pragma once

#include <string>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// One thing that a herd must have, and what its day gives of it.
struct HerdNeed {
  std::string name;  ///< "Water", or the need's name in the species file
  double hours = 0;  ///< spent a day where it is found
  int places = 0;    ///< that the herd visits for it
  int herds = 0;     ///< that it follows for it; then these are its places
  bool now = false;  ///< it is there at the hour asked for
  /// Painted numbers ask for more than there is in the herd's region.
  bool short_supply = false;
  [[nodiscard]] bool met() const { return places > 0 && !short_supply; }
};

/// What a herd does until when, and what it needs.
struct HerdOutlook {
  std::string doing;  ///< "feeding", "walking" ...
  std::string where;  ///< the resource it is at or walks to; empty when it is on its way with another herd
  double until = 0;   ///< hour at which that ends
  /// Hours of the day it is awake.
  double awake = 0;
  std::vector<HerdNeed> needs;
};

/// The state of a herd at an hour, from its plan alone.
[[nodiscard]] HerdOutlook herd_outlook(const MapsSnapshot& maps, const DailyPlan& plan, double hour);

}  // namespace biotope
