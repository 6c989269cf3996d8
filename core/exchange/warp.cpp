#include "core/exchange/warp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.hpp"

namespace biotope {
namespace {

/// Cells between exact coordinates. Over 16 cells of 30 m a UTM grid line bends by less than a thousandth of a cell.
constexpr int lattice_step = 16;

/// Source cell coordinates (0, 0 is a cell's centre) at every 16th corner of the target grid.
Grid<PlanePoint> source_lattice(const WarpPlan& plan) {
  Grid<PlanePoint> lattice((plan.width - 1) / lattice_step + 2, (plan.height - 1) / lattice_step + 2);
  const AffineTransform to_cell = inverse(plan.source_transform);
  std::vector<PlanePoint> points(std::size_t(lattice.width()));
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      points[std::size_t(x)] =
          apply(plan.target_transform, {x * lattice_step + 0.5, y * lattice_step + 0.5});
    }
    if (plan.to_source) plan.to_source(points);
    for (int x = 0; x < lattice.width(); ++x) {
      const PlanePoint cell = apply(to_cell, points[std::size_t(x)]);
      lattice(x, y) = {cell.x - 0.5, cell.y - 0.5};
    }
  }
  return lattice;
}

PlanePoint on_lattice(const Grid<PlanePoint>& lattice, int x, int y) {
  const int lx = x / lattice_step;
  const int ly = y / lattice_step;
  const double fx = double(x % lattice_step) / lattice_step;
  const double fy = double(y % lattice_step) / lattice_step;
  const auto blend = [&](double PlanePoint::*axis) {
    const double north = lattice(lx, ly).*axis * (1 - fx) + lattice(lx + 1, ly).*axis * fx;
    const double south = lattice(lx, ly + 1).*axis * (1 - fx) + lattice(lx + 1, ly + 1).*axis * fx;
    return north * (1 - fy) + south * fy;
  };
  return {blend(&PlanePoint::x), blend(&PlanePoint::y)};
}

/// Whether a point lies on the source's cells (to their outer edges, with a hundredth of a cell for rounding).
bool on_source(const Grid<float>& source, PlanePoint at) {
  constexpr double edge = 0.51;
  return at.x >= -edge && at.y >= -edge && at.x <= source.width() - 1 + edge && at.y <= source.height() - 1 + edge;
}

/// Bilinear over the neighbours that have data; nothing when the nearest one has none.
float sample_known(const Grid<float>& source, PlanePoint at) {
  const double x = std::clamp(at.x, 0.0, source.width() - 1.0);
  const double y = std::clamp(at.y, 0.0, source.height() - 1.0);
  if (std::isnan(source(int(std::lround(x)), int(std::lround(y))))) return std::nanf("");
  const int ix = int(x);
  const int iy = int(y);
  double sum = 0;
  double weights = 0;
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const double weight = (dx == 0 ? 1 - (x - ix) : x - ix) * (dy == 0 ? 1 - (y - iy) : y - iy);
      if (weight <= 0) continue;
      const float height = source.clamped(ix + dx, iy + dy);
      if (std::isnan(height)) continue;
      sum += weight * double(height);
      weights += weight;
    }
  }
  return float(sum / weights);
}

int outside_in_row(const Grid<std::uint8_t>& inside, const Rect& rect, int y) {
  int count = 0;
  for (int x = rect.x0; x < rect.x1; ++x) count += inside(x, y) == 0;
  return count;
}

int outside_in_column(const Grid<std::uint8_t>& inside, const Rect& rect, int x) {
  int count = 0;
  for (int y = rect.y0; y < rect.y1; ++y) count += inside(x, y) == 0;
  return count;
}

/// Takes away the side with the largest share of cells outside the source until none is left.
Rect without_outside(const Grid<std::uint8_t>& inside) {
  Rect rect = inside.rect();
  while (rect.width() > 1 && rect.height() > 1) {
    const double north = double(outside_in_row(inside, rect, rect.y0)) / rect.width();
    const double south = double(outside_in_row(inside, rect, rect.y1 - 1)) / rect.width();
    const double west = double(outside_in_column(inside, rect, rect.x0)) / rect.height();
    const double east = double(outside_in_column(inside, rect, rect.x1 - 1)) / rect.height();
    const double worst = std::max({north, south, west, east});
    if (worst == 0) break;
    if (worst == north) {
      ++rect.y0;
    } else if (worst == south) {
      --rect.y1;
    } else if (worst == west) {
      ++rect.x0;
    } else {
      --rect.x1;
    }
  }
  return rect;
}

}  // namespace

PlanePoint apply(const AffineTransform& t, PlanePoint cell) {
  return {t[0] + cell.x * t[1] + cell.y * t[2], t[3] + cell.x * t[4] + cell.y * t[5]};
}

AffineTransform inverse(const AffineTransform& t) {
  const double determinant = t[1] * t[5] - t[2] * t[4];
  assert(determinant != 0);
  const double a = t[5] / determinant;
  const double b = -t[2] / determinant;
  const double c = -t[4] / determinant;
  const double d = t[1] / determinant;
  return {-(a * t[0] + b * t[3]), a, b, -(c * t[0] + d * t[3]), c, d};
}

WarpedHeights warp_heights(const Grid<float>& source, const WarpPlan& plan) {
  const Grid<PlanePoint> lattice = source_lattice(plan);
  Grid<float> warped(plan.width, plan.height, std::nanf(""));
  Grid<std::uint8_t> inside(plan.width, plan.height);
  parallel_rows(0, plan.height, [&](int y) {
    for (int x = 0; x < plan.width; ++x) {
      const PlanePoint at = on_lattice(lattice, x, y);
      if (!on_source(source, at)) continue;
      inside(x, y) = 1;
      warped(x, y) = sample_known(source, at);
    }
  });
  const Rect kept = without_outside(inside);
  if (kept == warped.rect()) return {std::move(warped), kept};
  Grid<float> cut(kept.width(), kept.height());
  for (int y = 0; y < kept.height(); ++y) {
    std::copy_n(warped.row(kept.y0 + y).data() + kept.x0, kept.width(), cut.row(y).data());
  }
  return {std::move(cut), kept};
}

}  // namespace biotope
