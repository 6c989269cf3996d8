#pragma once

#include <memory>

#include "core/base/status.hpp"
#include "render/image.hpp"

namespace biotope {

/// An OpenGL 4.5 core context without a window or display (EGL, surfaceless), current on the creating thread while it lives.
class OffscreenContext {
 public:
  [[nodiscard]] static Result<std::unique_ptr<OffscreenContext>> create();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  OffscreenContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

/// Whether a processor draws for the current context, not a graphics card.
[[nodiscard]] bool drawn_by_processor();

/// A colour + depth framebuffer one can draw into, show as a texture, and read back. Needs a current context for its whole life.
class RenderTarget {
 public:
  RenderTarget(int width, int height);
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;

  /// Makes it current and sets the viewport.
  void bind() const;
  void resize(int width, int height);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// OpenGL name of the colour texture (RGBA8, bottom row first as OpenGL does).
  [[nodiscard]] unsigned texture() const { return colour_; }
  /// OpenGL name of the depth texture (32-bit floats, bottom row first).
  [[nodiscard]] unsigned depth_texture() const { return depth_; }
  [[nodiscard]] Image read() const;

 private:
  void make();
  void drop();
  int width_ = 0;
  int height_ = 0;
  unsigned framebuffer_ = 0;
  unsigned colour_ = 0;
  unsigned depth_ = 0;
};

}  // namespace biotope
