#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

/// A plant that a ray hits.
struct PickedPlant {
  int species = -1;  ///< number in the food web
  glm::dvec3 foot{0};
  double away = 0;  ///< m along the ray
};

/// Trees and shrubs that stand around a place, to look for a free sight between them.
class PlantsAround {
 public:
  /// Those within about `reach` metres.
  PlantsAround(const PlantPlacement& placement, const glm::dvec3& place, double reach,
               const std::vector<bool>& visible_species = {});
  /// Whether none of them stands between two points, nor around the first.
  [[nodiscard]] bool free(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  struct Obstacle {
    glm::dvec3 foot;
    double height;
    double crown_radius;
    double bare;  ///< m of trunk under the crown
  };
  std::vector<Obstacle> plants_;
};

/// The tree or shrub that a ray hits first within `reach` metres: its crown and its trunk, as they are placed. Plants of species
/// that are hidden count for nothing. Meant for a click: it places the plants along the ray, which takes a few milliseconds.
[[nodiscard]] std::optional<PickedPlant> pick_plant(const PlantPlacement& placement, const glm::dvec3& origin,
                                                    const glm::vec3& direction, double reach,
                                                    const std::vector<bool>& visible_species = {});
/// The herb nearest to a place on the ground, within half a metre.
[[nodiscard]] std::optional<PickedPlant> herb_at(const PlantPlacement& placement, const glm::dvec3& place,
                                                 const std::vector<bool>& visible_species = {});

}  // namespace biotope
