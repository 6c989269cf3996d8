#include "render/whole_mirror.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/screen_effects.hpp"

namespace biotope {

namespace {

/// Pixels of the longer side: a picture of that size at most is mirrored as finely as it is drawn.
constexpr int most_pixels = 2560;

}  // namespace

void WholeMirror::begin(Of of) {
  const double scale = std::min(1.0, double(most_pixels) / std::max(of.size.x, of.size.y));
  const auto scaled = [&](int side) { return std::max(1, int(std::lround(scale * side))); };
  if (!target_) target_ = std::make_unique<RenderTarget>(scaled(of.size.x), scaled(of.size.y));
  target_->resize(scaled(of.size.x), scaled(of.size.y));
  target_->bind();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  of_ = std::move(of);
}

void WholeMirror::bind() const {
  glBindTextureUnit(ScreenEffects::mirrored_unit, target_->texture());
  glBindTextureUnit(ScreenEffects::mirrored_depth_unit, target_->depth_texture());
}

}  // namespace biotope
