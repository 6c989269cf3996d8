#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/base/status.hpp"
#include "render/gl_objects.hpp"

namespace biotope {

/// Folder of the GLSL files: $BIOTOPE_SHADERS, else ../share/biotope/shaders beside the program, else the source tree it was
/// built from. An Error names the folders that were tried.
[[nodiscard]] Result<std::filesystem::path> shaders_folder();

/// Text of a shader file (relative to shaders_folder()), with every line `#include "folder/file.glsl"` replaced by that file, and
/// so in that file. Files must not include each other in a ring.
[[nodiscard]] Result<std::string> read_shader(const std::filesystem::path& folder, const std::string& file);

/// A linked vertex + fragment program. Uniforms are set by name without binding the program (DSA); a name that the compiler
/// removed is ignored. Needs the context it was made in.
class ShaderProgram {
 public:
  ShaderProgram() = default;

  void use() const { glUseProgram(object_.name()); }
  [[nodiscard]] GLuint name() const { return object_.name(); }
  explicit operator bool() const { return bool(object_); }

  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, const glm::vec2& value) const;
  void set(const char* uniform, const glm::vec3& value) const;
  void set(const char* uniform, const glm::vec4& value) const;
  void set(const char* uniform, const glm::mat4& value) const;

 private:
  friend Result<ShaderProgram> load_shader_program(const std::string& vertex_file, const std::string& fragment_file,
                                                   std::span<const std::string> definitions);
  explicit ShaderProgram(ProgramObject object) : object_(std::move(object)) {}
  [[nodiscard]] GLint location(const char* uniform) const { return glGetUniformLocation(object_.name(), uniform); }
  ProgramObject object_;
};

/// Compiles and links two files under shaders_folder(), for example "landscape/sky.vert" and "landscape/sky.frag". A failure's
/// message has the file and the driver's log, whose line numbers are those of the file (included files count from 1000 times
/// their number). `definitions` are names that both files see as defined: variants of one source.
[[nodiscard]] Result<ShaderProgram> load_shader_program(const std::string& vertex_file, const std::string& fragment_file,
                                                        std::span<const std::string> definitions = {});

}  // namespace biotope
