#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/mask_outline.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Where a place (cells) lies on the screen; nothing when it cannot be seen.
using ScreenPlace = std::function<std::optional<ImVec2>(PathPoint)>;

/// A line between places that lies on the ground: both ends, and places in between at most `step` cells apart.
[[nodiscard]] std::vector<PathPoint> along_ground(PathPoint from, PathPoint to, float step);

/// The line, rectangle or lasso that the left button is drawing; `step` is the longest piece, cells.
void draw_gesture(ImDrawList& list, const Theme& theme, const ToolGesture& gesture, const ScreenPlace& screen, float step);

/// The selection's border laid over a view that is not flat.
class GroundOutline {
 public:
  void draw(const UiContext& ui, const ScreenPlace& screen);

 private:
  std::shared_ptr<const SelectionMask> of_;
  std::vector<OutlinePiece> pieces_;
  float step_ = 1;
};

}  // namespace biotope
