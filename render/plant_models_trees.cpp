#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/plant_mesh_builder.hpp"

namespace biotope {

namespace {

/// What tells one broadleaved tree from another.
struct BroadleafHabit {
  int lobes = 9;
  int cards = 18;           ///< of a lobe
  float lobe_size = 0.40F;  ///< of the crown's radii
  float card_size = 0.42F;  ///< of the crown's horizontal radius
  float point = 0;          ///< 0 round crown, 1 pointed
  float wide_at = 0.5F;     ///< height of the widest part within the crown
  LeafPicture picture = LeafPicture::broad;
  float trunk = 0.022F;  ///< radius / height
};

BroadleafHabit habit_of(const PlantShape& shape) {
  if (shape.model == "evergreen-oak") return {8, 19, 0.46F, 0.42F, 0, 0.5F, LeafPicture::small, 0.035F};
  if (shape.model == "alder") return {8, 18, 0.44F, 0.46F, 0.75F, 0.36F, LeafPicture::broad, 0.018F};
  if (shape.model == "birch") return {9, 15, 0.40F, 0.48F, 0.6F, 0.42F, LeafPicture::small, 0.013F};
  return {};
}

/// A point of the crown's lattice of lobes: golden angle around the axis, from low to high.
glm::vec3 lobe_place(int i, int count, const BroadleafHabit& habit, MeshRandom& random) {
  const float t = (float(i) + 0.5F) / float(count);
  const float height = 2 * t - 1;
  const float below = habit.wide_at * 2 - 1;
  const float away = height > below ? (height - below) / (1 - below) : (below - height) / (1 + below);
  const float round = std::sqrt(std::max(0.0F, 1 - away * away));
  const float cone = height > below ? 1 - away : round;
  const float level = glm::mix(round, cone, habit.point) * random.between(0.9F, 1.05F);
  const float turn = glm::radians(137.5F) * float(i) + random.between(-0.3F, 0.3F);
  return {level * std::cos(turn), level * std::sin(turn), height};
}

}  // namespace

PlantMesh broadleaf_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  BroadleafHabit habit = habit_of(shape);
  const float radius = 0.5F * shape.crown_diameter;
  const float base = shape.height * shape.trunk_fraction;
  const CrownForm crown{{0, 0, 0.5F * (base + shape.height)}, {radius, radius, 0.5F * (shape.height - base)}};
  PlantMeshBuilder builder(crown, seed);
  const float trunk = shape.height * habit.trunk;
  const glm::vec3 fork(builder.random.between(-0.03F, 0.03F) * shape.height, builder.random.between(-0.03F, 0.03F) * shape.height,
                       base + 0.25F * (shape.height - base));
  builder.stem({0, 0, -0.3F}, {fork.x * 0.4F, fork.y * 0.4F, 0.12F * shape.height}, trunk * 1.5F, trunk, near ? 6 : 3);
  builder.stem({fork.x * 0.38F, fork.y * 0.38F, 0.112F * shape.height}, fork, trunk, trunk * 0.75F, near ? 6 : 3);
  if (habit.point > 0.3F && near) builder.stem(fork, {fork.x, fork.y, 0.9F * shape.height}, trunk * 0.75F, trunk * 0.1F, 4);
  if (!near) {
    habit.lobes = 4;
    habit.cards = 7;
    habit.lobe_size = 0.56F;
    habit.card_size = 0.80F;
  }
  for (int i = 0; i < habit.lobes; ++i) {
    const glm::vec3 place = lobe_place(i, habit.lobes, habit, builder.random);
    const float share = habit.lobe_size * builder.random.between(0.85F, 1.2F);
    const CrownForm lobe{crown.centre + place * crown.radii * (1 - 0.8F * share),
                         crown.radii * share * glm::vec3(1.12F, 1.12F, 0.95F)};
    if (near) builder.stem(fork, glm::mix(fork, lobe.centre, 0.95F), trunk * 0.42F, trunk * 0.12F, 3);
    builder.lobe(lobe, habit.cards, radius * habit.card_size, habit.picture, 0.7F);
  }
  // The heart of the crown, so that one does not look through it.
  builder.lobe({crown.centre, crown.radii * 0.5F}, near ? 10 : 4, radius * habit.card_size * 1.1F, habit.picture, 0.9F);
  return builder.take();
}

