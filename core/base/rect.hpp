#pragma once

#include <algorithm>

namespace biotope {

/// A half-open rectangle of grid cells: columns [x0, x1), rows [y0, y1). Row 0 is the northern edge.
struct Rect {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  [[nodiscard]] constexpr int width() const { return x1 - x0; }
  [[nodiscard]] constexpr int height() const { return y1 - y0; }
  [[nodiscard]] constexpr bool empty() const { return x1 <= x0 || y1 <= y0; }
  [[nodiscard]] constexpr bool contains(int x, int y) const {
    return x >= x0 && x < x1 && y >= y0 && y < y1;
  }
  constexpr bool operator==(const Rect&) const = default;
};

/// The cells that lie in both rectangles; empty when there are none.
[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

/// The smallest rectangle that holds both; an empty one does not count.
[[nodiscard]] constexpr Rect bounding(const Rect& a, const Rect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// The rectangle grown by `cells` on every side.
[[nodiscard]] constexpr Rect grown(const Rect& r, int cells) {
  return {r.x0 - cells, r.y0 - cells, r.x1 + cells, r.y1 + cells};
}

}  // namespace biotope
