#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/plant_mesh_builder.hpp"

namespace biotope {

namespace {

/// A crown that stands on the ground.
CrownForm low_crown(const PlantShape& shape) {
  const float radius = 0.5F * shape.crown_diameter;
  return {{0, 0, 0.42F * shape.height}, {radius, radius, 0.58F * shape.height}};
}

}  // namespace

PlantMesh mountain_pine_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  const float radius = 0.5F * shape.crown_diameter;
  PlantMeshBuilder builder(low_crown(shape), seed);
  // Many bowed stems from one foot, each with an upright tuft of needles.
  const int stems = near ? 12 : 5;
  for (int i = 0; i < stems; ++i) {
    const float t = std::sqrt((float(i) + 0.5F) / float(stems));
    const float turn = glm::radians(137.5F) * float(i);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float rise = shape.height * (0.86F - 0.5F * t * t) * builder.random.between(0.85F, 1.1F);
    const glm::vec3 elbow = out * radius * 0.45F * t + glm::vec3(0, 0, 0.22F * rise);
    const glm::vec3 tip = out * radius * 0.78F * t + glm::vec3(0, 0, 0.72F * rise);
    if (near) {
      builder.stem({0, 0, -0.1F}, elbow, 0.018F * shape.height, 0.014F * shape.height, 3);
      builder.stem(elbow, tip, 0.014F * shape.height, 0.006F * shape.height, 3);
    }
    const float size = (near ? 0.34F : 0.52F) * radius * builder.random.between(0.9F, 1.15F);
    builder.lobe({tip, {size, size, size * 1.25F}}, near ? 11 : 6, size * 1.55F, LeafPicture::needles, 0.7F);
  }
  // Boughs that lie on the ground around it.
  builder.lobe({{0, 0, 0.2F * shape.height}, {radius * 0.85F, radius * 0.85F, 0.22F * shape.height}}, near ? 18 : 7,
               0.5F * radius, LeafPicture::needles, 0.6F);
  return builder.take();
}

PlantMesh juniper_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  const float radius = 0.5F * shape.crown_diameter;
  const CrownForm crown{{0, 0, 0.45F * shape.height}, {radius, radius, 0.55F * shape.height}};
  PlantMeshBuilder builder(crown, seed);
  builder.stem({0, 0, -0.1F}, {0, 0, 0.4F * shape.height}, 0.035F * shape.height, 0.02F * shape.height, near ? 5 : 3);
  // Upright flames of scale leaves around the axis: widest at a third, to a point.
  const int rings = near ? 9 : 4;
  for (int ring = 0; ring < rings; ++ring) {
    const float t = (float(ring) + 0.3F) / float(rings);
    const float reach = radius * std::pow(std::sin(glm::pi<float>() * (0.16F + 0.84F * t)), 0.8F);
    const int flames = near ? 10 : 6;
    for (int i = 0; i < flames; ++i) {
      const float turn = glm::two_pi<float>() * (float(i) + builder.random.unit() * 0.7F) / float(flames) + 2.4F * float(ring);
      const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
      const float size = shape.height * (near ? 0.24F : 0.42F) * builder.random.between(0.85F, 1.15F);
      const glm::vec3 facing = glm::normalize(out + builder.random.direction() * 0.5F);
      builder.card({out * reach * builder.random.between(0.5F, 0.8F) + glm::vec3(0, 0, shape.height * t * 0.92F + 0.3F * size),
                    facing, glm::normalize(glm::vec3(0, 0, 1) + out * 0.25F), size * 0.62F, size, LeafPicture::bough});
    }
  }
  return builder.take();
}

PlantMesh shrub_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  const float radius = 0.5F * shape.crown_diameter;
  PlantMeshBuilder builder(low_crown(shape), seed);
  const int lobes = near ? 8 : 4;
  for (int i = 0; i < lobes; ++i) {
    const float t = std::sqrt((float(i) + 0.3F) / float(lobes));
    const float turn = glm::radians(137.5F) * float(i);
    const float size = (near ? 0.40F : 0.58F) * radius * builder.random.between(0.8F, 1.2F);
    const float height = shape.height * (0.66F - 0.34F * t * t) * builder.random.between(0.85F, 1.15F);
    const glm::vec3 tip(std::cos(turn) * radius * 0.62F * t, std::sin(turn) * radius * 0.62F * t, height);
    if (near) builder.stem({0, 0, -0.05F}, tip, 0.02F * shape.height, 0.008F * shape.height, 3);
    builder.lobe({tip, {size, size, size * 0.8F * shape.height / shape.crown_diameter + 0.2F * size}}, near ? 13 : 7,
                 size * (near ? 1.15F : 1.4F), LeafPicture::small, 0.8F);
  }
  // Foliage down to the ground.
  builder.lobe({{0, 0, 0.24F * shape.height}, {radius * 0.82F, radius * 0.82F, 0.26F * shape.height}}, near ? 16 : 7,
               0.58F * radius, LeafPicture::small, 0.6F);
  return builder.take();
}

PlantMesh tuft_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  const float radius = 0.5F * shape.crown_diameter;
  // Its middle lies below the ground, so that a tuft is lit as the meadow around it is.
  PlantMeshBuilder builder({{0, 0, -0.9F * shape.height}, {2 * radius, 2 * radius, 1.7F * shape.height}}, seed);
  const bool grass = shape.model == "grass";
  const bool flower = shape.model == "flower";
  const LeafPicture leaves = grass ? LeafPicture::blades : LeafPicture::rosette;
  const int cards = near ? 3 : 2;
  const float leaf_height = flower ? 0.55F * shape.height : shape.height;
  for (int i = 0; i < cards; ++i) {
    const float turn = glm::pi<float>() * (float(i) + builder.random.between(-0.15F, 0.15F)) / float(cards);
    const glm::vec3 facing(std::cos(turn), std::sin(turn), 0.1F);
    builder.card(
        {{0, 0, 0.48F * leaf_height}, glm::normalize(facing), {0, 0, 1}, shape.crown_diameter * 1.5F, leaf_height, leaves});
  }
  if (!flower) return builder.take();
  for (int i = 0; i < (near ? 2 : 1); ++i) {
    const float turn = glm::half_pi<float>() * float(i) + 0.4F;
    builder.card({{0, 0, 0.5F * shape.height},
                  {std::cos(turn), std::sin(turn), 0},
                  {0, 0, 1},
                  shape.crown_diameter * 1.3F,
                  shape.height,
                  LeafPicture::flower});
  }
  return builder.take();
}

}  // namespace biotope
