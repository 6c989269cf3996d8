#include "ui/view_transform.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

PathPoint cell_at(const MapView& view, PixelPoint canvas, PixelPoint pixel) {
  return {float(view.centre_x + (pixel.x - canvas.x / 2) / view.pixels_per_cell),
          float(view.centre_y + (pixel.y - canvas.y / 2) / view.pixels_per_cell)};
}

PixelPoint pixel_of(const MapView& view, PixelPoint canvas, double cell_x, double cell_y) {
  return {(cell_x - view.centre_x) * view.pixels_per_cell + canvas.x / 2,
          (cell_y - view.centre_y) * view.pixels_per_cell + canvas.y / 2};
}

MapView zoomed(const MapView& view, PixelPoint canvas, PixelPoint pixel, double factor, double least, double most) {
  const double held_x = view.centre_x + (pixel.x - canvas.x / 2) / view.pixels_per_cell;
  const double held_y = view.centre_y + (pixel.y - canvas.y / 2) / view.pixels_per_cell;
  MapView next = view;
  next.pixels_per_cell = std::clamp(view.pixels_per_cell * factor, least, most);
  next.centre_x = held_x - (pixel.x - canvas.x / 2) / next.pixels_per_cell;
  next.centre_y = held_y - (pixel.y - canvas.y / 2) / next.pixels_per_cell;
  return next;
}

MapView panned(const MapView& view, PixelPoint moved) {
  MapView next = view;
  next.centre_x -= moved.x / view.pixels_per_cell;
  next.centre_y -= moved.y / view.pixels_per_cell;
  return next;
}

MapView fitted(const Rect& cells, PixelPoint canvas, double margin) {
  const double width = std::max(canvas.x - 2 * margin, 16.0);
  const double height = std::max(canvas.y - 2 * margin, 16.0);
  MapView view;
  view.centre_x = (cells.x0 + cells.x1 - 1) / 2.0;
  view.centre_y = (cells.y0 + cells.y1 - 1) / 2.0;
  view.pixels_per_cell = std::min(width / std::max(cells.width(), 1), height / std::max(cells.height(), 1));
  return view;
}

MapView kept_on_map(const MapView& view, int width, int height) {
  MapView next = view;
  next.centre_x = std::clamp(view.centre_x, -0.5, width - 0.5);
  next.centre_y = std::clamp(view.centre_y, -0.5, height - 0.5);
  return next;
}

std::vector<double> round_ticks(double low, double high, int most) {
  std::vector<double> ticks;
  if (!(high > low) || most < 1 || !std::isfinite(low) || !std::isfinite(high)) return ticks;
  const double rough = (high - low) / most;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  for (const double base : {1.0, 2.0, 2.5, 5.0, 10.0, 20.0}) {
    const double step = base * decade;
    const double first = std::ceil(low / step - 1e-9);
    const double last = std::floor(high / step + 1e-9);
    if (last - first + 1 > most) continue;
    for (double i = first; i <= last; ++i) ticks.push_back(i == 0 ? 0 : i * step);
    break;
  }
  return ticks;
}

ScaleBar scale_bar(double metres_per_pixel, double most_pixels) {
  const double longest = metres_per_pixel * most_pixels;
  if (!(longest > 0) || !std::isfinite(longest)) return {};
  const double decade = std::pow(10, std::floor(std::log10(longest)));
  double metres = decade;
  for (const double base : {2.0, 5.0}) {
    if (base * decade <= longest) metres = base * decade;
  }
  return {metres, metres / metres_per_pixel};
}

}  // namespace biotope
