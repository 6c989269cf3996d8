#pragma once

#include <vector>

#include "render/ground_maps.hpp"
#include "render/plant_mesh.hpp"

namespace biotope {

inline constexpr int leaf_picture_side = 128;

/// Pictures of foliage drawn by rule, one per LeafPicture. Red: shade (128 is the leaf's own colour); green: share of flower
/// colour; blue: share of wood; alpha: coverage. Row 0 is the foot of the card.
[[nodiscard]] std::vector<Grid<Rgba>> leaf_pictures();

}  // namespace biotope
