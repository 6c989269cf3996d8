#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>

#include "core/base/status.hpp"
#include "render/gl_objects.hpp"
#include "render/offscreen_context.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// What is done to a picture once it is drawn, where a graphics card has room: smooth edges, shade in corners and among stems
/// (ambient occlusion), and what water mirrors. The picture is drawn into a target of its own and comes from there into the
/// framebuffer of before, with its depth.
class ScreenEffects {
 public:
  [[nodiscard]] static Result<ScreenEffects> create();
  /// Makes a target of the size of the viewport the one that is drawn into.
  void begin();
  /// Keeps what was drawn since begin() as what water mirrors, and binds it.
  void keep_for_water();
  static constexpr GLuint mirrored_unit = 13;
  static constexpr GLuint mirrored_depth_unit = 14;
  /// Ends what begin() began. `planes`: nearest and farthest depth, m. The uniform block of the frame must be bound.
  void end(const glm::vec2& planes, bool smooth, bool occlusion) const;

 private:
  ShaderProgram occlusion_;
  /// By whether edges are smoothed (1) and corners shaded (2).
  std::array<ShaderProgram, 4> finish_;
  VertexArray empty_;
  std::unique_ptr<RenderTarget> target_;
  Texture mirrored_;
  Texture mirrored_depth_;
  Texture shade_;
  Framebuffer shade_framebuffer_;
  GLint framebuffer_ = 0;
  std::array<GLint, 4> viewport_{};
};

}  // namespace biotope
