#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "core/base/random.hpp"
#include "render/plant_leaves.hpp"

namespace biotope {

/// How a stroke is coloured.
struct Ink {
  float shade = 1;
  float flower = 0;
  float wood = 0;
};

/// Draws leaves and stalks on a card; coordinates are 0..1 with the foot at y = 0.
class LeafCanvas {
 public:
  explicit LeafCanvas(std::uint64_t what) : picture_(leaf_picture_side, leaf_picture_side, Rgba{128, 0, 0, 0}), what_(what) {}

  float unit() { return float(random_unit({0x6c656166ULL, what_, drawn_++})); }
  float between(float low, float high) { return low + (high - low) * unit(); }

  /// A leaf: two arcs from stalk to tip, its widest part in the middle, one half a little darker than the other.
  void leaf(const glm::vec2& from, const glm::vec2& to, float half_width, const Ink& ink) {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    if (length <= 0) return;
    const glm::vec2 axis = along / length;
    const glm::vec2 side(-axis.y, axis.x);
    stamp(
        glm::min(from, to) - half_width, glm::max(from, to) + half_width,
        [&](const glm::vec2& p) {
          const float t = glm::dot(p - from, axis) / length;
          if (t < 0 || t > 1) return 0.0F;
          const float across = glm::dot(p - from, side);
          return std::abs(across) < half_width * std::sin(glm::pi<float>() * std::pow(t, 0.8F)) ? (across > 0 ? 1.0F : 0.84F)
                                                                                                : 0.0F;
        },
        ink);
  }

  /// A tapering stroke.
  void stroke(const glm::vec2& from, const glm::vec2& to, float half_from, float half_to, const Ink& ink) {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    if (length <= 0) return;
    const glm::vec2 axis = along / length;
    stamp(
        glm::min(from, to) - half_from, glm::max(from, to) + half_from,
        [&](const glm::vec2& p) {
          const float t = glm::dot(p - from, axis) / length;
          if (t < 0 || t > 1) return 0.0F;
          return std::abs(axis.x * (p.y - from.y) - axis.y * (p.x - from.x)) < glm::mix(half_from, half_to, t) ? 1.0F : 0.0F;
        },
        ink);
  }

  void dot(const glm::vec2& centre, float radius, const Ink& ink) {
    stamp(
        centre - radius, centre + radius, [&](const glm::vec2& p) { return glm::distance(p, centre) < radius ? 1.0F : 0.0F; },
        ink);
  }

  [[nodiscard]] Grid<Rgba> take() { return std::move(picture_); }

 private:
  template <class Shape>
  void stamp(const glm::vec2& low, const glm::vec2& high, const Shape& shape, const Ink& ink) {
    const auto texel = [](float v) { return std::clamp(int(v * leaf_picture_side), 0, leaf_picture_side - 1); };
    for (int y = texel(low.y); y <= texel(high.y); ++y) {
      for (int x = texel(low.x); x <= texel(high.x); ++x) {
        const float inside = shape((glm::vec2(x, y) + 0.5F) / float(leaf_picture_side));
        if (inside <= 0) continue;
        const auto code = [](float v) { return std::uint8_t(std::lround(std::clamp(v, 0.0F, 1.0F) * 255)); };
        picture_(x, y) = {code(0.5F * ink.shade * inside), code(ink.flower), code(ink.wood), 255};
      }
    }
  }

  Grid<Rgba> picture_;
  std::uint64_t what_;
  std::uint64_t drawn_ = 0;
};

}  // namespace biotope
