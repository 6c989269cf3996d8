#include "render/detail_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/base/random.hpp"

namespace biotope {

namespace {

/// Smooth value noise on a lattice of `period` cells that repeats; x and y in lattice cells.
float value_noise(float x, float y, int period, std::uint64_t what) {
  const int ix = int(std::floor(x));
  const int iy = int(std::floor(y));
  const auto fade = [](float t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const float fx = fade(x - float(ix));
  const float fy = fade(y - float(iy));
  const auto corner = [&](int cx, int cy) {
    return float(random_unit({what, std::uint64_t((cx + period) % period), std::uint64_t((cy + period) % period)}));
  };
  const float top = corner(ix, iy) * (1 - fx) + corner(ix + 1, iy) * fx;
  const float bottom = corner(ix, iy + 1) * (1 - fx) + corner(ix + 1, iy + 1) * fx;
  return top * (1 - fy) + bottom * fy;
}

/// Octaves of value noise from `period` cells a tile upwards, u and v in 0..1; about 0..1.
float fractal(float u, float v, int period, int octaves, float gain, std::uint64_t what) {
  float sum = 0;
  float weight = 0;
  float amplitude = 1;
  for (int i = 0; i < octaves; ++i, period *= 2, amplitude *= gain) {
    sum += amplitude * value_noise(u * float(period), v * float(period), period, what + std::uint64_t(i));
    weight += amplitude;
  }
  return sum / weight;
}

/// What lies at a place of a field of rounded stones (or crowns, or tussocks): one in every cell of a lattice that repeats.
struct Stone {
  float height;  ///< 1 on top, 0 between stones
  float tone;    ///< its own, 0..1
};

class StoneField {
 public:
  explicit StoneField(int period) : stones_(period, period) {
    for (int y = 0; y < period; ++y) {
      for (int x = 0; x < period; ++x) {
        const auto part = [&](std::uint64_t what) {
          return float(random_unit({0x73746f6e65ULL + what, std::uint64_t(x), std::uint64_t(y)}));
        };
        stones_(x, y) = {0.15F + 0.7F * part(0), 0.15F + 0.7F * part(1), 0.55F + 0.3F * part(2), part(3)};
      }
    }
  }

  /// x and y in lattice cells.
  [[nodiscard]] Stone at(float x, float y) const {
    const int period = stones_.width();
    const int ix = int(std::floor(x));
    const int iy = int(std::floor(y));
    Stone best{0, 0.5F};
    for (int cy = iy - 1; cy <= iy + 1; ++cy) {
      for (int cx = ix - 1; cx <= ix + 1; ++cx) {
        const Place& stone = stones_((cx + period) % period, (cy + period) % period);
        const float away = std::hypot(x - float(cx) - stone.x, y - float(cy) - stone.y) / stone.radius;
        const float height = std::sqrt(std::max(0.0F, 1 - away * away));
        if (height > best.height) best = {height, stone.tone};
      }
    }
    return best;
  }

 private:
  struct Place {
    float x, y, radius, tone;
  };
  Grid<Place> stones_;
};

/// Spreads values around one half and keeps them in 0..1.
float contrast(float value, float by) { return std::clamp(0.5F + (value - 0.5F) * by, 0.0F, 1.0F); }

}  // namespace

Grid<Rgba> detail_noise(int side) {
  constexpr int stones_a_side = 32;
  const StoneField stones(stones_a_side);
  Grid<float> bumps(side, side);
  Grid<float> tones(side, side);
  Grid<Rgba> out(side, side);
  parallel_rows(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const float u = float(x) / float(side);
      const float v = float(y) / float(side);
      const Stone stone = stones.at(u * stones_a_side, v * stones_a_side);
      bumps(x, y) = 0.75F * fractal(u, v, 16, 5, 0.62F, 0x62756d70ULL) + 0.10F * stone.height;
      tones(x, y) = 0.62F * stone.height + 0.38F * stone.tone;
    }
  });
  parallel_rows(0, side, [&](int y) {
    for (int x = 0; x < side; ++x) {
      const float u = float(x) / float(side);
      const float v = float(y) / float(side);
      const auto bump = [&](int cx, int cy) { return bumps((cx + side) % side, (cy + side) % side); };
      const float east = (bump(x + 1, y) - bump(x - 1, y)) * 4.5F;
      const float north = (bump(x, y - 1) - bump(x, y + 1)) * 4.5F;
      const float grain = contrast(0.55F * fractal(u, v, 32, 4, 0.8F, 0x677261696eULL) + 0.45F * (tones(x, y) - 0.15F), 2.1F);
      const float cloud = contrast(fractal(u, v, 4, 6, 0.55F, 0x636c6f7564ULL), 1.9F);
      const auto code = [](float value) { return std::uint8_t(std::lround(std::clamp(value, 0.0F, 1.0F) * 255)); };
      out(x, y) = {code(0.5F + 0.5F * east), code(0.5F + 0.5F * north), code(grain), code(cloud)};
    }
  });
  return out;
}

}  // namespace biotope
