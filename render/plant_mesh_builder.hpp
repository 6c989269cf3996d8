#pragma once

#include <span>

#include "render/plant_mesh.hpp"

namespace biotope {

/// Random numbers of one mesh, drawn in the order in which it is built.
class MeshRandom {
 public:
  explicit MeshRandom(std::uint64_t seed) : seed_(seed) {}
  [[nodiscard]] float unit();
  [[nodiscard]] float between(float low, float high) { return low + (high - low) * unit(); }
  /// A direction, uniform over the sphere.
  [[nodiscard]] glm::vec3 direction();

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

/// Any unit vector perpendicular to a unit vector.
[[nodiscard]] glm::vec3 perpendicular(const glm::vec3& v);

/// A card of foliage: a square that carries a leaf picture.
struct FoliageCard {
  glm::vec3 centre;
  glm::vec3 facing;   ///< unit normal of the card
  glm::vec3 upright;  ///< direction of the picture's top, need not be perpendicular
  float width = 1;
  float height = 1;
  LeafPicture picture = LeafPicture::broad;
  float fold = 0;  ///< depth of the fold along its middle / width: a folded card is never seen from its edge alone
};

/// A crown or a bunch of foliage in it: where it is dark, and which way its outside faces.
struct CrownForm {
  glm::vec3 centre{0};
  glm::vec3 radii{1};
};

/// Adds stems and cards to a mesh and bakes their shading.
class PlantMeshBuilder {
 public:
  PlantMeshBuilder(const CrownForm& crown, std::uint64_t seed) : random(seed), crown_(crown) {}

  /// A stem of `sides` faces along points, open at both ends.
  void stem(std::span<const glm::vec3> points, std::span<const float> radii, int sides);
  void stem(const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to, int sides);
  /// A trunk whose foot spreads into `roots` roots: along points, the first below the ground.
  void trunk(std::span<const glm::vec3> points, std::span<const float> radii, int sides, int roots);
  /// A thin branch: a flat strip that faces `facing`.
  void strip(std::span<const glm::vec3> points, std::span<const float> radii, const glm::vec3& facing);
  /// A card shaded as a part of the crown and of a bunch of foliage in it (null: of the crown alone).
  void card(const FoliageCard& card, const CrownForm* bunch = nullptr);
  /// Cards over the outside of an ellipsoid, facing outwards more or less: a bunch of foliage. `roughness` 0..1 turns them at
  /// random.
  void bunch(const CrownForm& form, int cards, float size, LeafPicture picture, float roughness, float fold = 0);
  /// A blade or leaf of a herb that bends at its knee: dark at the root, light at the tip. `shade` 0..1.
  void blade(const glm::vec3& foot, const glm::vec3& knee, const glm::vec3& tip, float width, float shade);
  /// A stone that lies half in the ground, of `around` x `rings` faces, shown with the bark's picture.
  void boulder(const glm::vec3& radii, int around, int rings);
  void set_bark(LeafPicture bark) { bark_ = bark; }
  [[nodiscard]] PlantMesh take() { return std::move(mesh_); }

  MeshRandom random;

 private:
  [[nodiscard]] glm::vec3 soft_normal(const glm::vec3& at, const glm::vec3& facing, const CrownForm* bunch) const;
  [[nodiscard]] float openness(const glm::vec3& at, const CrownForm* bunch) const;
  [[nodiscard]] float shade_of_wood(const glm::vec3& at) const;
  void triangle(std::size_t a, std::size_t b, std::size_t c);
  /// Radius of a stem at a point in a direction around it.
  template <class Radius>
  void tube(std::span<const glm::vec3> points, int sides, float around, const Radius& radius);

  CrownForm crown_;
  LeafPicture bark_ = LeafPicture::bark;
  PlantMesh mesh_;
};

/// Models, by family.
[[nodiscard]] PlantMesh broadleaf_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);
[[nodiscard]] PlantMesh pine_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);
[[nodiscard]] PlantMesh spruce_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);
[[nodiscard]] PlantMesh mountain_pine_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);
[[nodiscard]] PlantMesh juniper_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);
[[nodiscard]] PlantMesh shrub_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);
[[nodiscard]] PlantMesh tuft_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);

}  // namespace biotope
