#pragma once

#include "core/document/document.hpp"

namespace biotope {

/// The document on a grid whose longer side has `longer_side` cells: terrain, inflows, paint, selection, placements and given
/// maps resampled alike; classes of geology by the nearest cell.
[[nodiscard]] Document resampled_document(const Document& document, int longer_side);

/// The document with cells of `cell_size` metres; what its georeference said no longer holds and is dropped. Placed things
/// cover the same cells as before, and rivers bring as much more water as their catchments have grown.
[[nodiscard]] Document with_cell_size(const Document& document, double cell_size);

}  // namespace biotope
