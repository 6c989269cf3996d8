#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// Draws the sky behind everything: one triangle over the screen at the far plane. Reads the frame's uniforms and the noise texture on unit 3.
class SkyRenderer {
 public:
  [[nodiscard]] static Result<SkyRenderer> create();
  void draw() const;

 private:
  ShaderProgram program_;
  VertexArray empty_;
};

}  // namespace biotope
