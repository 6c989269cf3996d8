#pragma once

#include <array>

#include "render/plant_mesh.hpp"

namespace biotope {

/// What lies and grows on the floor of a wood beside the plants of the maps: details for the eye, without food value, that no
/// map counts (Ecormier-Nocca 2021, section 6.2, instantiates what the maps hold; this layer is our choice).
enum class Undergrowth : std::uint8_t { fern, shade_herb, sapling, fallen_branch, log, stone };
inline constexpr int undergrowth_kinds = 6;

/// How one of them looks.
struct UndergrowthLook {
  PlantTraits traits;  ///< shape and colours through the year
  std::array<float, 3> wood{0.42F, 0.37F, 0.31F};
};
[[nodiscard]] UndergrowthLook undergrowth_look(Undergrowth kind);
[[nodiscard]] PlantMesh undergrowth_mesh(Undergrowth kind, std::uint64_t seed);

/// What the maps say of a place, as far as its undergrowth follows from it.
struct ForestFloor {
  float canopy = 0;     ///< share of the ground under crowns of trees
  float evergreen = 0;  ///< share of these that keep their leaves
  float herbs = 0;      ///< share of the ground under herbs
  float moisture = 5;   ///< 1..9
  float slope = 0;      ///< rise / run
};
/// Expected number per square metre of each kind.
[[nodiscard]] std::array<float, undergrowth_kinds> undergrowth_density(const ForestFloor& floor);

}  // namespace biotope
