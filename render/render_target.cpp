#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>

#include "render/offscreen_context.hpp"

namespace biotope {

RenderTarget::RenderTarget(int width, int height) : width_(width), height_(height) { make(); }

RenderTarget::~RenderTarget() { drop(); }

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, width_, height_);
}

void RenderTarget::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  drop();
  width_ = width;
  height_ = height;
  make();
}

Image RenderTarget::read() const {
  Image image{width_, height_, std::vector<std::uint8_t>(std::size_t(width_) * std::size_t(height_) * 4)};
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTextureImage(colour_, 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(image.rgba.size()), image.rgba.data());
  const std::ptrdiff_t row = std::ptrdiff_t(width_) * 4;
  for (int y = 0; y < height_ / 2; ++y) {
    const auto top = image.rgba.begin() + y * row;
    std::swap_ranges(top, top + row, image.rgba.begin() + (height_ - 1 - y) * row);
  }
  return image;
}

void RenderTarget::make() {
  width_ = std::max(1, width_);
  height_ = std::max(1, height_);
  glCreateTextures(GL_TEXTURE_2D, 1, &colour_);
  glTextureStorage2D(colour_, 1, GL_RGBA8, width_, height_);
  glTextureParameteri(colour_, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(colour_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(colour_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(colour_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glCreateTextures(GL_TEXTURE_2D, 1, &depth_);
  glTextureStorage2D(depth_, 1, GL_DEPTH_COMPONENT32F, width_, height_);
  glTextureParameteri(depth_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(depth_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(depth_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(depth_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glCreateFramebuffers(1, &framebuffer_);
  glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, colour_, 0);
  glNamedFramebufferTexture(framebuffer_, GL_DEPTH_ATTACHMENT, depth_, 0);
  assert(glCheckNamedFramebufferStatus(framebuffer_, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void RenderTarget::drop() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &colour_);
  glDeleteTextures(1, &depth_);
  framebuffer_ = colour_ = depth_ = 0;
}

}  // namespace biotope
