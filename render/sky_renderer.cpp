#include "render/sky_renderer.hpp"

namespace biotope {

Result<SkyRenderer> SkyRenderer::create() {
  constexpr std::array<const char*, 4> views{"day_low", "night_low", "day", "night"};
  SkyRenderer renderer;
  for (std::size_t i = 0; i < views.size(); ++i) {
    auto program = load_shader_program("landscape/sky.vert", std::string("landscape/sky_") + views[i] + ".frag");
    if (!program) return tl::unexpected(program.error());
    renderer.programs_[i] = std::move(*program);
  }
  renderer.empty_ = make_vertex_array();
  return renderer;
}

void SkyRenderer::draw(float night, float quality) const {
  const std::size_t variant = (night > 0.25F ? 1U : 0U) + (quality >= 0.75F ? 2U : 0U);
  programs_[variant].use();
  glBindVertexArray(empty_.name());
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
}

}  // namespace biotope
