#include "render/map_textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace biotope {
namespace {

constexpr Sampling smooth_mipmapped{GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE};

template <class Texel>
std::vector<const Grid<Texel>*> levels_of(const Grid<Texel>& finest, const std::vector<Grid<Texel>>& mipmaps) {
  std::vector<const Grid<Texel>*> levels{&finest};
  for (const Grid<Texel>& level : mipmaps) levels.push_back(&level);
  return levels;
}

}  // namespace

void MapGround::ask(const MapRequest& request) {
  if (asked_ && *asked_ == request) return;
  asked_ = request;
  idle_ = false;
  maker_.request(request);
}

void MapGround::take(std::shared_ptr<const MapPicture> picture) {
  coming_ = std::move(picture);
  if (!coming_) return;
  if (!shown_ || shown_->relief != coming_->relief) {
    const MapRelief& relief = *coming_->relief;
    heights_.want(coming_, levels_of(coming_->heights(), relief.height_mipmaps), smooth_mipmapped);
    relief_.want(coming_, levels_of(relief.relief, relief.relief_mipmaps), smooth_mipmapped);
  }
  if (coming_->water && (!shown_ || shown_->water != coming_->water)) {
    water_.want(coming_, levels_of(coming_->water->wet, coming_->water->wet_mipmaps), smooth_mipmapped);
  }
}

bool MapGround::upload(UploadBudget& budget) {
  const bool there = (!relief_.coming() || relief_.upload(budget)) && (!heights_.coming() || heights_.upload(budget)) &&
                     (!water_.coming() || water_.upload(budget));
  if (!there) return false;
  if (relief_.coming()) relief_.show();
  if (heights_.coming()) heights_.show();
  if (water_.coming()) water_.show();
  if (!coming_->water) water_.drop();
  maker_.retire(std::exchange(shown_, std::exchange(coming_, nullptr)));
  return true;
}

bool MapGround::bring_in(UploadBudget& budget) {
  if (!asked_) return false;
  idle_ = !maker_.busy();
  heights_.tidy(budget);
  relief_.tidy(budget);
  water_.tidy(budget);
  for (bool changed = false;; changed = true) {
    if (!coming_) take(maker_.take());
    if (!coming_ || !upload(budget)) return changed;
  }
}

bool OverlayTexture::bring_in(const MapOverlay& wanted, UploadBudget& budget) {
  grid_.tidy(budget);
  if (!wanted.cells || wanted.cells->empty()) return false;
  if (!grid_.coming() && shown_ && shown_->cells == wanted.cells) {
    shown_ = wanted;
    return false;
  }
  if (coming_cells_ != wanted.cells || !grid_.coming()) {
    coming_cells_ = wanted.cells;
    const GLint filter = wanted.colours == ColourMap::categorical ? GL_NEAREST : GL_LINEAR;
    grid_.want(wanted.cells, {wanted.cells.get()}, {filter, filter, GL_CLAMP_TO_EDGE});
  }
  if (!grid_.upload(budget)) return false;
  grid_.show();
  shown_ = wanted;
  coming_cells_.reset();
  return true;
}

void OverlayTexture::patch(const Grid<float>& cells, const Rect& rect) {
  const bool coming = coming_cells_.get() == &cells && grid_.coming();
  const Rect part = intersection(rect, cells.rect());
  if (part.empty() || (!coming && (!shown_ || shown_->cells.get() != &cells))) return;
  // What is not begun yet will have it anyway.
  if (coming && !grid_.back()) return;
  (void)upload_texels(coming ? grid_.back() : grid_.texture(), 0, part, cells.cells().data() + cells.index(part.x0, part.y0),
                      cells.width());
}

Rect PaintTexture::set(const PaintLayer& layer) {
  Rect changed;
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
    changed = bounding(changed, rect);
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
  return changed;
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
