#include "render/map_drape.hpp"

#include <cmath>

#include "render/texel_upload.hpp"

namespace biotope {

Result<MapDrape> MapDrape::create() {
  MapDrape drape;
  auto program = load_shader_program("landscape/map_drape.vert", "landscape/map_drape.frag");
  if (!program) return tl::unexpected(program.error());
  drape.program_ = std::move(*program);
  drape.vertex_array_ = make_vertex_array();
  return drape;
}

void MapDrape::set_texels(const Grid<Rgba>& texels) {
  if (!texture_ || width_ != texels.width() || height_ != texels.height()) {
    width_ = texels.width();
    height_ = texels.height();
    texture_ = make_texture_2d(GL_RGBA8, width_, height_, 1, {});
  }
  patch(texels, texels.rect());
}

void MapDrape::patch(const Grid<Rgba>& texels, const Rect& changed) {
  const Rect rect = intersection(changed, texels.rect());
  if (!texture_ || rect.empty()) return;
  upload_texels(texture_, 0, rect, &texels(rect.x0, rect.y0), texels.width());
}

void MapDrape::draw(const Picture& picture) const {
  if (!texture_) return;
  const glm::vec3 forward = picture.camera.forward();
  const glm::vec3 right = picture.camera.right();
  const float half_height = std::tan(0.5F * glm::radians(picture.camera.vertical_field));
  program_.use();
  program_.set("eye", glm::vec3(picture.camera.position));
  program_.set("forward", forward);
  program_.set("right", right * (half_height * picture.size.x / picture.size.y));
  program_.set("up", glm::cross(right, forward) * half_height);
  program_.set("planes", glm::vec2(1 / picture.depth.near_plane, 1 / picture.depth.far_plane));
  program_.set("ground", picture.ground);
  program_.set("covered", picture.covered);
  const GLuint textures[] = {picture.depth.texture, picture.colours, texture_.name()};
  for (GLuint unit = 0; unit < 3; ++unit) {
    glBindTextureUnit(unit, textures[unit]);
    glBindSampler(unit, 0);
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(vertex_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

}  // namespace biotope
