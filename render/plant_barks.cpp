#include "core/base/random.hpp"
#include "render/plant_leaf_canvas.hpp"

namespace biotope {

namespace {

/// A cell of a lattice that repeats over the picture.
float lattice(int x, int y, int columns, int rows, std::uint64_t what) {
  const auto wrapped = [](int v, int period) { return std::uint64_t(((v % period) + period) % period); };
  return float(mix_bits((what << 32U) + (wrapped(y, rows) << 16U) + wrapped(x, columns) + 0x6261726bULL) >> 40U) * 0x1.0p-24F;
}

/// Smooth noise 0..1 with `columns` x `rows` cells over the picture, which it repeats. u, v: 0..1.
float noise(float u, float v, int columns, int rows, std::uint64_t what) {
  const float x = u * float(columns);
  const float y = v * float(rows);
  const int ix = int(std::floor(x));
  const int iy = int(std::floor(y));
  const float fx = glm::smoothstep(0.0F, 1.0F, x - float(ix));
  const float fy = glm::smoothstep(0.0F, 1.0F, y - float(iy));
  const auto at = [&](int dx, int dy) { return lattice(ix + dx, iy + dy, columns, rows, what); };
  return glm::mix(glm::mix(at(0, 0), at(1, 0), fx), glm::mix(at(0, 1), at(1, 1), fx), fy);
}

/// Distance from the nearest border between plates 0..1, and a value of the plate's own.
struct Plate {
  float border = 0;
  float own = 0;
};
Plate plate(float u, float v, int columns, int rows, std::uint64_t what) {
  const float x = u * float(columns);
  const float y = v * float(rows);
  float nearest = 9;
  float second = 9;
  float own = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int cx = int(std::floor(x)) + dx;
      const int cy = int(std::floor(y)) + dy;
      const float px = float(cx) + 0.15F + 0.7F * lattice(cx, cy, columns, rows, what);
      const float py = float(cy) + 0.15F + 0.7F * lattice(cx, cy, columns, rows, what + 1);
      const float distance = std::hypot(px - x, py - y);
      if (distance < nearest) {
        second = nearest;
        nearest = distance;
        own = lattice(cx, cy, columns, rows, what + 2);
      } else {
        second = std::min(second, distance);
      }
    }
  }
  return {second - nearest, own};
}

template <class Shade>
Grid<Rgba> bark(const Shade& shade) {
  Grid<Rgba> picture(leaf_picture_side, leaf_picture_side);
  for (int y = 0; y < leaf_picture_side; ++y) {
    for (int x = 0; x < leaf_picture_side; ++x) {
      const float value = shade((float(x) + 0.5F) / leaf_picture_side, (float(y) + 0.5F) / leaf_picture_side);
      picture(x, y) = {std::uint8_t(std::lround(std::clamp(128 * value, 0.0F, 255.0F))), 0, 255, 255};
    }
  }
  return picture;
}

}  // namespace

Grid<Rgba> furrowed_bark() {
  return bark([](float u, float v) {
    // Ridges that part and meet, cut across here and there.
    const float astray = 0.05F * (noise(u, v, 5, 4, 1) - 0.5F) + 0.02F * (noise(u, v, 14, 10, 2) - 0.5F);
    const float ridge = std::abs(2 * noise(u + astray, v, 17, 3, 3) - 1);
    const float fine = std::abs(2 * noise(u + astray, v, 40, 9, 4) - 1);
    const float cut = glm::smoothstep(0.72F, 0.85F, noise(u, v, 20, 26, 5));
    const float height = glm::smoothstep(0.04F, 0.55F, ridge) * (0.8F + 0.2F * fine) * (1 - 0.35F * cut);
    return 0.34F + 0.80F * height + 0.30F * (noise(u, v, 90, 60, 6) - 0.5F);
  });
}

Grid<Rgba> birch_bark() {
  return bark([](float u, float v) {
    // White skin that peels in rings, dark dashes across, black scars where limbs were.
    const float ring = noise(u, v, 3, 40, 7);
    const float dash = glm::smoothstep(0.80F, 0.88F, noise(u, v, 9, 70, 8)) * glm::smoothstep(0.35F, 0.6F, noise(u, v, 4, 9, 9));
    const float scar = glm::smoothstep(0.86F, 0.97F, noise(u, v, 4, 6, 10) + 0.14F * (noise(u, v, 24, 30, 11) - 0.5F));
    return (1.02F + 0.12F * (ring - 0.5F) + 0.10F * (noise(u, v, 60, 60, 12) - 0.5F)) * (1 - 0.72F * dash) * (1 - 0.70F * scar);
  });
}

Grid<Rgba> smooth_bark() {
  return bark([](float u, float v) {
    // Grey skin with pale lichen, fine wrinkles across, and flutes along the stem.
    const float lichen = glm::smoothstep(0.52F, 0.66F, noise(u, v, 6, 5, 13) + 0.16F * (noise(u, v, 26, 22, 14) - 0.5F));
    const float wrinkle = noise(u, v, 8, 90, 15);
    const float flute = noise(u, v, 6, 2, 16);
    return 0.78F + 0.24F * lichen + 0.16F * (wrinkle - 0.5F) + 0.30F * (flute - 0.5F) + 0.14F * (noise(u, v, 70, 70, 17) - 0.5F);
  });
}

Grid<Rgba> plated_bark() {
  return bark([](float u, float v) {
    // Long plates with narrow cracks between them, of flakes.
    const float astray = 0.05F * (noise(u, v, 11, 9, 18) - 0.5F) + 0.02F * (noise(u, v, 30, 24, 30) - 0.5F);
    const Plate large = plate(u + astray, v + 0.6F * astray, 11, 5, 19);
    const float crack = glm::smoothstep(0.0F, 0.16F + 0.14F * noise(u, v, 7, 7, 31), large.border);
    const float flake = noise(u, v, 26, 40, 22);
    return (0.46F + 0.52F * crack) * (0.82F + 0.32F * large.own) +
           (0.42F * (flake - 0.5F) + 0.2F * (noise(u, v, 80, 80, 32) - 0.5F)) * crack;
  });
}

Grid<Rgba> stone_face() {
  return bark([](float u, float v) {
    const float lichen = glm::smoothstep(0.60F, 0.72F, noise(u, v, 9, 9, 23) + 0.2F * (noise(u, v, 34, 34, 24) - 0.5F));
    return (0.62F + 0.42F * noise(u, v, 7, 7, 28) + 0.28F * (noise(u, v, 64, 64, 29) - 0.5F) + 0.28F * lichen);
  });
}

}  // namespace biotope
