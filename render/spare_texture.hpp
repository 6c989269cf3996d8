#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include "render/texel_upload.hpp"

namespace biotope {

/// What a texture's storage is made for.
struct TextureShape {
  GLenum format = GL_R8;
  int width = 0;
  int height = 0;
  int levels = 1;
  Sampling sampling;

  bool operator==(const TextureShape& other) const = default;
};

/// A texture that was shown before and is filled anew for the next picture: making and freeing one of a large map takes a
/// software renderer longer than a frame. Where no next picture comes it is given back.
class SpareTexture {
 public:
  using Clock = std::chrono::steady_clock;

  /// A texture of that shape with any contents. Where it has to be made that is all that a frame may do: nothing when the budget
  /// is spent.
  [[nodiscard]] std::optional<Texture> take(const TextureShape& shape, UploadBudget& budget) {
    if (texture_ && shape_ == shape) return std::exchange(texture_, Texture());
    if (budget.spent()) return std::nullopt;
    budget.take(all);
    return make_texture_2d(shape.format, shape.width, shape.height, shape.levels, shape.sampling);
  }
  void keep(Texture texture, const TextureShape& shape) {
    texture_ = std::move(texture);
    shape_ = shape;
    since_ = Clock::now();
  }
  /// Once a frame.
  void tidy(UploadBudget& budget, Clock::time_point now = Clock::now()) {
    if (!texture_ || now - since_ < longest || budget.spent()) return;
    texture_.reset();
    budget.take(all);
  }
  [[nodiscard]] explicit operator bool() const { return bool(texture_); }

 private:
  /// How long it is kept. Our choice: who paints pauses for some seconds between strokes.
  static constexpr std::chrono::seconds longest{20};
  static constexpr std::size_t all = std::size_t(1) << 40U;

  Texture texture_;
  TextureShape shape_;
  Clock::time_point since_;
};

}  // namespace biotope
