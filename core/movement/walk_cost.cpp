#include "core/movement/walk_cost.hpp"

#include <algorithm>
#include <cmath>

#include "core/movement/travel.hpp"

namespace biotope {

float walking_speed(float flat_speed, float slope, float slope_sensitivity, float max_slope) {
  if (std::abs(slope) > max_slope) return 0;
  return flat_speed * std::exp(-slope_sensitivity * (std::abs(slope + 0.05F) - 0.05F));
}

WalkCost::WalkCost(const Mobility& mobility)
    : reach_(std::max(mobility.max_slope, 0.01F)), easiest_(std::exp(-0.05F * mobility.slope_sensitivity)) {
  scale_ = float(samples) / (2 * reach_);
  for (int i = 0; i < samples + 2; ++i) {
    const float slope = float(i) / scale_ - reach_;
    table_[std::size_t(i)] = std::exp(mobility.slope_sensitivity * (std::abs(slope + 0.05F) - 0.05F));
  }
  beyond_ = detour_factor * std::max(table_.front(), table_[samples]);
}

}  // namespace biotope
