#include "render/ford_look.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Water in the middle of a ford, m; wider by this share; and as rough.
constexpr float shallow = 0.16F;
constexpr float widening = 0.35F;
constexpr float riffle = 0.62F;
/// Shares of a ford's radius within which it is all ford, and at which it ends.
constexpr double whole = 0.45;
constexpr double end = 1.25;

}  // namespace

float FordLook::share(double x, double y) const {
  double most = 0;
  for (const FordDisc& disc : discs_) {
    const double away = std::hypot(x - disc.x, y - disc.y) / std::max(disc.radius, 1e-3);
    const double t = std::clamp((end - away) / (end - whole), 0.0, 1.0);
    most = std::max(most, t * t * (3 - 2 * t));
  }
  return float(most);
}

float ford_depth(float depth, float share) { return depth + (std::min(depth, shallow) - depth) * share; }
float ford_half_width(float half_width, float share) { return half_width * (1 + widening * share); }
float ford_roughness(float share) { return riffle * share; }

}  // namespace biotope
