#pragma once

#include <vector>

#include "render/ground_maps.hpp"
#include "render/plant_mesh.hpp"

namespace biotope {

inline constexpr int leaf_picture_side = 256;

/// Pictures of foliage drawn by rule, one per LeafPicture. Red: shade (128 is the leaf's own colour); green: share of flower
/// colour, of leaves on trees how far each has yellowed; blue: share of wood; alpha: coverage. Row 0 is the foot of the card.
[[nodiscard]] std::vector<Grid<Rgba>> leaf_pictures();

/// A picture and its mipmaps down to 4 texels. Colours are those of what is covered, so that nothing bleeds in from the holes,
/// and the share of texels that pass an alpha test at one half stays what it is in the picture: foliage does not thin out from
/// afar. Bare twigs are drawn anew in each size.
[[nodiscard]] std::vector<Grid<Rgba>> leaf_mipmaps(LeafPicture which, const Grid<Rgba>& picture);

}  // namespace biotope
