#pragma once

#include <span>
#include <vector>

#include "core/terrain/terrain.hpp"
#include "render/overlay_lines.hpp"
#include "ui/view_pen.hpp"

namespace biotope {

/// Lines over the 3D view: laid on the ground or through the air, faint where something hides them.
class LandscapeOverlay {
 public:
  /// The picture that lines are laid over.
  struct Picture {
    Camera camera;
    DepthPicture depth;
    /// Upper left corner and size on the screen, pixels.
    ImVec2 origin;
    ImVec2 size;
    float scale = 1;  ///< of the window
  };
  [[nodiscard]] static Result<LandscapeOverlay> create();

  /// Forgets the lines of the frame before and makes room for new ones at this place of `list`: they are drawn when the list is.
  void begin(ImDrawList& list, const Picture& picture);
  /// Draws on a ground, which must live as long as the pen; the pen as long as this frame.
  [[nodiscard]] ViewPen pen(const Terrain& ground);
  /// A line through places in metres.
  void add_way(std::span<const glm::dvec3> places, const LineLook& look);

 private:
  void add(OverlayLine line);
  static void draw_now(const ImDrawList* list, const ImDrawCmd* command);

  OverlayLines lines_;
  Picture picture_;
  std::vector<OverlayVertex> vertices_;
};

/// Within a callback of a draw list: sets viewport and scissors to a part of the window, pixels.
void set_overlay_viewport(const ImDrawCmd& command, ImVec2 origin, ImVec2 size);

/// Whether the ground hides a place from an eye, m.
[[nodiscard]] bool hidden_by_ground(const Terrain& ground, const glm::dvec3& eye, const glm::dvec3& place);
/// Whether any of a ring on the ground (cells) lies in a picture of `size` pixels, hidden or not.
[[nodiscard]] bool ring_in_picture(const Terrain& ground, const Camera& camera, const glm::vec2& size, PathPoint centre,
                                   float radius);

}  // namespace biotope
