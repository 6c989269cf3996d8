#pragma once

#include <memory>

#include "render/gl_objects.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// The small map in the corner of the 3D view: shaded ground, water, herds and where the camera stands and looks. A click or a
/// drag brings the camera there. Needs a current OpenGL context.
class MiniMap {
 public:
  /// Takes the mouse; before the view's own button, in the view's corner. `origin` and `size` are the view's.
  void handle(const UiContext& ui, ImVec2 origin, ImVec2 size);
  /// Draws over the view's picture.
  void draw(const UiContext& ui);

 private:
  struct Frame {
    ImVec2 low{};
    ImVec2 size{};
  };
  void follow(const EditorState& state);

  Texture picture_;
  std::shared_ptr<const Terrain> terrain_;
  std::shared_ptr<const Hydrology> hydrology_;
  std::shared_ptr<const Grid<Cover>> trees_;
  double made_at_ = -10;  ///< s; while one paints the ground, not with every dab
  Frame frame_;
  bool visible_ = false;
  bool hovered_ = false;
};

}  // namespace biotope
