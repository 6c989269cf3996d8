#pragma once

#include <array>

#include "core/ecosystem/confinement.hpp"

namespace biotope {

/// Crossing shallow water takes this many times longer than dry ground. Our choice.
inline constexpr float wading_factor = 3.0F;
/// Ground that a straight line would cross but an animal walks around: the detour's cost per metre, our choice.
inline constexpr float detour_factor = 3.0F;
/// A metre on a worn trail costs this much of a metre beside it, so that trails merge. Our choice, within 0.5 to 0.7.
inline constexpr float worn_factor = 0.6F;

/// Cost of a metre of ground by its slope, in metres of flat walking: v_flat / v(S), from a table.
class WalkCost {
 public:
  explicit WalkCost(const Mobility& mobility);

  /// At a signed slope (rise / run); beyond the species' limit the cost of going around.
  [[nodiscard]] float operator()(float slope) const {
    const float position = (slope + reach_) * scale_;
    if (!(position >= 0 && position <= float(samples))) return beyond_;
    const auto index = std::size_t(position);
    const float fraction = position - float(index);
    return table_[index] + (table_[index + 1] - table_[index]) * fraction;
  }
  /// Cost of a metre on the easiest slope, -0.05.
  [[nodiscard]] float easiest() const { return easiest_; }

 private:
  static constexpr int samples = 512;
  std::array<float, samples + 2> table_{};
  float reach_ = 1;
  float scale_ = 1;
  float beyond_ = 1;
  float easiest_ = 1;
};

}  // namespace biotope
