#include "core/document/brush_shape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/base/random.hpp"

namespace biotope {
namespace {

/// Brushes are no larger than this, cells: larger than any map, small enough for whole numbers.
constexpr float greatest_radius = 1e6F;
/// Dabs beyond this fall on no map, cells.
constexpr float farthest = 1e8F;
/// The least distance between dabs, cells (our choice): closer ones cost time and show no difference.
constexpr double least_spacing = 0.5;

float turn_of(const Brush& brush, StrokePoint at) {
  float degrees = brush.stamp_turn;
  if (brush.stamp_turns_by_chance) {
    degrees +=
        360 * float(random_unit({brush.noise_seed, std::bit_cast<std::uint32_t>(at.x), std::bit_cast<std::uint32_t>(at.y)}));
  }
  return degrees * std::numbers::pi_v<float> / 180;
}

float unit(float value) { return value > 0 ? std::min(value, 1.0F) : 0; }

}  // namespace

float pressed_radius(const Brush& brush, float pressure) {
  const float radius = brush.pressure_sizes ? brush.radius * unit(pressure) : brush.radius;
  return radius > 0 ? std::min(radius, greatest_radius) : 0;
}

float pressed_strength(const Brush& brush, float pressure) {
  return unit(brush.strength) * (brush.pressure_strengthens ? unit(pressure) : 1);
}

double dab_spacing(const Brush& brush, float pressure) {
  const double spacing = double(brush.spacing) * double(pressed_radius(brush, pressure));
  return spacing > least_spacing ? spacing : least_spacing;
}

DabShape::DabShape(const Brush& brush, StrokePoint at)
    : centre_(at),
      radius_(pressed_radius(brush, at.pressure)),
      core_(std::min(unit(brush.hardness), 0.99F)),
      falloff_(brush.falloff),
      stamp_(brush.stamp && !brush.stamp->empty() ? brush.stamp.get() : nullptr) {
  if (stamp_ == nullptr) return;
  const float turn = turn_of(brush, at);
  cosine_ = std::cos(turn);
  sine_ = std::sin(turn);
}

Rect DabShape::reach() const {
  const bool somewhere = std::abs(centre_.x) < farthest && std::abs(centre_.y) < farthest;
  if (!(radius_ > 0) || !somewhere) return {};
  // A turned square reaches farther than the disk inside it.
  const int reach = int(std::ceil(stamp_ == nullptr ? radius_ : radius_ * std::numbers::sqrt2_v<float>)) + 1;
  return {int(std::floor(centre_.x)) - reach, int(std::floor(centre_.y)) - reach, int(std::ceil(centre_.x)) + reach + 1,
          int(std::ceil(centre_.y)) + reach + 1};
}

float DabShape::operator()(int x, int y) const {
  const float dx = float(x) - centre_.x;
  const float dy = float(y) - centre_.y;
  return stamp_ == nullptr ? disk_weight(dx * dx + dy * dy) : stamp_weight(dx, dy);
}

float DabShape::disk_weight(float squared_distance) const {
  if (squared_distance >= radius_ * radius_) return 0;
  const float t = std::sqrt(squared_distance) / radius_;
  if (t <= core_) return 1;
  const float u = std::min(1.0F, (t - core_) / (1 - core_));
  switch (falloff_) {
    case Falloff::smooth:
      return 1 - u * u * (3 - 2 * u);
    case Falloff::linear:
      return 1 - u;
    case Falloff::sphere:
      return std::sqrt(1 - u * u);
    case Falloff::sharp:
      return (1 - u) * (1 - u);
  }
  return 0;
}

float DabShape::stamp_weight(float dx, float dy) const {
  // Back from the turned square to the stamp's own pixels; outside of it the weight is 0.
  const float u = (dx * cosine_ + dy * sine_) / radius_;
  const float v = (dy * cosine_ - dx * sine_) / radius_;
  if (std::abs(u) > 1.5F || std::abs(v) > 1.5F) return 0;
  const float px = (u + 1) * 0.5F * float(stamp_->width()) - 0.5F;
  const float py = (v + 1) * 0.5F * float(stamp_->height()) - 0.5F;
  const int x = int(std::floor(px));
  const int y = int(std::floor(py));
  const float fx = px - float(x);
  const float fy = py - float(y);
  const auto at = [&](int sx, int sy) { return stamp_->contains(sx, sy) ? (*stamp_)(sx, sy) : 0.0F; };
  const float north = at(x, y) + (at(x + 1, y) - at(x, y)) * fx;
  const float south = at(x, y + 1) + (at(x + 1, y + 1) - at(x, y + 1)) * fx;
  return unit(north + (south - north) * fy);
}

}  // namespace biotope
