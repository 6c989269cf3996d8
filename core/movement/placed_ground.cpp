#include "core/movement/placed_ground.hpp"

#include <cmath>

#include "core/movement/fine_path.hpp"

namespace biotope {
namespace {

float distance(PathPoint a, PathPoint b) { return std::hypot(b.x - a.x, b.y - a.y); }

PathPoint mix(PathPoint a, PathPoint b, float t) { return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; }

/// The points on the map, without those that follow an equal one.
std::vector<PathPoint> points_on(const Rect& map, std::span<const PathPoint> points) {
  std::vector<PathPoint> result;
  for (const PathPoint& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    const PathPoint inside{std::clamp(point.x, float(map.x0), float(map.x1 - 1)),
                           std::clamp(point.y, float(map.y0), float(map.y1 - 1))};
    if (result.empty() || !(result.back() == inside)) result.push_back(inside);
  }
  return result;
}

/// Centripetal Catmull-Rom between b and c, by the pyramid of Barry and Goldman (1988); no two neighbours are equal.
PathPoint centripetal(PathPoint a, PathPoint b, PathPoint c, PathPoint d, float t) {
  const float t1 = std::sqrt(distance(a, b));
  const float t2 = t1 + std::sqrt(distance(b, c));
  const float t3 = t2 + std::sqrt(distance(c, d));
  const float at = t1 + (t2 - t1) * t;
  const PathPoint ab = mix(a, b, at / t1);
  const PathPoint bc = mix(b, c, (at - t1) / (t2 - t1));
  const PathPoint cd = mix(c, d, (at - t2) / (t3 - t2));
  const PathPoint abc = mix(ab, bc, at / t2);
  const PathPoint bcd = mix(bc, cd, (at - t1) / (t3 - t1));
  return mix(abc, bcd, (at - t1) / (t2 - t1));
}

Rect around(std::span<const PathPoint> points, float reach) {
  Rect rect;
  for (const PathPoint& p : points) {
    const Rect one{int(std::floor(p.x - reach)), int(std::floor(p.y - reach)), int(std::ceil(p.x + reach)) + 1,
                   int(std::ceil(p.y + reach)) + 1};
    rect = rect.empty() ? one : bounding(rect, one);
  }
  return rect;
}

/// Of a corridor, cells: narrower ones would have holes.
float corridor_radius(const ForbiddenTrail& trail, double cell_size) { return std::max(0.75F, float(trail.radius / cell_size)); }

}  // namespace

std::vector<PathPoint> line_through(std::span<const PathPoint> points, float spacing, const Rect& map) {
  const std::vector<PathPoint> through = points_on(map, points);
  if (through.size() < 2) return {};
  std::vector<PathPoint> line{through.front()};
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const PathPoint b = through[i];
    const PathPoint c = through[i + 1];
    // Before its first point and after its last a line goes on straight.
    const PathPoint a = i > 0 ? through[i - 1] : mix(b, c, -1);
    const PathPoint d = i + 2 < through.size() ? through[i + 2] : mix(c, b, -1);
    const int pieces = std::max(1, int(std::ceil(distance(b, c) / spacing)));
    for (int k = 1; k < pieces; ++k) {
      const PathPoint p = centripetal(a, b, c, d, float(k) / float(pieces));
      line.push_back({std::clamp(p.x, float(map.x0), float(map.x1 - 1)), std::clamp(p.y, float(map.y0), float(map.y1 - 1))});
    }
    line.push_back(c);
  }
  return line;
}

