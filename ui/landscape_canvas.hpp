#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/landscape_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "ui/camera_gestures.hpp"
#include "ui/gesture_overlay.hpp"
#include "ui/landscape_drape.hpp"
#include "ui/landscape_overlay.hpp"
#include "ui/mini_map.hpp"
#include "ui/picture_export.hpp"
#include "ui/view_transform.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// The 3D view in a part of the window: orbit, fly, walk, follow, paint and ask. Drawn only when something changed; coarser while
/// it moves on a slow machine, sharp again when it rests.
class LandscapeCanvas {
 public:
  [[nodiscard]] static Result<std::unique_ptr<LandscapeCanvas>> create();

  /// Draws into the current Dear ImGui window, `size` pixels, and handles mouse and keys over it.
  void draw(const UiContext& ui, ImVec2 size);
  /// True while keys fly the camera: letters are then no shortcuts.
  [[nodiscard]] bool takes_letters() const { return takes_letters_; }
  /// True while a sharper picture is still to come, or the camera or what it sees moves by itself.
  [[nodiscard]] bool refining() const { return refining_ || moving_ || awaiting_ || !drape_.complete(); }
  /// Revision of the document whose ground and plants the picture shows, all of them; 0 while some are still to come.
  [[nodiscard]] std::uint64_t answered() const {
    return has_picture_ && renderer_->complete() && drawn_.snapshot ? drawn_.snapshot->document_revision : 0;
  }
  /// Once a frame, whether the view is shown or not: pictures and videos that were asked for are drawn, a slice at a time.
  void make_pictures(EditorState& state);
  [[nodiscard]] bool makes_pictures() const { return exporter_.running(); }

 private:
  struct Picture {
    Camera camera;
    LandscapeOptions options;
    std::shared_ptr<const MapsSnapshot> snapshot;
    int width = 0;
    int height = 0;
  };
  LandscapeCanvas(std::unique_ptr<LandscapeRenderer> renderer, LandscapeOverlay overlay, LandscapeDrape drape);
  void place_camera(EditorState& state);
  /// Whether the picture is of the plans that are shown: it may be of older ones for a while.
  [[nodiscard]] bool draws_shown_plans(const EditorState& state) const;
  /// Where the followed animal or herd is now, m.
  [[nodiscard]] std::optional<glm::dvec3> followed_place(const EditorState& state);
  /// Sets the quality of the level, measured where it is automatic.
  void follow_quality(EditorState& state);
  /// What moves by itself: quality, flights, what is followed, the camera's path, leaves and water.
  void advance(EditorState& state);
  [[nodiscard]] Picture wanted_picture(const EditorState& state, int width, int height) const;
  /// Share of the resolution that is to be drawn at now; nothing when the picture that is there serves. `news`: the renderer has
  /// something that it has not drawn yet.
  [[nodiscard]] std::optional<double> resolution_now(const EditorState& state, const Picture& wanted, bool news);
  /// Whether a picture that takes long is better drawn a little later: an edit was posted, and what it changes is not there yet.
  [[nodiscard]] bool waits_for_edit(const Picture& wanted, double now);
  /// Takes what a picture cost into account for the next ones.
  void learn_from(double seconds, double resolution);
  /// Notes since when an edit waits for the picture that answers it.
  void await_answer(const EditorState& state, const MapsSnapshot& wanted);
  void draw_picture(const EditorState& state, int width, int height);
  void handle_mouse(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered, bool active);
  /// How far the pointer takes hold of things, in cells, where it is.
  [[nodiscard]] float reach_at_pointer(const UiContext& ui, PixelPoint canvas) const;
  /// What a person placed and draws.
  void draw_things(const UiContext& ui, ImVec2 origin, ImVec2 size);
  void draw_camera_path(const EditorState& state);
  /// All that lies over the picture.
  void draw_over(const UiContext& ui, ImVec2 origin, ImVec2 size);
  void draw_menu(const UiContext& ui) const;
  void handle_tool(const UiContext& ui, PixelPoint canvas, bool hovered);
  void follow_stroke(const UiContext& ui, PixelPoint canvas);

  std::unique_ptr<LandscapeRenderer> renderer_;
  LandscapeOverlay overlay_;
  LandscapeDrape drape_;
  std::unique_ptr<RenderTarget> target_;
  Picture drawn_;
  /// Revision of the snapshot for which the camera was last placed.
  std::uint64_t placed_for_ = 0;
  bool has_picture_ = false;
  bool software_ = false;  ///< drawn by the processor
  double resolution_ = 1;  ///< share of the full resolution while moving
  double drawn_resolution_ = 0;
  double drawn_at_ = 0;       ///< time of the last picture, s
  double drawn_seconds_ = 0;  ///< what it took, s
  bool measuring_ = false;
  bool measures_now_ = false;             ///< this picture is one of those
  std::vector<double> measured_seconds_;  ///< of pictures at level low
  std::uint64_t awaited_ = 0;             ///< revision of the document that was posted last
  double awaited_since_ = 0;              ///< s
  bool awaiting_ = false;                 ///< its picture is not there, and it was posted just now
  double waits_since_ = -1;               ///< since when a picture is put off for it, s; below 0: it is not
  double last_change_ = 0;                ///< time of the last change of the picture, s
  bool refining_ = false;
  bool takes_letters_ = false;
  bool moving_ = false;  ///< the camera or what it sees moves by itself
  CameraGestures gestures_;
  MiniMap mini_map_;
  PictureExporter exporter_;
  std::optional<glm::dvec3> under_pointer_;
  PathPoint asked_;
  ImVec2 origin_;              ///< upper left corner on the screen
  bool paints_ = false;        ///< the stroke in progress began here
  bool pressed_here_ = false;  ///< a button went down over the view and is not yet let go
  GroundOutline outline_;
};

}  // namespace biotope
