#pragma once

#include <array>

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// Draws the sky behind everything: one triangle over the screen at the far plane. Reads the frame's uniforms and the noise
/// texture on unit 3.
class SkyRenderer {
 public:
  [[nodiscard]] static Result<SkyRenderer> create();
  /// `night` 0..1 as in Daylight; quality as in LandscapeOptions.
  void draw(float night, float quality) const;

 private:
  /// By variant: 1 with stars, 2 with fully lit clouds.
  std::array<ShaderProgram, 4> programs_;
  VertexArray empty_;
};

}  // namespace biotope
