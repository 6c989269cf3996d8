#include "core/terrain/derivatives.hpp"

#include <cmath>
#include <numbers>

#include "core/base/parallel.hpp"
#include "core/terrain/ground_tiles.hpp"

namespace biotope {
namespace {

/// Three neighbouring rows of heights and what turns their differences into slopes.
struct RowStencil {
  std::span<const float> north;
  std::span<const float> middle;
  std::span<const float> south;
  float east_scale = 0;   ///< 1 / (4 x run) between the columns used
  float north_scale = 0;  ///< 1 / (4 x run) between the rows used
  float bend_north = 0;   ///< 1 / cell area where both rows exist, 0 at the border
  float bend_east = 0;
};

struct RowOutput {
  std::span<float> east;
  std::span<float> north;
  std::span<float> slope;
  std::span<float> curvature;
};

/// One cell whose western and eastern columns are given: equal to its own at the border.
inline void differentiate(const RowStencil& s, const RowOutput& out, std::size_t west, std::size_t x, std::size_t east) {
  const float dx = (s.north[east] - s.north[west]) + 2 * (s.middle[east] - s.middle[west]) + (s.south[east] - s.south[west]);
  const float dy = (s.north[west] - s.south[west]) + 2 * (s.north[x] - s.south[x]) + (s.north[east] - s.south[east]);
  const float gx = dx * s.east_scale;
  const float gy = dy * s.north_scale;
  const float twice = 2 * s.middle[x];
  out.east[x] = gx;
  out.north[x] = gy;
  out.slope[x] = std::sqrt(gx * gx + gy * gy);
  out.curvature[x] = (s.middle[west] + s.middle[east] - twice) * s.bend_east + (s.north[x] + s.south[x] - twice) * s.bend_north;
}

}  // namespace

void differentiate(const Terrain& terrain, const Rect& cells, Derivatives& out) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  const float cell = float(terrain.cell_size);
  const float bend = 1 / (cell * cell);
  const std::size_t last = std::size_t(width) - 1;
  for (int y = cells.y0; y < cells.y1; ++y) {
    const int above = std::max(y - 1, 0);
    const int below = std::min(y + 1, height - 1);
    const int rows = below - above;
    RowStencil stencil{terrain.height.row(above),
                       terrain.height.row(y),
                       terrain.height.row(below),
                       1 / (8 * cell),
                       rows > 0 ? 1 / (4 * cell * float(rows)) : 0.0F,
                       rows == 2 ? bend : 0.0F,
                       bend};
    const RowOutput row{out.east.row(y), out.north.row(y), out.slope.row(y), out.curvature.row(y)};
    const auto first_inside = std::max<std::size_t>(1, std::size_t(cells.x0));
    const auto end_inside = std::min(last, std::size_t(cells.x1));
    for (std::size_t x = first_inside; x < end_inside; ++x) differentiate(stencil, row, x - 1, x, x + 1);
    stencil.east_scale = width > 1 ? 1 / (4 * cell) : 0.0F;
    stencil.bend_east = 0;
    if (cells.x0 == 0) differentiate(stencil, row, 0, 0, std::min<std::size_t>(1, last));
    if (last > 0 && cells.x1 == width) differentiate(stencil, row, last - 1, last, last);
  }
}

Derivatives compute_derivatives(const Terrain& terrain) {
  const int width = terrain.height.width();
  const int height = terrain.height.height();
  Derivatives result{Grid<float>::shareable(width, height), Grid<float>::shareable(width, height),
                     Grid<float>::shareable(width, height), Grid<float>::shareable(width, height)};
  parallel_rows(0, height, [&](int y) { differentiate(terrain, {0, y, width, y + 1}, result); });
  return result;
}

float aspect(float east, float north) {
  if (east == 0 && north == 0) return 0;
  // The ground faces where it falls: against the gradient.
  const float angle = std::atan2(-east, -north);
  return angle < 0 ? angle + 2 * std::numbers::pi_v<float> : angle;
}

}  // namespace biotope
