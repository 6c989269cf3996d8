#pragma once

#include <array>
#include <glm/glm.hpp>

#include "render/camera.hpp"
#include "render/gl_objects.hpp"

namespace biotope {

/// A square of the plane across the light that is pictured for shadows.
struct ShadowCascade {
  glm::vec2 centre{0};    ///< metres to the light's right and up from the eye
  float half_side = 1;    ///< m
  float softness = 0.1F;  ///< half the width of a shadow's edge, m
};
inline constexpr int shadow_cascades = 3;

/// What the light sees around the camera: near, farther, and far squares.
struct ShadowView {
  glm::vec3 right{1, 0, 0};
  glm::vec3 up{0, 1, 0};
  glm::vec3 toward{0, 0, 1};  ///< toward the light
  float centre_depth = 0;     ///< metres toward the light from the eye where depth is one half
  float reach = 1;            ///< metres from there to where depth is 0 and 1
  float strength = 0;         ///< 0: no shadows, 1: full ones
  std::array<ShadowCascade, shadow_cascades> cascades;
};

/// Texels a side of a cascade.
inline constexpr int shadow_texels = 2048;

/// Squares for an eye `above` metres over the ground. They lie ahead of the eye and move in whole texels, so that shadows do not
/// swim when it moves. `light` points toward the light; one that stands low is raised a little, so that shadows have an end.
[[nodiscard]] ShadowView shadow_view(const Camera& camera, double above, const glm::vec3& light, float strength);

/// True when a ball (centre relative to the eye, m) may throw its shadow into a cascade.
[[nodiscard]] bool casts_into(const ShadowView& view, int cascade, const glm::vec3& centre, float radius);

/// Depth pictures of a ShadowView, and what shaders must know of it (uniform block `Shadows` of shaders/landscape/shadow.glsl).
class ShadowMap {
 public:
  static constexpr GLuint unit = 12;
  static constexpr GLuint binding = 3;

  ShadowMap() = default;
  /// Makes the pictures when they are first needed; tells the shaders of the view. Binds both.
  void begin(const ShadowView& view);
  /// Clears a cascade and makes it the target of what is drawn, until end().
  void open(int cascade) const;
  void end() const;

 private:
  Texture depth_;
  std::array<Framebuffer, shadow_cascades> framebuffers_;
  Buffer uniforms_;
};

}  // namespace biotope
