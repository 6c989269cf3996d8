#pragma once

#include "core/document/document.hpp"

namespace biotope {

/// The document on a grid whose longer side has `longer_side` cells: terrain, inflows, paint and given maps resampled alike.
[[nodiscard]] Document resampled_document(const Document& document, int longer_side);

/// The document with cells of `cell_size` metres; what its georeference said no longer holds and is dropped.
[[nodiscard]] Document with_cell_size(const Document& document, double cell_size);

}  // namespace biotope
