#include "render/sky_renderer.hpp"

namespace biotope {

Result<SkyRenderer> SkyRenderer::create() {
  auto program = load_shader_program("landscape/sky.vert", "landscape/sky.frag");
  if (!program) return tl::unexpected(program.error());
  SkyRenderer renderer;
  renderer.program_ = std::move(*program);
  renderer.empty_ = make_vertex_array();
  return renderer;
}

void SkyRenderer::draw() const {
  program_.use();
  glBindVertexArray(empty_.name());
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
}

}  // namespace biotope
