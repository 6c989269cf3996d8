#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/species/species.hpp"

namespace biotope {

/// Pictures of foliage that cards show, numbered as layers of leaf_pictures().
/// The plant shaders know the numbers of `flower`, `flower_head` and `twigs`.
enum class LeafPicture : std::uint8_t {
  bark,
  broad,
  small,
  needles,
  bough,
  blades,
  rosette,
  flower,
  twigs,
  airy,
  flower_head,
  pale_bark,
  smooth_bark,
  plated_bark,
  oak_spray,
  oval_spray,
  round_spray,
  birch_spray,
  leathery_spray,
  pine_spray,
  scale_spray,
  frond,
  shade_leaves,
  stone
};
inline constexpr int leaf_picture_count = 24;
/// Pictures without holes.
[[nodiscard]] constexpr bool is_solid(LeafPicture picture) {
  return picture == LeafPicture::bark || picture == LeafPicture::pale_bark || picture == LeafPicture::smooth_bark ||
         picture == LeafPicture::plated_bark || picture == LeafPicture::stone;
}

/// The part of a foliage picture that is not empty, 0..1: cards are as large as that and no larger, for the holes of a card cost
/// as much as its leaves. Bare twigs share the cards of leaves.
struct CardBox {
  glm::vec2 low{0};
  glm::vec2 high{1};
};
[[nodiscard]] CardBox card_box(LeafPicture picture);

/// What the plant shaders read per vertex.
struct PlantVertex {
  glm::vec3 position;  ///< m, the foot of the stem at the origin, z up
  glm::vec3 normal;    ///< soft: that of the crown more than that of the leaf
  glm::vec2 uv;
  float picture;  ///< layer of leaf_pictures()
  float open;     ///< baked shade: 1 in the open, 0 deep inside the crown
  float fall;     ///< 0..1: the card shows bare twigs once more than this share of the leaves has fallen; 2 for wood, which stays
  float leaf;     ///< 0 wood, 1 foliage
};

struct PlantMesh {
  std::vector<PlantVertex> vertices;
  std::vector<std::uint16_t> indices;
  [[nodiscard]] std::size_t triangles() const { return indices.size() / 3; }
};

/// How many triangles a mesh may have: close 1500..9000, near 280..2200, mid 35..175; a tuft of herbs near 70, from afar 8.
enum class PlantDetail : std::uint8_t { close, near, mid };

/// The mesh of a grown plant of that shape, in metres. `seed` varies it. Unknown models are drawn as their nearest kin (broadleaf
/// above 3 m, else herb).
[[nodiscard]] PlantMesh make_plant_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed);

/// Radius around the stem's axis and height that hold the whole mesh, m.
struct PlantExtent {
  float radius = 0;
  float height = 0;
};
[[nodiscard]] PlantExtent extent_of(const PlantMesh& mesh);

}  // namespace biotope
