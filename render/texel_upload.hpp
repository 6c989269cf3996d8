#pragma once

#include <chrono>

#include "core/base/rect.hpp"
#include "render/gl_objects.hpp"
#include "render/mipmaps.hpp"

namespace biotope {

/// What of a frame may go into uploads.
struct UploadBudget {
  std::size_t bytes = std::size_t(4) << 20;
  std::chrono::steady_clock::time_point until = std::chrono::steady_clock::now() + std::chrono::milliseconds(4);
  [[nodiscard]] bool spent() const { return bytes == 0 || std::chrono::steady_clock::now() >= until; }
  void take(std::size_t taken) { bytes -= std::min(bytes, taken); }
  /// As much as there is.
  [[nodiscard]] static UploadBudget unlimited() { return {~std::size_t(0), std::chrono::steady_clock::time_point::max()}; }
};

/// How texels of a type lie in OpenGL.
struct TexelFormat {
  GLenum internal;
  GLenum format;
  GLenum type;
};
[[nodiscard]] constexpr TexelFormat format_of(const float&) { return {GL_R32F, GL_RED, GL_FLOAT}; }
[[nodiscard]] constexpr TexelFormat format_of(const std::uint8_t&) { return {GL_R8, GL_RED, GL_UNSIGNED_BYTE}; }
[[nodiscard]] constexpr TexelFormat format_of(const Rg&) { return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE}; }
[[nodiscard]] constexpr TexelFormat format_of(const Rgba&) { return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}; }

/// Uploads the texels of `rect` of a texture's level; `texels` points to the first, rows lie `row_length` texels apart. Returns
/// the bytes.
template <class Texel>
std::size_t upload_texels(const Texture& texture, int level, const Rect& rect, const Texel* texels, int row_length) {
  constexpr TexelFormat format = format_of(Texel{});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, row_length);
  glTextureSubImage2D(texture.name(), level, rect.x0, rect.y0, rect.width(), rect.height(), format.format, format.type, texels);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  return std::size_t(rect.width()) * std::size_t(rect.height()) * sizeof(Texel);
}

}  // namespace biotope
