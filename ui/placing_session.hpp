#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ui/placing.hpp"

namespace biotope {

/// What the next click on a view places; `none` leaves it to the chosen tool.
enum class PlacingTool : std::uint8_t { none, inflow, river, lake, ford, exit, waypoint, pin_trail, forbid_trail, bend_trail };

/// The views that one places on.
enum class PlacingView : std::uint8_t { map, landscape };

/// Placing and drawing in progress; nothing of it is in the document until it is finished.
struct PlacingSession {
  PlacingTool tool = PlacingTool::none;
  /// Points of the line being drawn.
  std::vector<PathPoint> line;
  std::optional<PlacedItem> selected;
  /// The handle being dragged, and things as they will be when it is let go.
  std::optional<PlacedHandle> held;
  std::optional<PlacedThings> preview;
  /// A route being bent, and where it was taken.
  std::optional<TrailBend> bend;
  TrailStretch stretch;
  /// Radius of a stretch that bends, m.
  float bend_reach = 180;

  /// The press that is still down was for placing.
  bool took_press = false;
  /// The view that the press was made on: what it took hold of follows the pointer there and nowhere else.
  PlacingView pressed_on = PlacingView::map;

  /// True while a click or drag on a view belongs to placing.
  [[nodiscard]] bool busy() const { return tool != PlacingTool::none || held || bend; }
};

}  // namespace biotope
