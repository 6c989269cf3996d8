#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/document/brush_filter.hpp"
#include "core/document/edit.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// The map under a layer of paint, without that layer's own paint; null while the snapshot does not hold what it is made from, or
/// for a species or resource that does not exist. Resources: yearly mean, index 1..9 (texture: the year's one value); plants:
/// covered fraction; animals: individuals / km2, as competition made them; geology: class numbers; loss and passage: 0; ground:
/// the file's heights, m. O(cells).
[[nodiscard]] std::shared_ptr<const Grid<float>> computed_map(const MapsSnapshot& snapshot, const LayerId& layer);

/// What that map is made from: two snapshots with the same pointer have the same computed map. Null while it is not known.
[[nodiscard]] std::shared_ptr<const void> computed_map_source(const MapsSnapshot& snapshot, const LayerId& layer);

/// A map for one of the terrain's filter quantities (not FilterQuantity::map), of the ground with everything painted and drawn on
/// it; null while the snapshot does not hold what it is made from. Altitude shares the snapshot's heights.
[[nodiscard]] std::shared_ptr<const Grid<float>> filter_map(const MapsSnapshot& snapshot, FilterQuantity quantity);

/// The grounds of edits on a snapshot: computed maps are made at first use and kept as long as the EditGrounds or a copy lives;
/// they may be asked for by several threads. Filter maps are made at once: all that the snapshot can give, or only those that
/// `conditions` read.
[[nodiscard]] EditGrounds edit_grounds(std::shared_ptr<const MapsSnapshot> snapshot);
[[nodiscard]] EditGrounds edit_grounds(std::shared_ptr<const MapsSnapshot> snapshot, std::span<const FilterCondition> conditions);

/// The computed maps and conditions that an edit reads. Strokes and fills that set values or take paint off read none of the
/// layers they paint.
struct EditNeeds {
  std::vector<LayerId> computed;
  std::vector<FilterCondition> conditions;
  [[nodiscard]] bool empty() const { return computed.empty() && conditions.empty(); }
};
[[nodiscard]] EditNeeds needs_of(const Edit& edit);

/// The grounds of an edit with these needs: every computed map that is not among them is 0 everywhere, known or not, since it is
/// not read.
[[nodiscard]] EditGrounds edit_grounds(std::shared_ptr<const MapsSnapshot> snapshot, const EditNeeds& needs);

/// Whether a snapshot, which may be partial, holds everything an edit needs as far as it exists at all (a species the snapshot's
/// food web does not know never will).
[[nodiscard]] bool holds(const MapsSnapshot& snapshot, const EditNeeds& needs);

}  // namespace biotope
