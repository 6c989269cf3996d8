#pragma once

#include <glm/glm.hpp>

#include "core/base/grid.hpp"
#include "core/base/rect.hpp"
#include "core/base/status.hpp"
#include "render/camera.hpp"
#include "render/gl_objects.hpp"
#include "render/mipmaps.hpp"
#include "render/overlay_lines.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// Lays a map over a finished 3D picture, on the ground and on what stands on it, without drawing the landscape again: the
/// picture's depths tell where each pixel lies. Owns its OpenGL objects.
class MapDrape {
 public:
  [[nodiscard]] static Result<MapDrape> create();

  /// The map's colours, premultiplied, the north-west corner first; one texel stands for one or several cells.
  void set_texels(const Grid<Rgba>& texels);
  /// Some of them changed.
  void patch(const Grid<Rgba>& texels, const Rect& changed);

  /// The picture it is laid over.
  struct Picture {
    Camera camera;
    glm::vec2 size{1};  ///< pixels
    DepthPicture depth;
    unsigned colours = 0;  ///< OpenGL's name of the picture's colour texture
    glm::vec2 ground{1};   ///< of the landscape, m east and north
    glm::vec2 covered{1};  ///< share of the texels that hold the landscape
  };
  /// Into the viewport that is set. Changes blending, program and textures.
  void draw(const Picture& picture) const;

 private:
  ShaderProgram program_;
  VertexArray vertex_array_;
  Texture texture_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace biotope
