#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>
#include <utility>

namespace biotope {

/// An OpenGL object's name with an owner: deleted with it, moved but not copied. `Delete` is a function of one name.
template <void (*Delete)(GLuint)>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    if (this != &other) {
      reset();
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  /// OpenGL's name; 0 when there is no object.
  [[nodiscard]] GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  void reset() {
    if (name_ != 0) Delete(name_);
    name_ = 0;
  }

 private:
  GLuint name_ = 0;
};

namespace gl_detail {
void delete_buffer(GLuint name);
void delete_vertex_array(GLuint name);
void delete_texture(GLuint name);
void delete_framebuffer(GLuint name);
void delete_program(GLuint name);
}  // namespace gl_detail

using Buffer = GlObject<gl_detail::delete_buffer>;
using VertexArray = GlObject<gl_detail::delete_vertex_array>;
using Texture = GlObject<gl_detail::delete_texture>;
using Framebuffer = GlObject<gl_detail::delete_framebuffer>;
using ProgramObject = GlObject<gl_detail::delete_program>;

[[nodiscard]] Buffer make_buffer();
/// A buffer filled once with `bytes`.
[[nodiscard]] Buffer make_static_buffer(std::span<const std::byte> bytes);
[[nodiscard]] VertexArray make_vertex_array();
[[nodiscard]] Framebuffer make_framebuffer();

/// How a texture is sampled.
struct Sampling {
  GLint minify = GL_LINEAR;
  GLint magnify = GL_LINEAR;
  GLint wrap = GL_CLAMP_TO_EDGE;

  bool operator==(const Sampling& other) const = default;
};
/// A 2D texture with storage for `levels` mipmaps (0: all of them); its contents are undefined until uploaded.
[[nodiscard]] Texture make_texture_2d(GLenum internal_format, int width, int height, int levels, const Sampling& sampling);
/// An array of 2D textures.
[[nodiscard]] Texture make_texture_array(GLenum internal_format, int width, int height, int layers, int levels,
                                         const Sampling& sampling);
/// Whether a texture's mipmaps are mixed, or the nearest one is taken: half of the work where a processor draws.
void mix_mipmaps(GLuint texture, bool mixed);
/// Mipmaps of a full chain.
[[nodiscard]] int full_mip_levels(int width, int height);

/// Replaces a buffer's contents by values that are used for a frame.
template <class T>
void stream(const Buffer& buffer, std::span<const T> values) {
  glNamedBufferData(buffer.name(), GLsizeiptr(values.size_bytes()), values.data(), GL_STREAM_DRAW);
}

/// Declares float attribute `location` of `components` floats at `offset` bytes of binding point `binding`.
void float_attribute(const VertexArray& vertex_array, GLuint location, GLuint binding, int components, std::size_t offset);

}  // namespace biotope
