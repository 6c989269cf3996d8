#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/ecosystem/confinement.hpp"
#include "core/movement/travel.hpp"

namespace biotope {

/// A metre within a forbidden corridor is as bad as this many outside: herds make a detour of so much rather than cross. Our
/// choice.
inline constexpr float forbidden_factor = 40;
/// A metre on a pinned trail is chosen before this many beside it: rather than the most worn trail (worn_factor). Our choice.
inline constexpr float pinned_factor = 0.5F;
/// Water in which a pinned trail wears the ground, m: it is drawn across deeper water, but nothing is worn there. Our choice.
inline constexpr float pinned_wade_depth = 1;

/// A pinned trail as a smooth line through its points.
struct PinnedLine {
  int trail = 0;  ///< index in Places::pinned_trails
  float weight = 0;
  std::vector<PathPoint> points;
};

/// A smooth line (centripetal Catmull-Rom) through some points moved onto the map, with points at most `spacing` cells apart.
/// Empty when there are not two different points.
[[nodiscard]] std::vector<PathPoint> line_through(std::span<const PathPoint> points, float spacing, const Rect& map);

/// What a person drew for those who walk: pinned lines and forbidden corridors, on the cells. A corridor is at least 1.5 cells
/// wide; it is open where a pinned trail runs, and around the ends of pinned trails (its radius from them), so that a bent trail
/// stays joined to what it was bent from.
class PlacedGround {
 public:
  PlacedGround() = default;
  explicit PlacedGround(const Ground& ground);

  enum Mark : std::uint8_t { none, forbidden, pinned };
  /// How much more a metre counts in choosing ways; it takes no longer to walk.
  static constexpr std::array<float, 3> factors{1, forbidden_factor, pinned_factor};

  [[nodiscard]] bool empty() const { return marks_.empty(); }
  [[nodiscard]] const Rect& bounds() const { return bounds_; }
  [[nodiscard]] Mark at(int x, int y) const {
    return bounds_.contains(x, y) ? Mark(marks_(x - bounds_.x0, y - bounds_.y0)) : none;
  }
  [[nodiscard]] float factor(int x, int y) const { return factors[at(x, y)]; }
  /// Marks of a row within the bounds, from bounds().x0.
  [[nodiscard]] std::span<const std::uint8_t> row(int y) const { return marks_.row(y - bounds_.y0); }
  /// Whether the straight line enters a forbidden cell (sampled closer than half a cell).
  [[nodiscard]] bool forbids(PathPoint a, PathPoint b) const;
  [[nodiscard]] const std::vector<PinnedLine>& lines() const { return lines_; }

 private:
  void mark_forbidden(PathPoint a, PathPoint b, float radius);
  void mark_pinned(const PinnedLine& line, int reach);

  Rect bounds_;
  /// By cell of `bounds_`.
  Grid<std::uint8_t> marks_;
  std::vector<PinnedLine> lines_;
};

/// Points [first .. last] of a pinned line that lead from one vertex of a travel graph to the next.
struct PinnedStretch {
  std::uint32_t line = 0;  ///< index in PlacedGround::lines
  std::uint32_t from = 0;  ///< vertices
  std::uint32_t to = 0;
  std::uint32_t slot = 0;  ///< the directed edge from `from` to `to`
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
/// Where the mobility of a graph can follow pinned lines: nowhere over cells that are blocked for it.
[[nodiscard]] std::vector<PinnedStretch> pinned_stretches(const TravelGraph& graph, const PlacedGround& placed);

/// Costs of a graph's directed edges as animals choose ways: dearer by the share of their straight line that is forbidden, and
/// cheap along pinned lines. Empty when that is the graph's own costs.
[[nodiscard]] std::vector<float> placed_costs(const Ground& ground, const TravelGraph& graph, const PlacedGround& placed);

}  // namespace biotope
