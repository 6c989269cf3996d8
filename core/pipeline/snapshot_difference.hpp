#pragma once

#include <string>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// The first result in which two complete snapshots differ by as much as a bit, as text ("cover of quercus"); empty when they
/// hold the same. What they were made from, timings and revisions are not compared.
[[nodiscard]] std::string snapshot_difference(const MapsSnapshot& a, const MapsSnapshot& b);

}  // namespace biotope
