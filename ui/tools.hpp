#pragma once

#include <cstdint>

#include "core/document/brush.hpp"

namespace biotope {

/// What the left button does.
enum class Tool : std::uint8_t {
  select,  ///< asks why, moves the map
  add,
  erase,
  smooth,
  restore,
  set,
  sharpen,
  noise,
  clone,
  raise,  ///< the ground
  lower,
  flatten,  ///< sets the ground to the height where the stroke began
  carve,    ///< cuts a trench of one depth into the ground
  fill,
  gradient,
  select_rectangle,
  select_lasso
};

/// Tools that paint stroke by stroke.
[[nodiscard]] constexpr bool is_brush(Tool tool) { return tool >= Tool::add && tool <= Tool::carve; }
/// Tools that change layers: brushes, fill and gradient.
[[nodiscard]] constexpr bool is_painting(Tool tool) { return tool >= Tool::add && tool <= Tool::gradient; }
/// Tools that only ever work on the ground.
[[nodiscard]] constexpr bool is_ground_tool(Tool tool) { return tool >= Tool::raise && tool <= Tool::carve; }
[[nodiscard]] constexpr bool is_selecting(Tool tool) { return tool == Tool::select_rectangle || tool == Tool::select_lasso; }

}  // namespace biotope
