#include "core/terrain/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.hpp"

namespace biotope {
namespace {

/// Weights of the four lattice points around a fraction 0..1 for a uniform cubic B-spline.
std::array<float, 4> spline_weights(float f) {
  const float g = 1 - f;
  return {g * g * g / 6, (4 - 6 * f * f + 3 * f * f * f) / 6, (4 - 6 * g * g + 3 * g * g * g) / 6, f * f * f / 6};
}

}  // namespace

SmoothNoise::SmoothNoise(std::uint64_t seed, double side, double wavelength) : inverse_wavelength_(1 / wavelength) {
  const int points = int(std::ceil(side / wavelength)) + 4;
  lattice_ = Grid<float>(points, points);
  for (int y = 0; y < points; ++y) {
    for (int x = 0; x < points; ++x) lattice_(x, y) = float(2 * random_unit({seed, std::uint64_t(x), std::uint64_t(y)}) - 1);
  }
}

float SmoothNoise::operator()(double x, double y) const {
  const double limit = lattice_.width() - 4;
  const double px = std::clamp(x * inverse_wavelength_, 0.0, limit);
  const double py = std::clamp(y * inverse_wavelength_, 0.0, limit);
  const int ix = int(px);
  const int iy = int(py);
  const auto wx = spline_weights(float(px - ix));
  const auto wy = spline_weights(float(py - iy));
  float sum = 0;
  for (int j = 0; j < 4; ++j) {
    const float* row = &lattice_(ix, iy + j);
    sum += wy[std::size_t(j)] * (wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3]);
  }
  return sum;
}

LayeredNoise::LayeredNoise(std::uint64_t seed, double side, double wavelength, int octaves, float gain) : gain_(gain) {
  for (int i = 0; i < octaves; ++i) {
    layers_.emplace_back(mix_bits(seed + std::uint64_t(i)), side, wavelength);
    wavelength /= 2;
  }
}

float LayeredNoise::operator()(double x, double y) const {
  float sum = 0;
  float height = 1;
  for (const SmoothNoise& layer : layers_) {
    sum += height * layer(x, y);
    height *= gain_;
  }
  return sum;
}

}  // namespace biotope
