#pragma once

#include <memory>

#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// The landscape that the 3D view shows: ground, water and plants of the newest snapshot as soon as its plants are known, with
/// the animals, trails and plans of the last complete one until those of the edit are known too. `before` is what it showed; it
/// stays while nothing that is drawn is another. `complete` and `before` may be null.
[[nodiscard]] std::shared_ptr<const MapsSnapshot> pictured_maps(const std::shared_ptr<const MapsSnapshot>& newest,
                                                                const std::shared_ptr<const MapsSnapshot>& complete,
                                                                const std::shared_ptr<const MapsSnapshot>& before);

}  // namespace biotope
