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
  float flower = 0;  ///< of flowers: share of their colour; of leaves on trees: how far the leaf has yellowed
  float wood = 0;
};

/// Outline of a leaf: its half width along the way from its stalk (0) to its tip (1).
struct LeafForm {
  float widest = 0.5F;  ///< where it is widest
  float tip = 1;        ///< below 1 blunt, above 1 drawn out to a point
  float lobes = 0;      ///< bays or teeth on a side
  float depth = 0;      ///< of the bays / half width
  [[nodiscard]] float half_width(float t) const {
    const float half_turn = 0.5F * glm::pi<float>();
    const float plain =
        t < widest ? std::sin(half_turn * t / widest) : std::pow(std::cos(half_turn * (t - widest) / (1 - widest)), tip);
    if (depth <= 0) return plain;
    // Bays are narrow, lobes round.
    const float bay = 0.5F + 0.5F * std::cos(glm::two_pi<float>() * lobes * (t - 0.04F));
    return plain * (1 - depth * bay * bay);
  }
};

/// Half the size, colours weighted by coverage.
[[nodiscard]] Grid<Rgba> halved(const Grid<Rgba>& picture);

/// Draws leaves and stalks on a card; coordinates are 0..1 with the foot at y = 0. Drawn twice as large, so that edges are soft.
class LeafCanvas {
 public:
  explicit LeafCanvas(std::uint64_t what) : picture_(side, side, Rgba{128, 0, 0, 0}), what_(what) {}

  float unit() { return float(random_unit({0x6c656166ULL, what_, drawn_++})); }
  float between(float low, float high) { return low + (high - low) * unit(); }

  /// A leaf: two arcs from stalk to tip, its widest part in the middle, one half a little darker than the other.
  void leaf(const glm::vec2& from, const glm::vec2& to, float half_width, const Ink& ink) {
    leaf(from, to, half_width, ink, LeafForm{0.42F, 1, 0, 0});
  }
  /// A leaf of some form, with a midrib, side veins and a shadow on what lies under it.
  void leaf(const glm::vec2& from, const glm::vec2& to, float half_width, const Ink& ink, const LeafForm& form) {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    if (length <= 0) return;
    const glm::vec2 axis = along / length;
    const glm::vec2 across(-axis.y, axis.x);
    const auto inside = [&](const glm::vec2& p) {
      const float t = glm::dot(p - from, axis) / length;
      if (t <= 0 || t >= 1) return 0.0F;
      const float off = glm::dot(p - from, across);
      if (std::abs(off) >= half_width) return 0.0F;
      const float edge = half_width * form.half_width(t);
      if (std::abs(off) >= edge) return 0.0F;
      if (std::abs(off) < 0.055F * half_width) return 1.16F;
      const float vein = std::cos(glm::two_pi<float>() * (6.5F * t - 1.6F * std::abs(off) / length));
      return (off > 0 ? 1.0F : 0.86F) + 0.07F * vein - 0.12F * std::abs(off) / edge;
    };
    const glm::vec2 low = glm::min(from, to) - half_width;
    const glm::vec2 high = glm::max(from, to) + half_width;
    const glm::vec2 fallen(0.006F, -0.010F);
    darken(low + fallen, high + fallen, [&](const glm::vec2& p) { return inside(p - fallen) > 0; });
    stamp(low, high, inside, ink);
  }

  /// A tapering stroke.
  void stroke(const glm::vec2& from, const glm::vec2& to, float half_from, float half_to, const Ink& ink) {
    const glm::vec2 along = to - from;
    const float length = glm::length(along);
    if (length <= 0) return;
    const glm::vec2 axis = along / length;
    const float widest = std::max(half_from, half_to);
    stamp(
        glm::min(from, to) - widest, glm::max(from, to) + widest,
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

  [[nodiscard]] Grid<Rgba> take() const { return halved(picture_); }

 private:
  static constexpr int side = 2 * leaf_picture_side;

  static glm::vec2 place(int x, int y) { return (glm::vec2(x, y) + 0.5F) / float(side); }
  template <class Visit>
  static void visit(const glm::vec2& low, const glm::vec2& high, const Visit& visitor) {
    const auto texel = [](float v) { return std::clamp(int(v * side), 0, side - 1); };
    for (int y = texel(low.y); y <= texel(high.y); ++y) {
      for (int x = texel(low.x); x <= texel(high.x); ++x) visitor(x, y);
    }
  }
  template <class Shape>
  void stamp(const glm::vec2& low, const glm::vec2& high, const Shape& shape, const Ink& ink) {
    visit(low, high, [&](int x, int y) {
      const float inside = shape(place(x, y));
      if (inside <= 0) return;
      const auto code = [](float v) { return std::uint8_t(std::lround(std::clamp(v, 0.0F, 1.0F) * 255)); };
      picture_(x, y) = {code(0.5F * ink.shade * inside), code(ink.flower), code(ink.wood), 255};
    });
  }
  template <class Shape>
  void darken(const glm::vec2& low, const glm::vec2& high, const Shape& shape) {
    visit(low, high, [&](int x, int y) {
      Rgba& texel = picture_(x, y);
      if (texel[3] != 0 && shape(place(x, y))) texel[0] = std::uint8_t(int(texel[0]) * 190 / 256);
    });
  }

  Grid<Rgba> picture_;
  std::uint64_t what_;
  std::uint64_t drawn_ = 0;
};

/// Sprays of a few large leaves, for crowns close to the eye.
[[nodiscard]] Grid<Rgba> oak_spray();
[[nodiscard]] Grid<Rgba> oval_spray();
[[nodiscard]] Grid<Rgba> round_spray();
[[nodiscard]] Grid<Rgba> birch_spray();
[[nodiscard]] Grid<Rgba> leathery_spray();
[[nodiscard]] Grid<Rgba> pine_spray();
[[nodiscard]] Grid<Rgba> scale_spray();
/// A frond of a fern, foot at y = 0.
[[nodiscard]] Grid<Rgba> fern_frond();
/// Leaves of herbs that bear shade, seen from above.
[[nodiscard]] Grid<Rgba> shade_leaves();

/// Barks, all covered; v runs up the stem.
[[nodiscard]] Grid<Rgba> furrowed_bark();
[[nodiscard]] Grid<Rgba> birch_bark();
[[nodiscard]] Grid<Rgba> smooth_bark();
[[nodiscard]] Grid<Rgba> plated_bark();
/// Weathered stone with lichen.
[[nodiscard]] Grid<Rgba> stone_face();

}  // namespace biotope
