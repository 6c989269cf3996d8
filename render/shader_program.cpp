#include "render/shader_program.hpp"

#include <cstdlib>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <sstream>
#include <vector>

namespace biotope {

namespace fs = std::filesystem;

Result<fs::path> shaders_folder() {
  std::vector<fs::path> candidates;
  if (const char* asked = std::getenv("BIOTOPE_SHADERS"); asked != nullptr && *asked != '\0') candidates.emplace_back(asked);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) candidates.push_back(program.parent_path().parent_path() / "share/biotope/shaders");
  candidates.emplace_back(BIOTOPE_SHADER_SOURCE_DIR);
  std::string tried;
  for (const fs::path& folder : candidates) {
    if (fs::is_directory(folder, error)) return folder;
    tried += (tried.empty() ? "" : ", ") + folder.string();
  }
  return fail("No shader folder found (tried " + tried + "); set BIOTOPE_SHADERS to the folder of the GLSL files.");
}

namespace {

/// The name between quotes of an include line.
std::optional<std::string> included_file(const std::string& line) {
  if (line.rfind("#include", 0) != 0) return std::nullopt;
  const auto first = line.find('"');
  const auto last = line.rfind('"');
  if (first == std::string::npos || last <= first) return std::nullopt;
  return line.substr(first + 1, last - first - 1);
}

Result<std::string> read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fail("Cannot read the shader " + file.string());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The text with names defined after its first line, which is its version.
std::string with_definitions(std::string text, std::span<const std::string> definitions) {
  std::string lines;
  for (const std::string& name : definitions) lines += "#define " + name + "\n";
  if (!lines.empty()) text.insert(text.find('\n') + 1, lines + "#line 2\n");
  return text;
}

Result<GLuint> compile(GLenum stage, const fs::path& folder, const std::string& file, std::span<const std::string> definitions) {
  auto text = read_shader(folder, file);
  if (!text) return tl::unexpected(text.error());
  *text = with_definitions(std::move(*text), definitions);
  const GLuint shader = glCreateShader(stage);
  const char* source = text->c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));
  glDeleteShader(shader);
  return fail("The shader " + (folder / file).string() + " does not compile:\n" + log);
}

}  // namespace

Result<std::string> read_shader(const fs::path& folder, const std::string& file) {
  const auto text = read_text(folder / file);
  if (!text) return text;
  std::istringstream lines(*text);
  std::string out;
  std::string line;
  int number = 0;
  int includes = 0;
  while (std::getline(lines, line)) {
    ++number;
    if (const auto name = included_file(line)) {
      const auto inner = read_shader(folder, *name);
      if (!inner) return fail(inner.error().message + " (included by " + file + ", line " + std::to_string(number) + ")");
      out += "#line " + std::to_string(1000 * ++includes) + "\n" + *inner + "\n#line " + std::to_string(number + 1) + "\n";
    } else {
      out += line + "\n";
    }
  }
  return out;
}

Result<ShaderProgram> load_shader_program(const std::string& vertex_file, const std::string& fragment_file,
                                          std::span<const std::string> definitions) {
  const auto folder = shaders_folder();
  if (!folder) return tl::unexpected(folder.error());
  const auto vertex = compile(GL_VERTEX_SHADER, *folder, vertex_file, definitions);
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = compile(GL_FRAGMENT_SHADER, *folder, fragment_file, definitions);
  if (!fragment) {
    glDeleteShader(*vertex);
    return tl::unexpected(fragment.error());
  }
  ProgramObject program(glCreateProgram());
  for (const GLuint shader : {*vertex, *fragment}) {
    glAttachShader(program.name(), shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return ShaderProgram(std::move(program));
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program.name(), GLsizei(log.size()), &length, log.data());
  log.resize(std::size_t(length));
  return fail("The shaders " + vertex_file + " and " + fragment_file + " do not link:\n" + log);
}

void ShaderProgram::set(const char* uniform, int value) const { glProgramUniform1i(name(), location(uniform), value); }
void ShaderProgram::set(const char* uniform, float value) const { glProgramUniform1f(name(), location(uniform), value); }
void ShaderProgram::set(const char* uniform, const glm::vec2& value) const {
  glProgramUniform2fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* uniform, const glm::vec3& value) const {
  glProgramUniform3fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* uniform, const glm::vec4& value) const {
  glProgramUniform4fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* uniform, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace biotope
