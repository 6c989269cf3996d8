#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/grid.hpp"
#include "render/spare_texture.hpp"

namespace biotope {

/// A texture of whole grids that are uploaded over several frames, while the one before stays in sight.
template <class Texel>
class StreamedGrid {
 public:
  /// What shall be shown next: level 0 and its mipmaps, kept alive by `owner`.
  void want(std::shared_ptr<const void> owner, std::vector<const Grid<Texel>*> levels, const Sampling& sampling) {
    owner_ = std::move(owner);
    levels_ = std::move(levels);
    level_ = row_ = 0;
    const TextureShape shape{format_of(Texel{}).internal, levels_.front()->width(), levels_.front()->height(),
                             int(levels_.size()), sampling};
    if (back_ && back_shape_ != shape) spare_.keep(std::move(back_), back_shape_);
    back_shape_ = shape;
  }
  /// Uploads what the budget allows; true when all of it is there and show() may be called.
  bool upload(UploadBudget& budget) {
    if (!back_) {
      auto texture = spare_.take(back_shape_, budget);
      if (!texture) return false;
      back_ = std::move(*texture);
    }
    while (level_ < int(levels_.size())) {
      if (budget.spent()) return false;
      const Grid<Texel>& grid = *levels_[std::size_t(level_)];
      const int rows = std::clamp(band_bytes / int(sizeof(Texel)) / grid.width(), 1, grid.height() - row_);
      budget.take(upload_texels(back_, level_, {0, row_, grid.width(), row_ + rows}, grid.row(row_).data(), grid.width()));
      row_ += rows;
      if (row_ == grid.height()) {
        ++level_;
        row_ = 0;
      }
    }
    return true;
  }
  void show() {
    if (texture_) spare_.keep(std::move(texture_), shape_);
    texture_ = std::move(back_);
    shape_ = back_shape_;
    levels_.clear();
    owner_.reset();
  }
  /// True while something wanted is not yet shown.
  [[nodiscard]] bool coming() const { return !levels_.empty(); }
  /// What is being filled; none before its first texels are uploaded.
  [[nodiscard]] const Texture& back() const { return back_; }
  [[nodiscard]] const Texture& texture() const { return texture_; }
  void drop() { *this = {}; }
  /// Once a frame: gives back what is no longer needed.
  void tidy(UploadBudget& budget) { spare_.tidy(budget); }

 private:
  static constexpr int band_bytes = 256 << 10;

  std::shared_ptr<const void> owner_;
  std::vector<const Grid<Texel>*> levels_;
  int level_ = 0;
  int row_ = 0;
  Texture texture_;
  TextureShape shape_;
  Texture back_;
  TextureShape back_shape_;
  SpareTexture spare_;
};

}  // namespace biotope
