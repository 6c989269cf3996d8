#pragma once

#include "core/base/grid.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"
#include "render/ford_look.hpp"
#include "render/texel_pyramid.hpp"

namespace biotope {

/// Speed that full red or green stands for (m/s) and depth that full blue stands for (m): as in shaders/landscape/water.glsl.
inline constexpr float fastest_flow = 3;
inline constexpr float deepest_water = 6;

/// Mean speed of a stream of `depth` m on a bed that falls by `slope` (Manning's formula with n = 0.045, natural channels with
/// stones and weeds: Chow 1959), m/s, at most fastest_flow.
[[nodiscard]] float stream_speed(float depth, float slope);

/// How water moves, a texel for every `stride` cells: red and green its speed to the east and north (128 stands, 1 and 255 are
/// fastest_flow), blue its depth, alpha how rough its bed makes it (0 smooth .. 255 white). Rivers flow along their reaches, in a
/// band a little wider than they are; at fords they are shallow and rough; lakes and sea stand.
[[nodiscard]] Grid<Rgba> water_flow(const Terrain& terrain, const Hydrology& hydrology, int stride, const FordLook& fords = {});

}  // namespace biotope
