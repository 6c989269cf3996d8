#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/species/species.hpp"
#include "render/animal_proportions.hpp"

namespace biotope {

/// A vertex of an animal that stands at the origin, x forward, y to its left, z up, metres.
struct AnimalVertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec3 colour;
  /// What moves it. x: 0 trunk, neck and head, 1..4 a leg (left hind, left fore, right hind, right fore), 5 tail, 6 ear, 7
  /// headgear. y: how much the neck's turn moves it, 0..1; of legs 0 at the hip, 1 at the shank, 2 at the hoof. z: how much the
  /// head's turn moves it; of the tail its distance from the root, 0..1. w: the side (-1, 1) of ears.
  glm::vec4 rig;
};

struct AnimalMesh {
  std::vector<AnimalVertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// How much of an animal is drawn: all of it, all with fewer corners, or only its silhouette.
enum class AnimalDetail : std::uint8_t { fine, plain, silhouette };

/// Joints of a leg of a standing animal, m.
struct AnimalLeg {
  glm::vec3 hip{0};
  glm::vec3 knee{0};  ///< knee (carpus) of forelegs, hock of hind legs
  glm::vec3 foot{0};  ///< on the ground
};

/// What the shader turns an animal about, m and radians, at the size of the species.
struct AnimalSkeleton {
  /// Left hind, left fore, right hind, right fore.
  std::array<AnimalLeg, 4> legs;
  glm::vec3 neck{0};  ///< where the neck leaves the trunk
  glm::vec3 head{0};  ///< where the head joins the neck
  glm::vec3 muzzle{0};
  glm::vec3 tail{0};
  /// Turns that bring the muzzle to flat ground: of the neck and of the head beyond it (down is negative), and the trunk's own.
  float graze_neck = 0;
  float graze_head = 0;
  float graze_pitch = 0;
  float lie_drop = 0;    ///< how far the trunk sinks when the animal lies
  float hip_height = 0;  ///< mean of the legs
};

/// Joints of a shape's build.
[[nodiscard]] AnimalSkeleton animal_skeleton(const AnimalShape& shape, const AnimalBuild& build);
/// Where the muzzle is when neck, head and trunk are turned by a share of the skeleton's grazing turns.
[[nodiscard]] glm::vec3 grazing_muzzle(const AnimalSkeleton& skeleton, float share);

/// A quadruped of a shape's size and colours: about 1,300, 450 or 90 triangles. The scientific name chooses the build
/// (animal_build).
[[nodiscard]] AnimalMesh make_animal_mesh(const AnimalShape& shape, std::string_view scientific_name, AnimalDetail detail);

}  // namespace biotope
