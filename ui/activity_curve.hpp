#pragma once

#include <vector>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// Share of the animals that are not resting, for each half hour of the day; empty while there are no plans. Quick: reads the
/// plans only.
[[nodiscard]] std::vector<float> activity_curve(const MapsSnapshot& snapshot);

}  // namespace biotope
