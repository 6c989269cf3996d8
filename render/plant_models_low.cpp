#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/plant_branches.hpp"

namespace biotope {

PlantMesh shrub_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  const bool close = detail == PlantDetail::close;
  const float radius = 0.5F * shape.crown_diameter;
  const CrownForm crown{{0, 0, 0.38F * shape.height}, {radius, radius, 0.62F * shape.height}};
  PlantMeshBuilder builder(crown, seed);
  // Stems from one foot, each with a bunch of small leaves, over foliage that comes down to the ground.
  const int stems = near ? 11 : 5;
  for (int i = 0; i < stems; ++i) {
    const float t = std::sqrt((float(i) + 0.3F) / float(stems));
    const float turn = glm::radians(137.5F) * float(i);
    const float size = (near ? 0.36F : 0.52F) * radius * builder.random.between(0.75F, 1.25F);
    const float height =
        shape.height * (near ? 0.78F - 0.42F * t * t : 0.68F - 0.36F * t * t) * builder.random.between(0.8F, 1.12F);
    const glm::vec3 tip(std::cos(turn) * radius * (near ? 0.66F : 0.54F) * t,
                        std::sin(turn) * radius * (near ? 0.66F : 0.54F) * t, height);
    if (near) {
      const std::array<glm::vec3, 3> points{glm::vec3(0, 0, -0.05F), tip * glm::vec3(0.45F, 0.45F, 0.5F), tip};
      const std::array<float, 3> radii{0.018F * shape.height, 0.013F * shape.height, 0.006F * shape.height};
      builder.strip(points, radii, glm::normalize(builder.random.direction() + glm::vec3(0, 0, 0.3F)));
    }
    const CrownForm bunch{tip, {size, size, size * (0.55F + 0.4F * shape.height / shape.crown_diameter)}};
    if (close) {
      builder.bunch(bunch, 42, size * 0.62F, LeafPicture::leathery_spray, 0.9F, 0.16F);
    } else {
      builder.bunch(bunch, near ? 12 : 6, size * (near ? 1.15F : 1.45F), LeafPicture::small, 0.8F);
    }
  }
  const CrownForm skirt{{0, 0, 0.2F * shape.height},
                        glm::vec3(radius, radius, shape.height) * glm::vec3(near ? 0.85F : 0.7F, near ? 0.85F : 0.7F, 0.24F)};
  if (close) {
    builder.bunch(skirt, 90, 0.25F * radius, LeafPicture::leathery_spray, 0.8F, 0.16F);
    return builder.take();
  }
  builder.bunch(skirt, near ? 22 : 8, (near ? 0.46F : 0.62F) * radius, LeafPicture::small, 0.6F);
  return builder.take();
}

namespace {

/// Curved blades in a tuft: grass.
void grass_blades(PlantMeshBuilder& builder, const PlantShape& shape, int count) {
  for (int i = 0; i < count; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + builder.random.between(-0.5F, 0.5F);
    const float away = 0.5F * shape.crown_diameter * std::sqrt((float(i) + 0.5F) / float(count)) * 1.1F;
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float height = shape.height * builder.random.between(0.45F, 1.05F);
    const float lean = height * builder.random.between(0.1F, 0.55F);
    const glm::vec3 foot = out * away * 0.8F;
    const glm::vec3 bend = glm::normalize(out + builder.random.direction() * glm::vec3(0.8F, 0.8F, 0));
    const glm::vec3 knee = foot + bend * lean * 0.3F + glm::vec3(0, 0, height * 0.6F);
    const glm::vec3 tip = foot + bend * lean + glm::vec3(0, 0, height);
    builder.blade(foot, knee, tip, builder.random.between(0.008F, 0.015F), builder.random.between(0.7F, 1.0F));
  }
}

/// Broad leaves that spread from the ground: plantains, wormwood and their like.
void spreading_leaves(PlantMeshBuilder& builder, const PlantShape& shape, int count, float height) {
  for (int i = 0; i < count; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + builder.random.between(-0.3F, 0.3F);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float t = (float(i) + 0.5F) / float(count);
    // The outer ones lie, the inner ones stand.
    const float reach = 0.62F * shape.crown_diameter * (1 - 0.6F * t) * builder.random.between(0.8F, 1.1F);
    const float rise = height * (0.35F + 0.65F * t) * builder.random.between(0.8F, 1.1F);
    const glm::vec3 foot = out * builder.random.between(0.02F, 0.3F) * shape.crown_diameter + glm::vec3(0, 0, 0.2F * rise * t);
    const glm::vec3 knee = out * reach * 0.6F + glm::vec3(0, 0, rise * 0.8F);
    builder.blade(foot, knee, out * reach + glm::vec3(0, 0, rise), 0.085F * shape.crown_diameter,
                  builder.random.between(0.7F, 1.0F));
  }
}

/// Stalks with a head each, seen from above.
void flower_stalks(PlantMeshBuilder& builder, const PlantShape& shape, int count) {
  for (int i = 0; i < count; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + builder.random.unit();
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float height = shape.height * builder.random.between(0.75F, 1.1F);
    const glm::vec3 top = out * 0.34F * shape.crown_diameter + glm::vec3(0, 0, height);
    builder.blade(out * 0.03F, glm::mix(out * 0.05F, top, 0.6F), top, 0.009F, 0.8F);
    const float size = glm::clamp(0.13F * shape.crown_diameter, 0.03F, 0.09F) * builder.random.between(0.85F, 1.25F);
    builder.card({top, glm::normalize(out * 0.7F + glm::vec3(0, 0, 1)), out, size, size, LeafPicture::flower_head});
  }
}

}  // namespace

PlantMesh tuft_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  // Its middle lies below the ground, so that a tuft is lit as the meadow around it is.
  const float radius = shape.crown_diameter;
  PlantMeshBuilder builder({{0, 0, -0.9F * shape.height}, {radius, radius, 1.7F * shape.height}}, seed);
  const bool grass = shape.model == "grass";
  const bool blooms = shape.flower_colour[0] + shape.flower_colour[1] + shape.flower_colour[2] > 0.01F;
  const float leaf_height = blooms ? 0.6F * shape.height : shape.height;
  if (near) {
    if (grass) {
      grass_blades(builder, shape, 15);
    } else {
      spreading_leaves(builder, shape, 10, leaf_height);
      grass_blades(builder, shape, 7);
    }
    if (blooms) flower_stalks(builder, shape, 3);
    return builder.take();
  }
  const LeafPicture leaves = grass ? LeafPicture::blades : LeafPicture::rosette;
  const int cards = 2;
  for (int i = 0; i < cards; ++i) {
    const float turn = glm::pi<float>() * (float(i) + builder.random.between(-0.15F, 0.15F)) / float(cards);
    const glm::vec3 facing(std::cos(turn), std::sin(turn), 0);
    const float width = std::max(1.7F * shape.crown_diameter, 0.5F);
    builder.card({{0, 0, 0.48F * leaf_height}, facing, {0, 0, 1}, width, leaf_height, leaves});
    if (blooms) builder.card({{0, 0, 0.5F * shape.height}, facing, {0, 0, 1}, width, shape.height, LeafPicture::flower});
  }
  return builder.take();
}

}  // namespace biotope
