#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/plant_mesh_builder.hpp"

namespace biotope {

/// Radius of a crown, 0..1, by height within it, 0 at its foot to 1 at its top.
struct CrownOutline {
  float widest = 0.45F;  ///< height of the widest part
  float pointed = 0;     ///< 0 round top .. 1 a cone's
  float flat = 0;        ///< 0 round below .. 1 cut off level
  [[nodiscard]] float radius(float height) const;
};

/// How a kind of tree branches. Lengths are shares of its height, angles radians from upright.
struct BranchingHabit {
  CrownOutline outline;
  int stems = 1;
  float lean = 0;  ///< of several stems at their foot
  float trunk_radius = 0.022F;
  float first = 0.25F;  ///< height of the lowest limb
  float leader = 0.8F;  ///< height the trunk is followed to
  int limbs = 10;       ///< of all stems together
  float low_angle = 1.3F;
  float high_angle = 0.4F;
  float rise = 0.35F;  ///< how far limbs bend up along their way; negative: down
  int shoots = 4;      ///< of a limb
  float shoot_angle = 0.85F;
  float shoot_length = 0.42F;  ///< of the limb
  float shoot_rise = 0.2F;
  int twigs = 2;  ///< of a shoot
  float wander = 0.08F;
};

/// A branch from its foot to its tip, with the thickness that carries all that grows on it.
struct Branch {
  std::vector<glm::vec3> points;
  std::vector<float> radii;
  int order = 0;  ///< 0 trunk, 1 limb, 2 shoot, 3 twig
};

/// A place where foliage grows.
struct LeafSpot {
  glm::vec3 at;
  glm::vec3 along;  ///< unit, the way its twig points
  int limb = 0;
  float length = 0;  ///< of its twig, m
};

struct Branching {
  int stems = 1;
  std::vector<Branch> branches;
  std::vector<LeafSpot> spots;
  /// By limb: the bunch of foliage that it carries.
  std::vector<CrownForm> bunches;
};

/// Grows a tree: limbs leave the trunk, shoots the limbs and twigs the shoots, each turned by 137.5 degrees against the one
/// before (Vogel 1979), as long as the crown's outline lets them be; a branch is as thick as all it carries together (pipe model,
/// Shinozaki et al. 1964).
[[nodiscard]] Branching grow_branches(const PlantShape& shape, const BranchingHabit& habit, MeshRandom& random);

/// Adds the branches as stems and strips: all of them near, trunk and limbs from afar.
void add_branches(PlantMeshBuilder& builder, const Branching& branching, PlantDetail detail);

}  // namespace biotope
