#include <algorithm>

#include "core/movement/fine_path.hpp"

namespace biotope {
namespace {

/// Rounds of rounding corners; each moves a point halfway to the middle of its neighbours. Our choice: blurs over two to three
/// steps each side.
constexpr int rounds = 10;
/// Points of the rounded path from one control point of the spline to the next.
constexpr std::size_t spacing = 3;

PathPoint mix(PathPoint a, PathPoint b, float t) { return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; }

/// Moves points only where both lines to their neighbours stay clear: what held for the cells holds for the line.
void round_corners(const FineGround& ground, std::span<const std::uint8_t> fixed, std::vector<PathPoint>& points) {
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (!fixed.empty() && fixed[i]) continue;
      const PathPoint moved = mix(points[i], mix(points[i - 1], points[i + 1], 0.5F), 0.5F);
      if (ground.allows(points[i - 1], moved) && ground.allows(moved, points[i + 1])) points[i] = moved;
    }
  }
}

/// Uniform Catmull-Rom between b and c.
PathPoint catmull_rom(PathPoint a, PathPoint b, PathPoint c, PathPoint d, float t) {
  const auto along = [t](float p, float q, float r, float s) {
    return 0.5F * (2 * q + (r - p) * t + (2 * p - 5 * q + 4 * r - s) * t * t + (3 * q - p - 3 * r + s) * t * t * t);
  };
  return {along(a.x, b.x, c.x, d.x), along(a.y, b.y, c.y, d.y)};
}

/// Appends the span from control `i` to the next, by spline or, where that would leave passable ground, by the points themselves.
void append_span(const FineGround& ground, const std::vector<PathPoint>& points, const std::vector<std::size_t>& controls,
                 std::size_t i, std::vector<PathPoint>& out) {
  const auto control = [&](std::size_t k) { return points[controls[std::min(k, controls.size() - 1)]]; };
  const PathPoint before = control(i == 0 ? 0 : i - 1);
  const std::size_t count = controls[i + 1] - controls[i];
  const std::size_t first = out.size();
  PathPoint last = control(i);
  bool clear = true;
  for (std::size_t k = 1; k <= count && clear; ++k) {
    const PathPoint next =
        k == count ? control(i + 1) : catmull_rom(before, control(i), control(i + 1), control(i + 2), float(k) / float(count));
    clear = ground.allows(last, next);
    out.push_back(next);
    last = next;
  }
  if (clear) return;
  out.resize(first);
  for (std::size_t k = controls[i] + 1; k <= controls[i + 1]; ++k) out.push_back(points[k]);
}

}  // namespace

std::vector<PathPoint> points_of(std::span<const PathCell> cells) {
  std::vector<PathPoint> points;
  points.reserve(cells.size());
  for (const PathCell& cell : cells) points.push_back({float(cell.x), float(cell.y)});
  return points;
}

void round_path(const FineGround& ground, std::span<const std::uint8_t> fixed, std::vector<PathPoint>& points) {
  assert(fixed.size() == points.size());
  round_corners(ground, fixed, points);
}

std::vector<PathPoint> smooth_path(const FineGround& ground, std::vector<PathPoint> points) {
  if (points.size() < 3) return points;
  round_corners(ground, {}, points);
  std::vector<std::size_t> controls;
  for (std::size_t i = 0; i < points.size(); i += spacing) controls.push_back(i);
  if (points.size() - 1 - controls.back() > 0) {
    if (points.size() - 1 - controls.back() == 1 && controls.size() > 1) controls.pop_back();
    controls.push_back(points.size() - 1);
  }
  std::vector<PathPoint> line{points.front()};
  line.reserve(points.size());
  for (std::size_t i = 0; i + 1 < controls.size(); ++i) append_span(ground, points, controls, i, line);
  return line;
}

}  // namespace biotope
