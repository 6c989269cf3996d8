#include "ui/crop_selection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace biotope {
namespace {

constexpr int least_cells = 16;

/// Two places along an axis of the picture, as whole cells of the file in order.
std::pair<int, int> span(float a, float b, int picture, int file) {
  const auto cell = [&](float place) {
    const double share = std::clamp((double(place) + 0.5) / picture, 0.0, 1.0);
    return int(std::lround(share * file));
  };
  return {cell(std::min(a, b)), cell(std::max(a, b))};
}

}  // namespace

std::optional<Rect> cropped_cells(PathPoint from, PathPoint to, int picture_width, int picture_height, int file_width,
                                  int file_height) {
  if (picture_width < 1 || picture_height < 1) return std::nullopt;
  const auto [x0, x1] = span(from.x, to.x, picture_width, file_width);
  const auto [y0, y1] = span(from.y, to.y, picture_height, file_height);
  const Rect cells{x0, y0, x1, y1};
  if (cells.width() < least_cells || cells.height() < least_cells) return std::nullopt;
  return cells;
}

}  // namespace biotope
