#pragma once

#include <memory>

#include "render/map_renderer.hpp"
#include "render/offscreen_context.hpp"
#include "ui/camera_mark.hpp"
#include "ui/shown_map.hpp"
#include "ui/tool_overlay.hpp"
#include "ui/view_transform.hpp"
#include "ui/widgets.hpp"

namespace biotope {

/// The 2D map in a part of the window: pan, zoom, paint, ask; drawn again only when something changed.
class MapCanvas {
 public:
  [[nodiscard]] static Result<std::unique_ptr<MapCanvas>> create();

  /// Draws into the current Dear ImGui window, `size` pixels, and handles the mouse over it.
  void draw(const UiContext& ui, ImVec2 size);
  /// True while parts of the picture are still to come in.
  [[nodiscard]] bool refining() const { return !renderer_->complete(); }

 private:
  /// Everything the picture depends on besides the snapshot and the overlay's own pointer.
  struct Picture {
    MapOptions options;
    std::shared_ptr<const MapsSnapshot> snapshot;
    int width = 0;
    int height = 0;
  };
  explicit MapCanvas(std::unique_ptr<MapRenderer> renderer);
  void draw_picture(const UiContext& ui, int width, int height);
  [[nodiscard]] MapOptions options_for(const UiContext& ui);
  void handle_mouse(const UiContext& ui, PixelPoint canvas, PixelPoint pixel, bool hovered);
  void handle_zoom(const UiContext& ui, PixelPoint canvas, PixelPoint pixel) const;
  void handle_tool(const UiContext& ui, PixelPoint canvas, const PathPoint& cell, bool hovered);
  void follow_stroke(const UiContext& ui, PixelPoint canvas);
  /// Edge of what is being computed again, breathing.
  void draw_pulse(const UiContext& ui, ImVec2 origin, PixelPoint canvas) const;
  void draw_cursor(const UiContext& ui, ImVec2 origin, PixelPoint canvas, PixelPoint pixel, bool hovered) const;
  void draw_context_menu(const UiContext& ui);
  /// What a person placed and draws.
  void draw_things(const UiContext& ui, ImVec2 origin, PixelPoint canvas, PixelPoint pixel, bool hovered) const;
  /// Legend, scale bar and north arrow.
  void draw_furniture(const UiContext& ui, ImVec2 origin, ImVec2 size) const;
  void draw_herd_tooltip(const UiContext& ui, PixelPoint canvas, PixelPoint pixel) const;

  std::unique_ptr<MapRenderer> renderer_;
  std::unique_ptr<RenderTarget> target_;
  Picture drawn_;
  bool has_picture_ = false;
  ShownMap map_;
  MapView fitted_;       ///< the view that showed the whole map last
  PathPoint asked_;      ///< cell of the context menu
  ImVec2 origin_;        ///< upper left corner on the screen
  bool paints_ = false;  ///< the stroke or gesture in progress began here
  ToolOverlay overlay_;
  CameraMark camera_mark_;
};

}  // namespace biotope
