#include "render/map_textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace biotope {
namespace {

std::array<float, 2> height_range(const Grid<float>& heights) {
  float lowest = heights.empty() ? 0 : heights[0];
  float highest = lowest;
  for (const float height : heights.cells()) {
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return {lowest, highest};
}

}  // namespace

void ReliefTexture::set_terrain(std::shared_ptr<const Terrain> terrain) {
  if (terrain == terrain_) return;
  terrain_ = std::move(terrain);
  rows_ = rows_done_ = 0;
  if (!terrain_ || terrain_->height.empty()) return;
  const Grid<float>& heights = terrain_->height;
  const Sampling smooth{GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE};
  heights_ = make_texture_2d(GL_R32F, heights.width(), heights.height(), 0, smooth);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage2D(heights_.name(), 0, 0, 0, heights.width(), heights.height(), GL_RED, GL_FLOAT, heights.cells().data());
  glGenerateTextureMipmap(heights_.name());
  relief_ = make_texture_2d(GL_RGBA8, heights.width(), heights.height(), 0, smooth);
  const std::array<float, 4> neutral{0.62F, 0.62F, 0.54F, 0.5F};
  for (int level = 0; level < full_mip_levels(heights.width(), heights.height()); ++level) {
    glClearTexImage(relief_.name(), level, GL_RGBA, GL_FLOAT, neutral.data());
  }
  framebuffer_ = make_framebuffer();
  glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, relief_.name(), 0);
  rows_ = heights.height();
  const auto range = height_range(heights);
  lowest_ = range[0];
  highest_ = range[1];
}

void ReliefTexture::shade_some(const ShaderProgram& program, std::size_t cells) {
  if (complete()) return;
  const int width = terrain_->height.width();
  const int count = std::clamp(int(cells / std::size_t(width)), 1, rows_ - rows_done_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width, rows_);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, rows_done_, width, count);
  glDisable(GL_BLEND);
  program.use();
  program.set("height_map", 0);
  program.set("height_range", glm::vec2(lowest_, highest_));
  program.set("cell_size", float(terrain_->cell_size));
  // Coarse cells have lost their slopes; a little more exaggeration brings the relief back (our choice).
  program.set("exaggeration", float(std::clamp(1.15 * std::pow(terrain_->cell_size / 4, 0.25), 1.0, 2.5)));
  glBindTextureUnit(0, heights_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_SCISSOR_TEST);
  rows_done_ += count;
  if (complete()) glGenerateTextureMipmap(relief_.name());
}

Texture water_texture(const Hydrology& hydrology) {
  const int width = hydrology.water.width();
  const int height = hydrology.water.height();
  std::vector<std::uint8_t> texels(hydrology.water.size() * 2);
  for (std::size_t i = 0; i < hydrology.water.size(); ++i) {
    const bool wet = hydrology.water[i] != WaterKind::dry;
    // Depths of 20 m and more are all deep.
    const float deep = std::sqrt(std::clamp(hydrology.water_depth[i] / 20, 0.0F, 1.0F));
    texels[2 * i] = wet ? 255 : 0;
    texels[2 * i + 1] = std::uint8_t(std::lround(deep * 255));
  }
  Texture texture = make_texture_2d(GL_RG8, width, height, 0, {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RG, GL_UNSIGNED_BYTE, texels.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glGenerateTextureMipmap(texture.name());
  return texture;
}

void OverlayTexture::set(const std::shared_ptr<const Grid<float>>& cells, bool smooth) {
  if (cells_ == cells || !cells || cells->empty()) return;
  cells_ = cells;
  if (!texture_ || width_ != cells->width() || height_ != cells->height()) {
    width_ = cells->width();
    height_ = cells->height();
    texture_ = make_texture_2d(GL_R32F, width_, height_, 1, {});
  }
  const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
  glTextureParameteri(texture_.name(), GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(texture_.name(), GL_TEXTURE_MAG_FILTER, filter);
  patch(*cells, cells->rect());
}

void OverlayTexture::patch(const Grid<float>& cells, const Rect& rect) {
  const Rect part = intersection(rect, {0, 0, width_, height_});
  if (!texture_ || part.empty() || cells.width() != width_ || cells.height() != height_) return;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, width_);
  glTextureSubImage2D(texture_.name(), 0, part.x0, part.y0, part.width(), part.height(), GL_RED, GL_FLOAT,
                      cells.cells().data() + cells.index(part.x0, part.y0));
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void PaintTexture::set(const PaintLayer& layer) {
  if (!texture_ || layer.width() != width_ || layer.height() != height_) {
    width_ = layer.width();
    height_ = layer.height();
    texture_ = make_texture_2d(GL_R8, width_, height_, 1, {});
    clear();
  }
  tiles_.resize(layer.tile_count());
  std::vector<std::uint8_t> coverage;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t i = 0; i < layer.tile_count(); ++i) {
    if (tiles_[i] == layer.tile(i)) continue;
    // Holding the pointer keeps the tile from being changed in place, so that a new pointer always means new cells.
    tiles_[i] = layer.tile(i);
    const Rect rect = layer.tile_rect(i);
    coverage.clear();
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        const float covered = tiles_[i] ? (*tiles_[i])[PaintLayer::offset(x, y)].coverage : layer.background().coverage;
        coverage.push_back(std::uint8_t(std::lround(std::clamp(covered, 0.0F, 1.0F) * 255)));
      }
    }
    glTextureSubImage2D(texture_.name(), 0, rect.x0, rect.y0, rect.width(), rect.height(), GL_RED, GL_UNSIGNED_BYTE,
                        coverage.data());
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void PaintTexture::clear() {
  tiles_.clear();
  if (!texture_) return;
  const std::uint8_t none = 0;
  glClearTexImage(texture_.name(), 0, GL_RED, GL_UNSIGNED_BYTE, &none);
}

bool KeptPicture::resize(int width, int height) {
  if (framebuffer_ && width == width_ && height == height_) return false;
  width_ = width;
  height_ = height;
  colour_ = make_texture_2d(GL_RGBA8, width, height, 1, {});
  framebuffer_ = make_framebuffer();
  glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
  return true;
}

void KeptPicture::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width_, height_);
}

void KeptPicture::copy_to(GLuint framebuffer) const {
  glBlitNamedFramebuffer(framebuffer_.name(), framebuffer, 0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

}  // namespace biotope
