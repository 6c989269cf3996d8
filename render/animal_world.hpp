#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "core/movement/herd_simulation.hpp"
#include "core/pipeline/maps_snapshot.hpp"

namespace biotope {

/// What individual animals need of a snapshot; `details` (may be null) is what is drawn finer than its cells. Null while the
/// snapshot has no plans.
[[nodiscard]] std::shared_ptr<const HerdWorld> herd_world(const MapsSnapshot& maps, std::shared_ptr<const HerdDetails> details);

/// Height of the ground as it is drawn at a place (metres), by its surface grid.
[[nodiscard]] float surface_height(const Grid<float>& surface, const Terrain& terrain, glm::dvec2 place);
/// Height that feet stand at: the ground that is drawn, or the bed of the lake whose surface is drawn.
[[nodiscard]] float standing_height(const Grid<float>& surface, const Terrain& terrain, glm::dvec2 place);

}  // namespace biotope
