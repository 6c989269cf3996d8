#include "render/gl_objects.hpp"

#include <algorithm>
#include <bit>

namespace biotope {

namespace gl_detail {
void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }
void delete_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
void delete_texture(GLuint name) { glDeleteTextures(1, &name); }
void delete_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
void delete_program(GLuint name) { glDeleteProgram(name); }
}  // namespace gl_detail

Buffer make_buffer() {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  return Buffer(name);
}

Buffer make_static_buffer(std::span<const std::byte> bytes) {
  Buffer buffer = make_buffer();
  glNamedBufferData(buffer.name(), GLsizeiptr(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return buffer;
}

VertexArray make_vertex_array() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return VertexArray(name);
}

Framebuffer make_framebuffer() {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  return Framebuffer(name);
}

void mix_mipmaps(GLuint texture, bool mixed) {
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, mixed ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_NEAREST);
}

int full_mip_levels(int width, int height) { return int(std::bit_width(unsigned(std::max({width, height, 1})))); }

namespace {
Texture make_texture(GLenum target, const Sampling& sampling) {
  GLuint name = 0;
  glCreateTextures(target, 1, &name);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, sampling.minify);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, sampling.magnify);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, sampling.wrap);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, sampling.wrap);
  return Texture(name);
}
}  // namespace

Texture make_texture_2d(GLenum internal_format, int width, int height, int levels, const Sampling& sampling) {
  Texture texture = make_texture(GL_TEXTURE_2D, sampling);
  glTextureStorage2D(texture.name(), levels == 0 ? full_mip_levels(width, height) : levels, internal_format, width, height);
  return texture;
}

Texture make_texture_array(GLenum internal_format, int width, int height, int layers, int levels, const Sampling& sampling) {
  Texture texture = make_texture(GL_TEXTURE_2D_ARRAY, sampling);
  glTextureStorage3D(texture.name(), levels == 0 ? full_mip_levels(width, height) : levels, internal_format, width, height,
                     layers);
  return texture;
}

void float_attribute(const VertexArray& vertex_array, GLuint location, GLuint binding, int components, std::size_t offset) {
  glEnableVertexArrayAttrib(vertex_array.name(), location);
  glVertexArrayAttribFormat(vertex_array.name(), location, components, GL_FLOAT, GL_FALSE, GLuint(offset));
  glVertexArrayAttribBinding(vertex_array.name(), location, binding);
}

}  // namespace biotope
