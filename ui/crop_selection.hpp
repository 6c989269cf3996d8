#pragma once

#include <optional>

#include "core/base/rect.hpp"
#include "ui/view_transform.hpp"

namespace biotope {

/// Cells of a file of `file_width` x `file_height` that a rectangle drawn over its picture takes: `from` and `to` in cells of the
/// picture, which has `picture_width` x `picture_height`. Nothing when less than 16 cells a side are left.
[[nodiscard]] std::optional<Rect> cropped_cells(PathPoint from, PathPoint to, int picture_width, int picture_height, int file_width,
                                                int file_height);

}  // namespace biotope
