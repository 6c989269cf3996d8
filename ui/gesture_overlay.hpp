#pragma once

#include <memory>
#include <vector>

#include "ui/mask_outline.hpp"
#include "ui/view_pen.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// The line, rectangle or lasso that the left button is drawing.
void draw_gesture(ImDrawList& list, const Theme& theme, const ToolGesture& gesture, const ViewPen& pen);

/// The selection's border laid over a view that is not flat.
class GroundOutline {
 public:
  void draw(const UiContext& ui, const ViewPen& pen);

 private:
  std::shared_ptr<const SelectionMask> of_;
  std::vector<OutlinePiece> pieces_;
};

}  // namespace biotope
