#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/parallel.hpp"

namespace biotope {

using Rg = std::array<std::uint8_t, 2>;
using Rgba = std::array<std::uint8_t, 4>;

/// Mean of four texels.
[[nodiscard]] inline float mean_of(float a, float b, float c, float d) { return (a + b + c + d) / 4; }
template <std::size_t Channels>
[[nodiscard]] std::array<std::uint8_t, Channels> mean_of(const std::array<std::uint8_t, Channels>& a,
                                                         const std::array<std::uint8_t, Channels>& b,
                                                         const std::array<std::uint8_t, Channels>& c,
                                                         const std::array<std::uint8_t, Channels>& d) {
  std::array<std::uint8_t, Channels> out{};
  for (std::size_t i = 0; i < Channels; ++i) out[i] = std::uint8_t((int(a[i]) + b[i] + c[i] + d[i] + 2) / 4);
  return out;
}

/// A picture of half the size, each texel the mean of two by two. Parallel.
template <class Texel>
[[nodiscard]] Grid<Texel> halved(const Grid<Texel>& fine) {
  Grid<Texel> out(std::max(1, fine.width() / 2), std::max(1, fine.height() / 2));
  parallel_rows(0, out.height(), [&](int y) {
    for (int x = 0; x < out.width(); ++x) {
      out(x, y) = mean_of(fine.clamped(2 * x, 2 * y), fine.clamped(2 * x + 1, 2 * y), fine.clamped(2 * x, 2 * y + 1),
                          fine.clamped(2 * x + 1, 2 * y + 1));
    }
  });
  return out;
}

/// The mipmaps of a picture, from half its size down to one texel.
template <class Texel>
[[nodiscard]] std::vector<Grid<Texel>> mipmaps(const Grid<Texel>& finest) {
  std::vector<Grid<Texel>> levels;
  for (const Grid<Texel>* fine = &finest; fine->width() > 1 || fine->height() > 1; fine = &levels.back()) {
    levels.push_back(halved(*fine));
  }
  return levels;
}

}  // namespace biotope
