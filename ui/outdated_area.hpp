#pragma once

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// Cells whose maps a snapshot does not answer yet: around the tiles whose paint differs, all of them when anything else does or
/// nothing has been computed. Empty when the snapshot is complete and of this document.
[[nodiscard]] Rect outdated_area(const Document& document, const MapsSnapshot& snapshot);

}  // namespace biotope
