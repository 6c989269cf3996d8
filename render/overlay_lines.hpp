#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/status.hpp"
#include "render/camera.hpp"
#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// A line over the 3D picture: places in metres, widths in pixels, colours with straight alpha.
struct OverlayLine {
  std::vector<glm::dvec3> points;
  glm::vec4 colour{1};
  glm::vec4 casing{0};
  float width = 2;
  float casing_width = 1;  ///< on either side
  float dash = 0;          ///< length of a dash, pixels; 0: a whole line
};

/// A corner of the ribbon that a line becomes on the screen.
struct OverlayVertex {
  glm::vec2 pixel{0};  ///< from the upper left corner
  float nearness = 0;  ///< 1 / depth, 1/m: linear on the screen
  float across = 0;    ///< pixels from the middle of the ribbon
  float along = 0;     ///< pixels from its beginning
  float half_width = 0;
  float half_casing = 0;
  float dash = 0;
  glm::vec4 colour{1};
  glm::vec4 casing{0};
};

/// Adds the triangles of a line as seen by a camera over `size` pixels. What is nearer than `nearest` metres is cut off.
void add_ribbon(const OverlayLine& line, const Camera& camera, const glm::vec2& size, float nearest,
                std::vector<OverlayVertex>& out);

/// Depths of a picture, to tell what of a line lies behind something.
struct DepthPicture {
  unsigned texture = 0;  ///< OpenGL's name of a depth texture, bottom row first
  float near_plane = 1;  ///< m
  float far_plane = 1000;
};

/// Draws ribbons over a picture: as they are where they are in sight, faint and dotted where a hill or a tree hides them. Owns
/// its OpenGL objects.
class OverlayLines {
 public:
  [[nodiscard]] static Result<OverlayLines> create();
  /// Into the viewport that is set, `size` pixels of the vertices wide and high. Changes blending, program and textures.
  void draw(std::span<const OverlayVertex> vertices, const DepthPicture& depth, const glm::vec2& size) const;

 private:
  ShaderProgram program_;
  VertexArray vertex_array_;
  Buffer buffer_;
};

}  // namespace biotope
