#pragma once

#include <optional>

#include "ui/view_transform.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Draws where the camera of the 3D view stands and looks: a dot and a wedge as wide as its view. `length` in pixels.
void draw_camera_mark(const UiContext& ui, ImDrawList& list, ImVec2 eye, float length);
/// Where the camera stands, cells.
[[nodiscard]] PathPoint camera_cell(const EditorState& state);
/// Brings the camera over (or, on foot, to) a place in cells, as high over the ground as it was.
void move_camera_to(EditorState& state, PathPoint cell);
/// Turns the camera to look at a place in cells.
void aim_camera_at(EditorState& state, PathPoint cell);

/// The camera on the 2D map: shown beside the 3D view; its dot is dragged to move it, the end of its wedge to turn it.
class CameraMark {
 public:
  /// True while the press belongs to it. `pixel` is the pointer's place on the canvas.
  [[nodiscard]] bool handle(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered);
  void draw(const UiContext& ui, ImVec2 origin, PixelPoint canvas) const;

 private:
  enum class Grip : std::uint8_t { none, eye, aim };
  Grip grip_ = Grip::none;
};

}  // namespace biotope
