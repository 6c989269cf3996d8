#pragma once

#include "render/map_drape.hpp"
#include "ui/drape_texels.hpp"
#include "ui/landscape_overlay.hpp"
#include "ui/shown_map.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// Whether the map that is looked at lies over the 3D view: always, where somebody asked for it, else while it is painted. Ground
/// that is raised or lowered is seen without.
[[nodiscard]] bool drapes_map(const EditorState& state);

/// The map over the 3D view, up to date with the brush in every frame. Another map comes in bands, over several frames where it
/// is large.
class LandscapeDrape {
 public:
  [[nodiscard]] static Result<LandscapeDrape> create();
  /// Brings the map up to date and lays it over the picture that `list` showed last. `colours`: OpenGL's name of the picture.
  void draw(const UiContext& ui, ImDrawList& list, const LandscapeOverlay::Picture& picture, unsigned colours);
  /// False while bands of the map are still to come.
  [[nodiscard]] bool complete() const { return !shown_ || next_row_ >= texels_.height(); }

 private:
  [[nodiscard]] DrapeSource wanted(EditorState& state);
  void refresh(const DrapeSource& source, const Rect& map, const Rect& changed);
  /// Colours the next bands, for some milliseconds.
  void colour_on(const Rect& map);
  static void draw_now(const ImDrawList* list, const ImDrawCmd* command);

  MapDrape drape_;
  ShownMap map_;
  DrapeSource source_;
  Grid<Rgba> texels_;
  int step_ = 1;
  bool shown_ = false;
  int next_row_ = 0;  ///< of texels, the first that is still to be coloured
  /// Where it is drawn on the screen, pixels.
  ImVec2 origin_;
  MapDrape::Picture picture_;
};

}  // namespace biotope
