#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/terrain/sun.hpp"

namespace biotope {
namespace {

/// Longest side of the horizon grid unless the caller asks for another stride. Our choice: far horizons change slowly.
constexpr int longest_horizon_side = 512;

int chosen_stride(const Grid<float>& height) {
  int stride = 1;
  while (std::max(height.width(), height.height()) > longest_horizon_side * stride) stride *= 2;
  return stride;
}

/// Mean heights of stride x stride blocks.
Grid<float> coarse_heights(const Grid<float>& height, int stride) {
  if (stride == 1) return height;
  const int width = (height.width() + stride - 1) / stride;
  const int rows = (height.height() + stride - 1) / stride;
  Grid<float> coarse(width, rows);
  parallel_rows(0, rows, [&](int cy) {
    std::vector<double> sums(std::size_t(width), 0.0);
    const int y1 = std::min((cy + 1) * stride, height.height());
    for (int y = cy * stride; y < y1; ++y) {
      const auto row = height.row(y);
      for (int x = 0; x < height.width(); ++x) sums[std::size_t(x / stride)] += double(row[std::size_t(x)]);
    }
    for (int cx = 0; cx < width; ++cx) {
      const int columns = std::min((cx + 1) * stride, height.width()) - cx * stride;
      coarse(cx, cy) = float(sums[std::size_t(cx)] / (columns * (y1 - cy * stride)));
    }
  });
  return coarse;
}

/// A family of parallel lines that visits every cell once: step along the major axis, drift along the minor one.
struct LineFamily {
  bool along_x = true;   ///< major axis
  bool ascending = true; ///< whether the sector's direction is toward greater major coordinates
  double drift = 0;      ///< minor cells per major cell
};

LineFamily line_family(double azimuth) {
  const double east = std::sin(azimuth);
  const double south = -std::cos(azimuth);
  if (std::abs(east) >= std::abs(south)) return {true, east > 0, south / east};
  return {false, south > 0, east / south};
}

struct HullPoint {
  float distance;
  float height;
};

/// Horizons of one sector: each line is scanned from its far end, keeping the upper convex hull of what lies ahead.
void scan_sector(const Grid<float>& height, double azimuth, float cell, Grid<float>& tangents) {
  const LineFamily family = line_family(azimuth);
  const int major = family.along_x ? height.width() : height.height();
  const int minor = family.along_x ? height.height() : height.width();
  // A line passes beside the cells' centres: its height there is between those of two cells, or a step aside would pass for a slope.
  std::vector<int> shift(std::size_t(major), 0);
  std::vector<float> aside(std::size_t(major), 0);
  for (int m = 0; m < major; ++m) {
    shift[std::size_t(m)] = int(std::floor(m * family.drift + 0.5));
    aside[std::size_t(m)] = float(m * family.drift - shift[std::size_t(m)]);
  }
  const int least = std::min(0, shift.back());
  const int most = std::max(0, shift.back());
  const float step = cell * float(std::sqrt(1 + family.drift * family.drift));
  std::vector<HullPoint> hull(std::size_t(major) + 1);
  for (int line = -most; line < minor - least; ++line) {
    std::size_t top = 0;
    for (int k = 0; k < major; ++k) {
      const int m = family.ascending ? major - 1 - k : k;
      const int n = line + shift[std::size_t(m)];
      if (n < 0 || n >= minor) continue;
      const std::size_t cell_index = family.along_x ? height.index(m, n) : height.index(n, m);
      const float beyond = aside[std::size_t(m)];
      const int beside = std::clamp(n + (beyond < 0 ? -1 : 1), 0, minor - 1);
      const float other = family.along_x ? height(m, beside) : height(beside, m);
      const HullPoint here{float(k) * step, height[cell_index] + std::abs(beyond) * (other - height[cell_index])};
      float tangent = 0;
      if (top > 0) {
        tangent = (hull[top - 1].height - here.height) / (here.distance - hull[top - 1].distance);
        while (top > 1) {
          const float next = (hull[top - 2].height - here.height) / (here.distance - hull[top - 2].distance);
          if (next < tangent) break;
          tangent = next;
          --top;
        }
      }
      tangents[cell_index] = std::max(tangent, 0.0F);
      hull[top++] = here;
    }
  }
}

}  // namespace

Horizons compute_horizons(const Terrain& terrain, int sectors, int stride) {
  Horizons horizons;
  horizons.stride = stride > 0 ? stride : chosen_stride(terrain.height);
  const Grid<float> coarse = coarse_heights(terrain.height, horizons.stride);
  horizons.sectors.assign(std::size_t(sectors), Grid<float>(coarse.width(), coarse.height()));
  const float cell = float(terrain.cell_size * horizons.stride);
  parallel_each(std::size_t(sectors), [&](std::size_t sector) {
    scan_sector(coarse, 2 * std::numbers::pi * double(sector) / sectors, cell, horizons.sectors[sector]);
  });
  return horizons;
}

}  // namespace biotope
