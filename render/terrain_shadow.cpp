#include "render/terrain_shadow.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Sweeps lines 0 .. `lines` - 1 of `length` cells away from the light; cell(line, i) is the index of a cell. The shadow's height comes from the
/// line before at i + shift, lowered by `drop`.
template <class CellIndex>
void sweep(const Grid<float>& surface, int lines, int length, float shift, float drop, float softness, const CellIndex& cell,
           Grid<std::uint8_t>& out) {
  const auto count = std::size_t(length);
  std::vector<float> before(count, -1e9F);
  std::vector<float> here(count, 0.0F);
  for (int line = 0; line < lines; ++line) {
    for (int i = 0; i < length; ++i) {
      const float from = std::clamp(float(i) + shift, 0.0F, float(length - 1));
      const int low = std::min(int(from), std::max(0, length - 2));
      const float t = from - float(low);
      const float shadow = before[std::size_t(low)] * (1 - t) + before[std::size_t(std::min(low + 1, length - 1))] * t - drop;
      const std::size_t index = cell(line, i);
      const float lit = 1 - std::clamp((shadow - surface[index]) / softness, 0.0F, 1.0F);
      out[index] = std::uint8_t(lit * 255);
      here[std::size_t(i)] = std::max(shadow, surface[index]);
    }
    before.swap(here);
  }
}

}  // namespace

Grid<std::uint8_t> sweep_shadows(const Grid<float>& surface, double cell_size, const glm::vec3& light, float softness) {
  const int width = surface.width();
  const int height = surface.height();
  Grid<std::uint8_t> out(width, height, 255);
  const float flat = std::hypot(light.x, light.y);
  if (surface.empty() || flat < 1e-4F || light.z <= 0) return out;
  const float east = light.x / flat;
  const float south = -light.y / flat;
  const float tangent = light.z / flat;
  if (std::abs(east) >= std::abs(south)) {
    const float drop = tangent * float(cell_size) / std::abs(east);
    const auto cell = [&](int line, int i) { return surface.index(east > 0 ? width - 1 - line : line, i); };
    sweep(surface, width, height, south / std::abs(east), drop, softness, cell, out);
  } else {
    const float drop = tangent * float(cell_size) / std::abs(south);
    const auto cell = [&](int line, int i) { return surface.index(i, south > 0 ? height - 1 - line : line); };
    sweep(surface, height, width, east / std::abs(south), drop, softness, cell, out);
  }
  return out;
}

Grid<float> thinned(const Grid<float>& surface, int stride) {
  Grid<float> out(surface.width() / stride, surface.height() / stride);
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) out(x, y) = surface(x * stride + stride / 2, y * stride + stride / 2);
  }
  return out;
}

}  // namespace biotope
