#pragma once

#include <cstdint>
#include <memory>

#include "core/base/grid.hpp"
#include "core/movement/trails.hpp"
#include "core/terrain/hydrology.hpp"
#include "core/terrain/terrain.hpp"
#include "render/ford_look.hpp"

namespace biotope {

/// Water and trails on a grid finer than the terrain, so that a brook or a trail narrower than a cell keeps its width and reads
/// as one line from any height.
struct LineField {
  /// Fine cells per terrain cell.
  int scale = 1;
  /// Metres to the nearest shore, positive in water, coded 128 + 15.875 m and clamped to +-8 m (shore_reach).
  Grid<std::uint8_t> shore;
  /// Worn earth 0..255.
  Grid<std::uint8_t> wear;
};

/// Farthest distance to a shore that a LineField tells, m.
inline constexpr float shore_reach = 8;
[[nodiscard]] inline float shore_distance(std::uint8_t code) { return (float(code) - 128.0F) * (shore_reach / 127.0F); }

/// Fine cells per terrain cell so that no side is longer than `longest` cells.
[[nodiscard]] int line_field_scale(int width, int height, int longest = 4096);

/// Where water is drawn: the codes of a LineField's shore on a grid `scale` times as fine as the terrain.
struct ShoreMap {
  int scale = 1;
  Grid<std::uint8_t> codes;
};

/// Distance to the shore of lakes and sea (from their cells) and of rivers (from their reaches, smoothed, with the width of their
/// discharge, wider at fords).
[[nodiscard]] Grid<std::uint8_t> shore_field(const Terrain& terrain, const Hydrology& hydrology, int scale,
                                             const FordLook& fords = {});
/// Along the edges of a trail its earth gives way to what grows over this width, m: no less than a fine cell can show.
[[nodiscard]] float soft_edge(const Terrain& terrain, int scale);
/// Worn earth along the routes of a network: 0.5 m wide where little used, up to 2 m (TrailLines tells the same exactly).
[[nodiscard]] Grid<std::uint8_t> wear_field(const Terrain& terrain, const TrailNetwork& trails, int scale);

}  // namespace biotope
