#pragma once

#include <memory>
#include <vector>

#include "render/spare_texture.hpp"
#include "render/texel_pyramid.hpp"

namespace biotope {

/// A texture that is brought up to date over several frames while its old picture stays in sight: a new one is filled behind it,
/// or, where little differs, a few tiles are replaced at the moment of show().
template <class Texel>
class StreamedTexture {
 public:
  explicit StreamedTexture(const Sampling& sampling) : sampling_(sampling) {}

  /// What shall be shown next.
  void want(std::shared_ptr<const TexelPyramid<Texel>> texels) {
    wanted_ = std::move(texels);
    if (back_) spare_.keep(std::move(back_), back_shape_);
    find_changes();
    const std::size_t bytes = changes_.size() * sizeof(typename TiledMap<Texel>::Tile);
    behind_ = !texture_ || !same_shape() || bytes > bytes_in_place;
    if (behind_) list_all();
  }
  /// Uploads what the budget allows; true when show() may be called.
  bool upload(UploadBudget& budget) {
    if (!behind_) return true;
    if (!back_) {
      const TiledMap<Texel>& whole = wanted_->levels.front();
      back_shape_ = {format_of(Texel{}).internal, whole.width(), whole.height(), int(wanted_->levels.size()), sampling_};
      auto texture = spare_.take(back_shape_, budget);
      if (!texture) return false;
      back_ = std::move(*texture);
    }
    while (!changes_.empty()) {
      if (budget.spent()) return false;
      budget.take(upload_tile(back_, changes_.back()));
      changes_.pop_back();
    }
    return true;
  }
  /// Shows what was wanted, now that it is uploaded.
  void show() {
    if (behind_) {
      if (texture_) spare_.keep(std::move(texture_), shape_);
      texture_ = std::move(back_);
      shape_ = back_shape_;
      behind_ = false;
    }
    for (const Place& place : changes_) upload_tile(texture_, place);
    changes_.clear();
    shown_ = wanted_;
  }
  /// Once a frame: gives back what is no longer needed.
  void tidy(UploadBudget& budget) { spare_.tidy(budget); }
  [[nodiscard]] GLuint name() const { return texture_.name(); }

 private:
  /// As much of each of a picture's textures may be replaced within one frame.
  static constexpr std::size_t bytes_in_place = std::size_t(2) << 20;
  struct Place {
    std::size_t level;
    std::size_t tile;
  };

  [[nodiscard]] bool same_shape() const {
    return shown_ && shown_->levels.size() == wanted_->levels.size() &&
           shown_->levels.front().rect() == wanted_->levels.front().rect();
  }
  void find_changes() {
    changes_.clear();
    if (!same_shape()) return;
    for (std::size_t level = 0; level < wanted_->levels.size(); ++level) {
      const TiledMap<Texel>& now = wanted_->levels[level];
      for (std::size_t tile = 0; tile < now.tile_count(); ++tile) {
        if (now.tile(tile) != shown_->levels[level].tile(tile)) changes_.push_back({level, tile});
      }
    }
  }
  void list_all() {
    changes_.clear();
    for (std::size_t level = 0; level < wanted_->levels.size(); ++level) {
      for (std::size_t tile = 0; tile < wanted_->levels[level].tile_count(); ++tile) changes_.push_back({level, tile});
    }
  }
  std::size_t upload_tile(const Texture& texture, const Place& place) const {
    const TiledMap<Texel>& map = wanted_->levels[place.level];
    const Rect rect = map.tile_rect(place.tile);
    return upload_texels(texture, int(place.level), rect, map.tile(place.tile)->data(), tile_side);
  }

  Sampling sampling_;
  Texture texture_;
  TextureShape shape_;
  /// Whether what is wanted is filled behind what is shown.
  bool behind_ = false;
  Texture back_;
  TextureShape back_shape_;
  SpareTexture spare_;
  std::shared_ptr<const TexelPyramid<Texel>> shown_;
  std::shared_ptr<const TexelPyramid<Texel>> wanted_;
  std::vector<Place> changes_;
};

}  // namespace biotope
