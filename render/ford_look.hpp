#pragma once

#include <vector>

#include "core/ecosystem/ford_discs.hpp"

namespace biotope {

/// How fords are drawn: there a river is wider and shallower, and breaks over stones.
class FordLook {
 public:
  FordLook() = default;
  explicit FordLook(std::vector<FordDisc> discs) : discs_(std::move(discs)) {}
  /// Of the fords that were found and those that a person placed.
  explicit FordLook(const Ground& ground) : discs_(ford_discs(ground)) {}

  /// How much of a ford a place (column and row) is: 1 in its middle, 0 beyond its disc.
  [[nodiscard]] float share(double x, double y) const;

 private:
  std::vector<FordDisc> discs_;
};

/// Depth of water (m) and half the width of a river (m) where a share of a ford is, and how rough the ford makes it at least (as
/// in water_flow). Our choices: to the hock of a deer, a third wider.
[[nodiscard]] float ford_depth(float depth, float share);
[[nodiscard]] float ford_half_width(float half_width, float share);
[[nodiscard]] float ford_roughness(float share);

}  // namespace biotope
