#include "core/document/brush_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.hpp"

namespace biotope {
namespace {

constexpr float diagonal = std::numbers::sqrt2_v<float> / 2;
constexpr std::array<std::array<float, 2>, 8> directions{{{1, 0},
                                                          {diagonal, diagonal},
                                                          {0, 1},
                                                          {-diagonal, diagonal},
                                                          {-1, 0},
                                                          {-diagonal, -diagonal},
                                                          {0, -1},
                                                          {diagonal, -diagonal}}};

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

float mixed(float a, float b, float t) { return a + (b - a) * t; }

}  // namespace

BrushNoise::BrushNoise(std::uint64_t seed, float size, Rect cells) : inverse_size_(1 / std::max(1.0F, size)) {
  // Cells are sampled at their middle: at the lattice's points noise is 0.
  const auto lattice = [&](int cell) { return int(std::floor((float(cell) + 0.5F) * inverse_size_)); };
  first_x_ = lattice(cells.x0);
  first_y_ = lattice(cells.y0);
  gradients_ = Grid<std::array<float, 2>>(lattice(cells.x1 - 1) - first_x_ + 2, lattice(cells.y1 - 1) - first_y_ + 2);
  for (int y = 0; y < gradients_.height(); ++y) {
    for (int x = 0; x < gradients_.width(); ++x) {
      const auto bits = random_bits({seed, std::uint64_t(std::int64_t(first_x_) + x), std::uint64_t(std::int64_t(first_y_) + y)});
      gradients_(x, y) = directions[bits % directions.size()];
    }
  }
}

float BrushNoise::operator()(int x, int y) const {
  const float px = (float(x) + 0.5F) * inverse_size_;
  const float py = (float(y) + 0.5F) * inverse_size_;
  const int ix = int(std::floor(px));
  const int iy = int(std::floor(py));
  const float fx = px - float(ix);
  const float fy = py - float(iy);
  const auto slope = [&](int dx, int dy) {
    const auto& gradient = gradients_(ix - first_x_ + dx, iy - first_y_ + dy);
    return gradient[0] * (fx - float(dx)) + gradient[1] * (fy - float(dy));
  };
  const float u = fade(fx);
  const float v = fade(fy);
  const float sum = mixed(mixed(slope(0, 0), slope(1, 0), u), mixed(slope(0, 1), slope(1, 1), u), v);
  // Unit gradients reach half of the square root of 2.
  return std::clamp(sum * std::numbers::sqrt2_v<float>, -1.0F, 1.0F);
}

}  // namespace biotope
