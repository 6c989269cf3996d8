#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/rect.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "render/texel_pyramid.hpp"

namespace biotope {

/// Height of what one sees of the ground (m): carved by trails, raised to the surface of lakes and sea, a little sunk in rivers.
/// Of every `stride`-th cell. Parallel.
[[nodiscard]] Grid<float> visible_surface(const MapsSnapshot& snapshot, int stride = 1);

/// Farthest cell that a normal depends on.
inline constexpr int normal_reach = 10;
/// Normals of the cells of `rect` of a surface, as unsigned bytes (x east, y north, z up; 128 is 0) with the share of open sky in
/// the fourth.
[[nodiscard]] Grid<Rgba> surface_normals(const Grid<float>& surface, double cell_size, const Rect& rect);

/// Which species to show; empty shows all.
using SpeciesVisibility = std::vector<bool>;

/// Two pictures of a piece of ground from above, colours as the square root of linear light.
struct GroundColours {
  /// Bare earth, rock, herbs and the floor under trees; alpha: share of bare rock.
  Grid<Rgba> ground;
  /// Mean colour of the crowns of trees and shrubs; alpha: share of ground they cover.
  Grid<Rgba> canopy;
};

/// Colours of the texels of `rect` in a month (0 is January), a texel for every `stride` cells. Parts of the snapshot that are
/// null are left out.
[[nodiscard]] GroundColours colour_ground(const MapsSnapshot& snapshot, int month, const SpeciesVisibility& visible, int stride,
                                          const Rect& rect);

/// Leaf colour of a plant in a month of the northern hemisphere (northern_month), linear, between what it is before leaves turn
/// and after; `turn` (0..1) tells how many have, `bare` (0..1) how many have fallen.
struct SeasonalFoliage {
  std::array<float, 3> colour{};
  std::array<float, 3> fresh{};
  std::array<float, 3> turned{};
  float turn = 0;
  float bare = 0;
};
[[nodiscard]] SeasonalFoliage seasonal_foliage(const PlantTraits& plant, int month);

/// Colour of a meadow of herbs with such leaves, linear: leaves, dry stalks and the earth between them, duller than one leaf.
[[nodiscard]] std::array<float, 3> meadow_colour(const std::array<float, 3>& leaf);

/// An sRGB colour as linear light.
[[nodiscard]] std::array<float, 3> linear_colour(const std::array<float, 3>& srgb);

}  // namespace biotope
