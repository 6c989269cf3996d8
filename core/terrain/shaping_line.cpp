#include <algorithm>
#include <array>
#include <cmath>

#include "core/terrain/shaping.hpp"

namespace biotope {
namespace {

double distance(PathPoint a, PathPoint b) { return std::hypot(double(b.x) - double(a.x), double(b.y) - double(a.y)); }

PathPoint mirrored(PathPoint point, PathPoint about) { return {2 * about.x - point.x, 2 * about.y - point.y}; }

PathPoint between(PathPoint a, PathPoint b, double ta, double tb, double t) {
  const double share = (t - ta) / (tb - ta);
  return {float(double(a.x) + (double(b.x) - double(a.x)) * share), float(double(a.y) + (double(b.y) - double(a.y)) * share)};
}

/// The stretch from p[1] to p[2] of the spline (Barry and Goldman 1988), without its first point.
void append_stretch(const std::array<PathPoint, 4>& p, float step, std::vector<PathPoint>& line) {
  std::array<double, 4> knot{};
  for (std::size_t i = 1; i < 4; ++i) knot[i] = knot[i - 1] + std::sqrt(std::max(distance(p[i - 1], p[i]), 1e-6));
  // The curve is hardly ever longer than one and a half times its chord.
  const int pieces = std::max(1, int(std::ceil(1.5 * distance(p[1], p[2]) / double(step))));
  for (int i = 1; i < pieces; ++i) {
    const double t = knot[1] + (knot[2] - knot[1]) * i / pieces;
    const PathPoint a1 = between(p[0], p[1], knot[0], knot[1], t);
    const PathPoint a2 = between(p[1], p[2], knot[1], knot[2], t);
    const PathPoint a3 = between(p[2], p[3], knot[2], knot[3], t);
    const PathPoint b1 = between(a1, a2, knot[0], knot[2], t);
    const PathPoint b2 = between(a2, a3, knot[1], knot[3], t);
    line.push_back(between(b1, b2, knot[1], knot[2], t));
  }
  line.push_back(p[2]);
}

}  // namespace

std::vector<PathPoint> smooth_line(std::span<const PathPoint> points, bool closed, float step) {
  std::vector<PathPoint> own;
  for (const PathPoint& point : points) {
    if (own.empty() || !(own.back() == point)) own.push_back(point);
  }
  while (closed && own.size() > 1 && own.back() == own.front()) own.pop_back();
  if (own.size() < 2) return own;
  const auto count = std::ptrdiff_t(own.size());
  const auto at = [&](std::ptrdiff_t i) {
    if (closed) return own[std::size_t((i + count) % count)];
    if (i < 0) return mirrored(own[1], own[0]);
    return i < count ? own[std::size_t(i)] : mirrored(own[std::size_t(count - 2)], own[std::size_t(count - 1)]);
  };
  std::vector<PathPoint> line{own.front()};
  for (std::ptrdiff_t i = 0; i < (closed ? count : count - 1); ++i) {
    append_stretch({at(i - 1), at(i), at(i + 1), at(i + 2)}, step, line);
  }
  return line;
}

}  // namespace biotope
