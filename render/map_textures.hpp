#pragma once

#include <memory>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"

namespace biotope {

/// The terrain on the graphics card: heights, and their shaded relief, which is made a few rows a frame.
class ReliefTexture {
 public:
  void set_terrain(std::shared_ptr<const Terrain> terrain);
  /// Shades up to `cells` more cells with the program of shaders/map/relief.frag. Changes the bound framebuffer and viewport.
  void shade_some(const ShaderProgram& program, std::size_t cells);
  [[nodiscard]] bool complete() const { return rows_done_ >= rows_; }
  [[nodiscard]] const Texture& heights() const { return heights_; }
  [[nodiscard]] const Texture& relief() const { return relief_; }
  [[nodiscard]] const std::shared_ptr<const Terrain>& terrain() const { return terrain_; }

 private:
  std::shared_ptr<const Terrain> terrain_;
  Texture heights_;
  Texture relief_;
  Framebuffer framebuffer_;
  int rows_ = 0;
  int rows_done_ = 0;
  float lowest_ = 0;
  float highest_ = 0;
};

/// Wet cells (r) and their depth on a square-root scale (g), with mipmaps.
[[nodiscard]] Texture water_texture(const Hydrology& hydrology);

/// The values of a map, uploaded when the grid's pointer changes.
class OverlayTexture {
 public:
  void set(const std::shared_ptr<const Grid<float>>& cells, bool smooth);
  void patch(const Grid<float>& cells, const Rect& rect);
  [[nodiscard]] const Texture& texture() const { return texture_; }

 private:
  std::shared_ptr<const Grid<float>> cells_;
  Texture texture_;
  int width_ = 0;
  int height_ = 0;
};

/// The coverage of a layer of paint; uploads the tiles whose pointers changed.
class PaintTexture {
 public:
  void set(const PaintLayer& layer);
  void clear();
  [[nodiscard]] const Texture& texture() const { return texture_; }

 private:
  Texture texture_;
  int width_ = 0;
  int height_ = 0;
  std::vector<PaintLayer::TilePointer> tiles_;
};

/// A picture that is kept and copied while nothing in it changes.
class KeptPicture {
 public:
  /// Makes it of this size; what it held is lost when the size changes. True when it did.
  bool resize(int width, int height);
  /// Draws go into it from now on.
  void bind() const;
  /// Copies it whole into another framebuffer.
  void copy_to(GLuint framebuffer) const;

 private:
  Texture colour_;
  Framebuffer framebuffer_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace biotope
