#pragma once

#include <array>
#include <vector>

#include "render/map_renderer.hpp"

namespace biotope {

/// A size or a place on the canvas, pixels, y down from its upper left corner.
struct PixelPoint {
  double x = 0;
  double y = 0;
};

/// Cell coordinates under a pixel (0, 0 is the centre of the north-west cell).
[[nodiscard]] PathPoint cell_at(const MapView& view, PixelPoint canvas, PixelPoint pixel);
/// Pixel of a place in cell coordinates.
[[nodiscard]] PixelPoint pixel_of(const MapView& view, PixelPoint canvas, double cell_x, double cell_y);
/// The view zoomed by `factor` with the place under `pixel` held still; scale kept between `least` and `most` pixels a cell.
[[nodiscard]] MapView zoomed(const MapView& view, PixelPoint canvas, PixelPoint pixel, double factor, double least, double most);
/// The view moved with the hand by a number of pixels.
[[nodiscard]] MapView panned(const MapView& view, PixelPoint moved);
/// The view that shows `cells` whole with a margin of `margin` pixels.
[[nodiscard]] MapView fitted(const Rect& cells, PixelPoint canvas, double margin);
/// The view with its centre kept on the map, so that the sheet is never lost.
[[nodiscard]] MapView kept_on_map(const MapView& view, int width, int height);

/// Round numbers between low and high (ends included where they are round), at most `most` of them.
[[nodiscard]] std::vector<double> round_ticks(double low, double high, int most);

/// A bar of a round length not longer than `most_pixels`.
struct ScaleBar {
  double metres = 0;
  double pixels = 0;
};
[[nodiscard]] ScaleBar scale_bar(double metres_per_pixel, double most_pixels);

}  // namespace biotope
