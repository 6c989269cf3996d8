#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/species/species.hpp"

namespace biotope {

/// A vertex of an animal that stands at the origin, x forward, y to its left, z up, metres.
struct AnimalVertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec3 colour;
  /// What moves it: x: 1 for a leg, 2 for neck and head, 0 for the trunk; y: a leg's phase 0..1; z, w: the joint it turns about (x, z).
  glm::vec4 rig;
};

struct AnimalMesh {
  std::vector<AnimalVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// How much of an animal is drawn: all of it, all with fewer corners, or only its silhouette (no ears, tail and headgear).
enum class AnimalDetail : std::uint8_t { fine, plain, silhouette };

/// A quadruped of a shape's size, colours and headgear: about 600, 330 or 90 triangles.
[[nodiscard]] AnimalMesh make_animal_mesh(const AnimalShape& shape, AnimalDetail detail);

}  // namespace biotope
