#pragma once

#include <array>
#include <glm/glm.hpp>

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

namespace biotope {

/// A frame of directions around the light.
struct ShadowLight {
  glm::vec3 right{1, 0, 0};
  glm::vec3 up{0, 1, 0};
  glm::vec3 toward{0, 0, 1};  ///< toward the light
  float reach = 1;            ///< metres from where depth is one half to where it is 0 and 1
  bool operator==(const ShadowLight&) const = default;
  /// A place as metres to the right, up and toward the light.
  [[nodiscard]] glm::dvec3 of(const glm::dvec3& at) const {
    return {glm::dot(glm::dvec3(right), at), glm::dot(glm::dvec3(up), at), glm::dot(glm::dvec3(toward), at)};
  }
};

/// A square of the plane across the light that is pictured for shadows. It lies on a lattice of the land: while the eye stays
/// within a cell of it the square is the same, and what is pictured in it can be kept.
struct ShadowCascade {
  ShadowLight light;
  glm::vec2 centre{0};    ///< metres to the light's right and up from the eye
  float depth = 0;        ///< metres toward the light from the eye where depth is one half
  float half_side = 1;    ///< m
  float softness = 0.1F;  ///< half the width of a shadow's edge, m
  /// A place of the land, in whole metres, and where the square's middle is from there: right, up and toward the light.
  glm::vec3 origin{0};
  glm::vec3 from_origin{0};
};
inline constexpr int shadow_cascades = 3;

/// What the light sees around the camera: near, farther, and far squares.
struct ShadowView {
  float strength = 0;  ///< 0: no shadows, 1: full ones
  std::array<ShadowCascade, shadow_cascades> cascades;
};

/// Texels a side of a cascade.
inline constexpr int shadow_texels = 2048;

/// Squares for an eye `above` metres over the ground. They lie ahead of the eye and move by a quarter of half a side, in whole
/// texels, so that shadows do not swim when it moves. `light` points toward the light, which moves in steps too small to be seen;
/// one that stands low is raised a little, so that shadows have an end.
[[nodiscard]] ShadowView shadow_view(const Camera& camera, double above, const glm::vec3& light, float strength);

/// A square of an earlier view, which stays where it is on the land, as another eye has it.
[[nodiscard]] ShadowCascade seen_from(ShadowCascade cascade, const glm::dvec3& eye);

/// True when a ball (centre relative to the eye, m) may throw its shadow into a cascade.
[[nodiscard]] bool casts_into(const ShadowView& view, int cascade, const glm::vec3& centre, float radius);
/// The same for a ball at a place of the land, whatever eye looks.
[[nodiscard]] bool throws_into(const ShadowView& view, int cascade, const glm::dvec3& centre, float radius);

/// A rectangle of the plane across the light, metres to its right and up from the eye; empty at first.
struct ShadowBox {
  glm::vec2 low{1e9F};
  glm::vec2 high{-1e9F};
  void take_in(const glm::vec2& at, float radius) {
    low = glm::min(low, at - radius);
    high = glm::max(high, at + radius);
  }
  [[nodiscard]] bool empty() const { return low.x > high.x; }
};

/// Depth pictures of a ShadowView, and what shaders must know of it (uniform block `Shadows` of shaders/landscape/shadow.glsl).
/// Each cascade is pictured twice: what stands, which is kept as long as it is the same, and over a copy of that what moves.
class ShadowMap {
 public:
  static constexpr GLuint unit = 12;
  static constexpr GLuint binding = 3;

  ShadowMap() = default;
  /// Makes the pictures when they are first needed; tells the shaders of the view. Binds both.
  void begin(const ShadowView& view);
  /// Clears a cascade and makes it the target of what stands, until open_moving().
  void open_standing(int cascade) const;
  /// Shows a cascade with what stands in it, all of it where that is `anew`, and makes it the target of what moves within `box`.
  void open_moving(int cascade, bool anew, const ShadowBox& box);
  void end() const;

 private:
  /// Texels of a rectangle: the first, and how many; none where the last are 0.
  struct Texels {
    glm::ivec2 first{0};
    glm::ivec2 count{0};
  };
  [[nodiscard]] Texels texels_of(const ShadowCascade& cascade, const ShadowBox& box) const;
  void copy(int cascade, const Texels& texels) const;

  std::array<ShadowCascade, shadow_cascades> cascades_;
  Texture standing_;
  Texture depth_;
  std::array<Framebuffer, shadow_cascades> standing_framebuffers_;
  std::array<Framebuffer, shadow_cascades> framebuffers_;
  /// Where what moves was drawn.
  std::array<Texels, shadow_cascades> moved_{};
  Buffer uniforms_;
};

}  // namespace biotope
