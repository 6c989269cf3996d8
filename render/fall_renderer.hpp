#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "render/weather.hpp"

namespace biotope {

/// Drops or flakes to draw for a weather and quality: none when it is dry.
[[nodiscard]] int falling_count(const Weather& weather, float quality);

/// Draws rain and snow in the air around the eye: a quad for every drop or flake, moved by wind and time alone, so that the same
/// moment shows the same picture. Reads the frame's uniforms; drawn last, over everything, hidden by what stands nearer.
class FallRenderer {
 public:
  [[nodiscard]] static Result<FallRenderer> create();
  /// Returns the number of quads drawn.
  int draw(const Weather& weather, float quality) const;

 private:
  ShaderProgram program_;
  VertexArray empty_;
};

}  // namespace biotope
