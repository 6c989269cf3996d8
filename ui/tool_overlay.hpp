#pragma once

#include <memory>
#include <vector>

#include "ui/mask_outline.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// What tools draw over the 2D map: the selection's outline, where the brush may not act, what is locked, the gesture in
/// progress, the brush's ring.
class ToolOverlay {
 public:
  /// Between the picture and the pointer; `origin` is the canvas' upper left corner on the screen.
  void draw(const UiContext& ui, ImVec2 origin, PixelPoint canvas);
  /// The ring under the pointer (pixels of the canvas).
  void draw_cursor(const UiContext& ui, ImVec2 origin, PixelPoint canvas, PixelPoint pixel) const;

 private:
  void draw_selection(const UiContext& ui, ImVec2 origin, PixelPoint canvas);
  void draw_film(const UiContext& ui, ImVec2 origin, PixelPoint canvas);
  void draw_locked(const UiContext& ui, ImVec2 origin, PixelPoint canvas);

  /// What the outline and the film were made of.
  struct View {
    MapView view;
    PixelPoint canvas;
    std::shared_ptr<const SelectionMask> selection;
    [[nodiscard]] bool same(const MapView& now, PixelPoint size, const std::shared_ptr<const SelectionMask>& mask) const;
  };
  View outlined_;
  std::vector<OutlinePiece> outline_;
  View filmed_;
  BrushFilter film_filter_;
  FilterMaps film_maps_;
  std::vector<FilmRun> film_;
  View locked_;
  std::vector<FilmRun> locked_film_;
};

}  // namespace biotope
