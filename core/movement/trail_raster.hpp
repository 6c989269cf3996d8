#pragma once

#include <cassert>
#include <span>

#include "core/movement/trails.hpp"

namespace biotope {

/// Worn share of a trail's ground by the weight (kg x trips per year) that walks on it: sqrt(weight / 3e6), at most 1. Our choice: absolute, so that a
/// change in one corner does not rescale another.
[[nodiscard]] float trail_intensity(float weight);
/// Width of a trail by its weight, m: 0.5 to 2.5. Our choice.
[[nodiscard]] float trail_width(float weight);

/// Draws the routes into `network.wear` and `network.carving`, the share of a cell that each covers; nothing where water is
/// deeper than `wade_depth` of the route.
void draw_trails(const Ground& ground, std::span<const float> wade_depth, TrailNetwork& network);

}  // namespace biotope
