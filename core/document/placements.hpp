#pragma once

#include <vector>

#include "core/ecosystem/places.hpp"
#include "core/movement/plan_edits.hpp"
#include "core/terrain/drawn_water.hpp"

namespace biotope {

/// Everything a person drew or placed that is no paint.
struct Placements {
  DrawnWater water;
  Places places;
  std::vector<PlanEdit> plans;
  bool operator==(const Placements&) const = default;
};

}  // namespace biotope
