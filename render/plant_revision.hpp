#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "render/ground_picture.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

/// Blocks of each stratum by (row, column).
using PlantBlockPlaces = std::array<std::vector<std::pair<int, int>>, strata>;

/// True when the plants of two snapshots' webs are the same species, which grow by the same rules.
[[nodiscard]] bool same_plants(const MapsSnapshot& a, const MapsSnapshot& b);

/// True when plants of one snapshot may stay where the other is shown: the same ground and seed, and plants that grow by the same
/// rules.
[[nodiscard]] bool plants_stay(const MapsSnapshot& before, const MapsSnapshot& now);

/// Where plants stand by a new snapshot, and which blocks that has changed.
struct PlantRevision {
  PlantPlacement placement;
  PlantBlockPlaces stale;
};

/// `lines` is the water and the trails that are drawn with the snapshot; null: plants keep away from the cells of water only. Of
/// the blocks in `places` those are stale on whose ground something is another than it was `before` (without maps: none are).
/// Parallel; may be called on any thread.
[[nodiscard]] PlantRevision plant_revision(const PlantGround& before, std::shared_ptr<const MapsSnapshot> now,
                                           const std::shared_ptr<const GroundLines>& lines, const PlantBlockPlaces& places);

}  // namespace biotope
