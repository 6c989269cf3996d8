#include "render/screen_effects.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace biotope {

namespace {

constexpr GLuint picture_unit = 0;
constexpr GLuint depth_unit = 1;
constexpr GLuint shade_unit = 2;

}  // namespace

int occlusion_reach(int whole_height) { return std::clamp(90 * whole_height / 1080, 90, 180); }

int effect_margin(bool smooth, bool occlusion, int whole_height) {
  // Even, so that the pixels that are shaded together are the same in every part.
  constexpr int smoothed = 8;
  const int shaded = occlusion_reach(whole_height) / 2 * 2 + 6;
  return occlusion ? shaded : smooth ? smoothed : 0;
}

Result<ScreenEffects> ScreenEffects::create() {
  ScreenEffects out;
  auto occlusion = load_shader_program("landscape/screen.vert", "landscape/screen_occlusion.frag");
  if (!occlusion) return tl::unexpected(occlusion.error());
  out.occlusion_ = std::move(*occlusion);
  for (std::size_t i = 0; i < out.finish_.size(); ++i) {
    std::vector<std::string> definitions;
    if ((i & 1U) != 0) definitions.emplace_back("WITH_SMOOTH_EDGES");
    if ((i & 2U) != 0) definitions.emplace_back("WITH_OCCLUSION");
    auto program = load_shader_program("landscape/screen.vert", "landscape/screen_finish.frag", definitions);
    if (!program) return tl::unexpected(program.error());
    out.finish_[i] = std::move(*program);
  }
  out.empty_ = make_vertex_array();
  return out;
}

void ScreenEffects::begin(const PicturePart& part) {
  part_ = part;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  const int width = viewport_[2];
  const int height = viewport_[3];
  if (!target_ || target_->width() != width || target_->height() != height) {
    target_ = std::make_unique<RenderTarget>(width, height);
    mirrored_ = make_texture_2d(GL_RGBA8, width, height, 1, {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE});
    mirrored_depth_ = make_texture_2d(GL_DEPTH_COMPONENT32F, width, height, 1, {GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE});
    shade_ = make_texture_2d(GL_R8, width, height, 1, {GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE});
    shade_framebuffer_ = make_framebuffer();
    glNamedFramebufferTexture(shade_framebuffer_.name(), GL_COLOR_ATTACHMENT0, shade_.name(), 0);
  }
  target_->bind();
}

void ScreenEffects::keep_for_water() {
  const auto copy = [&](GLuint from, GLuint to) {
    glCopyImageSubData(from, GL_TEXTURE_2D, 0, 0, 0, 0, to, GL_TEXTURE_2D, 0, 0, 0, 0, target_->width(), target_->height(), 1);
  };
  copy(target_->texture(), mirrored_.name());
  copy(target_->depth_texture(), mirrored_depth_.name());
  glBindTextureUnit(mirrored_unit, mirrored_.name());
  glBindTextureUnit(mirrored_depth_unit, mirrored_depth_.name());
}

void ScreenEffects::end(const glm::vec2& planes, bool smooth, bool occlusion) const {
  glViewport(0, 0, viewport_[2], viewport_[3]);
  glBindTextureUnit(picture_unit, target_->texture());
  glBindTextureUnit(depth_unit, target_->depth_texture());
  glBindVertexArray(empty_.name());
  glDepthFunc(GL_ALWAYS);
  if (occlusion) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shade_framebuffer_.name());
    occlusion_.set("planes", planes);
    occlusion_.set("within", glm::vec4(part_.corner, part_.whole));
    occlusion_.set("most", float(occlusion_reach(part_.whole.y)));
    occlusion_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTextureUnit(shade_unit, shade_.name());
  }
  glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  const ShaderProgram& finish = finish_[(smooth ? 1U : 0U) + (occlusion ? 2U : 0U)];
  finish.set("planes", planes);
  finish.set("corner", glm::vec2(viewport_[0], viewport_[1]));
  finish.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthFunc(GL_LESS);
}

}  // namespace biotope
