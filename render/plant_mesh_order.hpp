#pragma once

#include <glm/glm.hpp>

#include "render/plant_mesh.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

/// A mesh's triangles are kept in several orders, each with the nearest first for an eye on one side of the plant: leaves hide
/// most of the leaves behind them, and what is hidden already need not be shaded.
inline constexpr int mesh_orders = 8;

/// The triangles of a mesh in all its orders, one after the other.
[[nodiscard]] std::vector<std::uint16_t> ordered_indices(const PlantMesh& mesh);

/// The order in which an eye sees a plant, 0 .. mesh_orders - 1.
[[nodiscard]] int mesh_order(const PlantInstance& plant, const glm::vec3& eye);

}  // namespace biotope
