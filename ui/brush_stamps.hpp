#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/status.hpp"

namespace biotope {

/// A shape of dabs.
struct BrushStamp {
  std::string name;  ///< of a built-in one, or the image's file
  std::shared_ptr<const Grid<float>> weights;
};

/// Shapes that are always there: "Square", "Speckle", "Patches", "Streaks". Our own, made by arithmetic.
[[nodiscard]] const std::vector<BrushStamp>& built_in_stamps();
/// A built-in stamp by its name, or the image in a file.
[[nodiscard]] Result<BrushStamp> load_stamp(const std::string& name);
/// The name without folders and ending.
[[nodiscard]] std::string stamp_title(std::string_view name);

}  // namespace biotope