PlantMesh pine_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  const float radius = 0.5F * shape.crown_diameter;
  const float base = shape.height * shape.trunk_fraction;
  const CrownForm crown{{0, 0, 0.55F * base + 0.45F * shape.height}, {radius, radius, 0.6F * (shape.height - base)}};
  PlantMeshBuilder builder(crown, seed);
  const float trunk = shape.height * 0.0135F;
  const glm::vec3 bend(builder.random.between(-0.04F, 0.04F) * shape.height, builder.random.between(-0.04F, 0.04F) * shape.height,
                       0.55F * shape.height);
  const glm::vec3 top(bend.x * 1.2F, bend.y * 1.2F, 0.93F * shape.height);
  builder.stem({0, 0, -0.3F}, bend, trunk * 1.25F, trunk * 0.85F, near ? 6 : 3);
  builder.stem(0.985F * bend, top, trunk * 0.85F, trunk * 0.15F, near ? 5 : 3);
  // Plates of needles on limbs that rise a little, widest low in the crown, rounded on top.
  const int limbs = near ? 13 : 6;
  for (int i = 0; i < limbs; ++i) {
    const float t = (float(i) + 0.4F) / float(limbs);
    const float height = glm::mix(base, 0.95F * shape.height, t);
    const float reach = radius * std::sqrt(std::max(0.05F, 1 - std::pow(t, 2.4F))) * builder.random.between(0.62F, 0.95F);
    const float turn = glm::radians(137.5F) * float(i) + builder.random.between(-0.4F, 0.4F);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const glm::vec3 start =
        glm::mix(bend, top, glm::clamp((height - bend.z) / (top.z - bend.z), 0.0F, 1.0F)) * glm::vec3(1, 1, 0) +
        glm::vec3(0, 0, height);
    const glm::vec3 tip = start + out * reach * 0.66F + glm::vec3(0, 0, 0.22F * reach);
    if (near) builder.stem(start, tip, trunk * 0.35F, trunk * 0.1F, 3);
    const float share = 0.44F * radius * builder.random.between(0.85F, 1.2F);
    builder.lobe({tip, {share * 1.15F, share * 1.15F, share * 0.55F}}, near ? 12 : 5, share * (near ? 1.4F : 2.0F),
                 LeafPicture::needles, 0.55F);
  }
  return builder.take();
}

PlantMesh spruce_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail == PlantDetail::near;
  const float radius = 0.5F * shape.crown_diameter;
  const float base = shape.height * shape.trunk_fraction;
  const float length = shape.height - base;
  const CrownForm crown{{0, 0, base + 0.3F * length}, {radius, radius, 0.7F * length}};
  PlantMeshBuilder builder(crown, seed);
  const float trunk = shape.height * 0.014F;
  builder.stem({0, 0, -0.3F}, {0, 0, 0.95F * shape.height}, trunk * 1.3F, trunk * 0.1F, near ? 5 : 3);
  // Tiers of hanging boughs like tiles of a steep roof, each overlapping the one below; closer together toward the top.
  const int tiers = near ? 16 : 6;
  const float shrink = std::pow(0.06F, 1.0F / float(tiers));
  float left = 1;
  for (int tier = 0; tier < tiers; ++tier, left *= shrink) {
    const float drop = length * left * (1 - shrink) * (near ? 1.7F : 1.3F);
    const float tip = shape.height - length * left;
    const int boughs = near ? (left > 0.4F ? 9 : 6) : (left > 0.3F ? 6 : 4);
    for (int b = 0; b < boughs; ++b) {
      const float turn = glm::two_pi<float>() * (float(b) + builder.random.between(-0.2F, 0.2F)) / float(boughs) +
                         glm::radians(137.5F) * float(tier);
      const float reach = radius * left * builder.random.between(0.78F, 1.0F);
      const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
      const glm::vec3 foot(0, 0, tip + drop * builder.random.between(0.9F, 1.1F));
      const glm::vec3 end = out * reach + glm::vec3(0, 0, tip + builder.random.between(-0.12F, 0.12F) * drop);
      const glm::vec3 along = end - foot;
      const glm::vec3 over = glm::normalize(out * drop + glm::vec3(0, 0, reach) + builder.random.direction() * 0.25F * drop);
      const float width = 1.5F * glm::two_pi<float>() * reach / float(boughs);
      builder.card({0.5F * (foot + end), over, along, width, glm::length(along), LeafPicture::bough});
    }
  }
  // The leader: two upright cards.
  for (const float turn : {0.3F, 1.9F}) {
    const float size = 0.1F * length;
    builder.card({{0, 0, shape.height - 0.5F * size},
                  {std::cos(turn), std::sin(turn), 0},
                  {0, 0, 1},
                  size * 0.35F,
                  size,
                  LeafPicture::bough});
  }
  return builder.take();
}

}  // namespace biotope
