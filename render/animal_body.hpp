#pragma once

#include "render/animal_mesh_builder.hpp"

namespace biotope {

/// An animal's measures in metres and its colours.
struct AnimalFrame {
  AnimalBuild build;
  float height = 1;   ///< at the withers, m
  float stretch = 1;  ///< of lengths along the trunk
  glm::vec3 coat{0.5F};
  glm::vec3 belly{0.6F};
  glm::vec3 dark{0.1F};
  glm::vec3 pale{0.8F};
  /// Head: where it joins the neck, forward along its nose, and up from it.
  glm::vec3 poll{0};
  glm::vec3 forward{1, 0, 0};
  glm::vec3 up{0, 0, 1};

  /// A point given in shoulder heights.
  [[nodiscard]] glm::vec3 at(float x, float y, float z) const { return glm::vec3(x * stretch, y, z) * height; }
  /// A point of the head, in shoulder heights along its nose, to the left, and up.
  [[nodiscard]] glm::vec3 on_head(float ahead, float left, float above) const {
    return poll + (forward * ahead + glm::vec3(0, left, 0) + up * above) * height;
  }
};

[[nodiscard]] AnimalFrame animal_frame(const AnimalShape& shape, const AnimalBuild& build);

/// Trunk, neck and head in one skin; what hangs on them; legs; tail, ears and eyes; of a silhouette a long tail; horns and
/// antlers.
void add_body(AnimalMeshBuilder& builder, const AnimalFrame& frame);
void add_legs(AnimalMeshBuilder& builder, const AnimalFrame& frame, const AnimalSkeleton& skeleton);
void add_details(AnimalMeshBuilder& builder, const AnimalFrame& frame, const AnimalSkeleton& skeleton);
void add_far_details(AnimalMeshBuilder& builder, const AnimalFrame& frame, const AnimalSkeleton& skeleton);
void add_headgear(AnimalMeshBuilder& builder, const AnimalFrame& frame);

}  // namespace biotope
