#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/status.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// Which part of the map fills the view.
struct MapView {
  double centre_x = 0;  ///< cells
  double centre_y = 0;
  double pixels_per_cell = 1;
};

enum class ColourMap : int { viridis, greens, browns, blues, inferno, diverging, categorical };

/// One map over the terrain.
struct MapOverlay {
  /// Cells to show; the pointer's identity decides whether to upload again.
  std::shared_ptr<const Grid<float>> cells;
  float low = 0;
  float high = 1;
  ColourMap colours = ColourMap::viridis;
  float opacity = 0.85F;
  /// Values at or below this are left clear (NaN: nothing is).
  float clear_below = 0;
};

/// What is drawn on the 2D map.
struct MapOptions {
  MapView view;
  std::optional<MapOverlay> overlay;
  bool water = true;
  bool contours = true;
  bool trails = true;
  bool herds = true;
  double hour = 10.5;
  /// Paint to hatch; null for none.
  std::shared_ptr<const PaintLayer> hatched;
  /// Places to hatch in red: painted beyond what resources allow; null for none.
  std::shared_ptr<const PaintLayer> beyond;
  /// Multiplies the width of lines, marks and hatches on screens of high density.
  float pixel_scale = 1;
  std::vector<bool> visible_species;
  bool dark = true;
  /// Difference of the overlay between its iso-lines, in its unit; 0 draws none.
  float line_step = 0;
};

/// True when everything but the herds would be drawn alike.
[[nodiscard]] bool same_ground(const MapOptions& a, const MapOptions& b);

/// Draws the 2D map with OpenGL: hill-shaded terrain, water, overlay, contours, trails, herds. Needs a current OpenGL 4.5 core
/// context.
class MapRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<MapRenderer>> create();
  ~MapRenderer();
  MapRenderer(const MapRenderer&) = delete;
  MapRenderer& operator=(const MapRenderer&) = delete;

  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot);
  /// Tells that cells of `rect` of the overlay uploaded last have changed in place (a brush stroke); uploads only those.
  void patch_overlay(const Grid<float>& cells, const Rect& rect);
  /// Draws into the framebuffer bound now, over width x height pixels. Never waits: ground and maps are prepared on a thread of
  /// their own and come in over a few frames; what was there before stays in sight.
  void draw(const MapOptions& options, int width, int height);
  /// Waits until everything is there that draw() would show only after some frames: for pictures and tests.
  void finish_loading(const MapOptions& options);
  /// False while something is still to come in: draw again soon.
  [[nodiscard]] bool complete() const;

 private:
  MapRenderer();
  struct State;
  std::unique_ptr<State> state_;
};

/// Colour of `t` in 0..1, for legends.
[[nodiscard]] std::array<float, 3> colour_of(ColourMap map, float t);

}  // namespace biotope