PlacedGround::PlacedGround(const Ground& ground) {
  if (!ground.places) return;
  const Places& places = *ground.places;
  const Rect map = ground.terrain->height.rect();
  const double cell_size = ground.terrain->cell_size;
  const int stride = std::clamp(int(std::lround(trail_step / cell_size)), 1, 8);
  const auto include = [&](std::span<const PathPoint> points, float reach) {
    bounds_ = bounding(bounds_, intersection(map, around(points, reach)));
  };
  for (std::size_t i = 0; i < places.pinned_trails.size(); ++i) {
    const PinnedTrail& trail = places.pinned_trails[i];
    PinnedLine line{int(i), std::max(0.0F, trail.weight), line_through(trail.points, float(stride), map)};
    if (line.points.size() < 2) continue;
    include(line.points, float(stride));
    lines_.push_back(std::move(line));
  }
  std::vector<std::vector<PathPoint>> corridors;
  for (const ForbiddenTrail& trail : places.forbidden_trails) {
    corridors.push_back(points_on(map, trail.points));
    include(corridors.back(), corridor_radius(trail, cell_size));
  }
  if (bounds_.empty()) return;
  marks_ = Grid<std::uint8_t>(bounds_.width(), bounds_.height(), none);
  for (std::size_t c = 0; c < corridors.size(); ++c) {
    const auto& points = corridors[c];
    const float radius = corridor_radius(places.forbidden_trails[c], cell_size);
    for (std::size_t i = 0; i < points.size(); ++i) mark_forbidden(points[i], points[std::min(i + 1, points.size() - 1)], radius);
  }
  for (const PinnedLine& line : lines_) mark_pinned(line, stride / 2);
}

void PlacedGround::mark_forbidden(PathPoint a, PathPoint b, float radius) {
  const std::array ends{a, b};
  const Rect rows = intersection(bounds_, around(ends, radius));
  const PathPoint along{b.x - a.x, b.y - a.y};
  const float squared = along.x * along.x + along.y * along.y;
  const auto joined = [&](PathPoint p) {
    return std::any_of(lines_.begin(), lines_.end(), [&](const PinnedLine& line) {
      return distance(line.points.front(), p) <= radius + 1 || distance(line.points.back(), p) <= radius + 1;
    });
  };
  for (int y = rows.y0; y < rows.y1; ++y) {
    // The part of the line that is near enough to this row says where the row can be near enough to it.
    float first = 0;
    float last = 1;
    if (along.y != 0) {
      const float low = (float(y) - radius - a.y) / along.y;
      const float high = (float(y) + radius - a.y) / along.y;
      first = std::clamp(std::min(low, high), 0.0F, 1.0F);
      last = std::clamp(std::max(low, high), 0.0F, 1.0F);
    }
    const float x0 = a.x + along.x * first;
    const float x1 = a.x + along.x * last;
    const int left = std::max(rows.x0, int(std::floor(std::min(x0, x1) - radius)));
    const int right = std::min(rows.x1, int(std::ceil(std::max(x0, x1) + radius)) + 1);
    for (int x = left; x < right; ++x) {
      const PathPoint p{float(x), float(y)};
      const float t = squared > 0 ? std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) / squared, 0.0F, 1.0F) : 0.0F;
      if (distance(p, mix(a, b, t)) <= radius && !joined(p)) marks_(x - bounds_.x0, y - bounds_.y0) = forbidden;
    }
  }
}

void PlacedGround::mark_pinned(const PinnedLine& line, int reach) {
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const int pieces = std::max(1, int(std::ceil(2 * distance(line.points[i], line.points[i + 1]))));
    for (int k = 0; k <= pieces; ++k) {
      const PathCell cell = cell_at(mix(line.points[i], line.points[i + 1], float(k) / float(pieces)));
      const Rect square = intersection(bounds_, {cell.x - reach, cell.y - reach, cell.x + reach + 1, cell.y + reach + 1});
      for (int y = square.y0; y < square.y1; ++y) {
        for (int x = square.x0; x < square.x1; ++x) marks_(x - bounds_.x0, y - bounds_.y0) = pinned;
      }
    }
  }
}

bool PlacedGround::forbids(PathPoint a, PathPoint b) const {
  if (empty() || std::max(a.x, b.x) < float(bounds_.x0) - 1 || std::min(a.x, b.x) > float(bounds_.x1) ||
      std::max(a.y, b.y) < float(bounds_.y0) - 1 || std::min(a.y, b.y) > float(bounds_.y1)) {
    return false;
  }
  const int samples = int(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / 0.4F) + 1;
  for (int i = 0; i <= samples; ++i) {
    const PathCell cell = cell_at(mix(a, b, float(i) / float(samples)));
    if (at(cell.x, cell.y) == forbidden) return true;
  }
  return false;
}

}  // namespace biotope
