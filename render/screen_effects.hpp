#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>

#include "core/base/status.hpp"
#include "render/gl_objects.hpp"
#include "render/offscreen_context.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// The part of a picture that is drawn into a framebuffer: the pixel of the whole that is its lower left one, and the size of
/// the whole.
struct PicturePart {
  glm::ivec2 corner{0};
  glm::ivec2 whole{0};
};

/// Pixels around a point in a picture of some height that the shade in corners follows from, at most. Pictures of up to 1080 rows
/// have 90, finer ones more, up to twice as many.
[[nodiscard]] int occlusion_reach(int whole_height);
/// Pixels around a part of a picture that its effects look at.
[[nodiscard]] int effect_margin(bool smooth, bool occlusion, int whole_height);

/// What is done to a picture once it is drawn, where a graphics card has room: smooth edges, shade in corners and among stems
/// (ambient occlusion), and what water mirrors. The picture is drawn into a target of its own and comes from there into the
/// framebuffer of before, with its depth.
class ScreenEffects {
 public:
  [[nodiscard]] static Result<ScreenEffects> create();
  /// Makes a target of the size of the viewport the one that is drawn into; it holds that part of a picture.
  void begin(const PicturePart& part);
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
  PicturePart part_;
  GLint framebuffer_ = 0;
  std::array<GLint, 4> viewport_{};
};

}  // namespace biotope
