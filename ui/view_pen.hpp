#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/base/path_point.hpp"
#include "ui/theme.hpp"

namespace biotope {

/// Where a place (cells) lies on the screen; nothing when it cannot be seen.
using ScreenPlace = std::function<std::optional<ImVec2>(PathPoint)>;

/// How a line over a view looks; widths at scale 1.
struct LineLook {
  ImU32 colour = IM_COL32(255, 255, 255, 235);
  float width = 1.5F;
  ImU32 casing = IM_COL32(0, 0, 0, 150);
  float casing_width = 0.75F;  ///< on either side
  bool dashed = false;
};

/// What lines and marks over a view are drawn with: on the map as they are, in 3D laid on the ground, where hills and trees hide
/// them.
struct ViewPen {
  ScreenPlace place;
  /// A line through places.
  std::function<void(std::span<const PathPoint>, const LineLook&)> line;
  /// Whether a hill hides a place.
  std::function<bool(PathPoint)> hidden;
};

/// Draws into `list` at once; nothing hides anything. The pen is used before list and theme go.
[[nodiscard]] ViewPen flat_pen(ImDrawList& list, const Theme& theme, ScreenPlace place);

/// A colour for a mark at a place: faint where a hill hides it.
[[nodiscard]] ImU32 mark_colour(const ViewPen& pen, PathPoint at, ImU32 colour);

/// A line between places that lies on the ground: both ends, and places in between at most `step` cells apart.
[[nodiscard]] std::vector<PathPoint> along_ground(PathPoint from, PathPoint to, float step);
/// The same through several places.
[[nodiscard]] std::vector<PathPoint> along_ground(std::span<const PathPoint> places, float step);
/// A closed ring around a place, cells.
[[nodiscard]] std::vector<PathPoint> ring_around(PathPoint centre, float radius);

}  // namespace biotope
