#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/plant_branches.hpp"

namespace biotope {

namespace {

/// How leaves sit on a tree.
struct LeafHabit {
  LeafPicture picture = LeafPicture::broad;
  float size = 0.30F;                           ///< of a card / crown radius
  float hang = 0;                               ///< 0 cards follow their twig .. 1 they hang from it
  float spread = 0.7F;                          ///< how far cards turn away from their twig
  int cards = 2;                                ///< at a place
  LeafPicture spray = LeafPicture::oval_spray;  ///< close to the eye
  LeafPicture bark = LeafPicture::bark;
};

struct TreeHabit {
  BranchingHabit branching;
  LeafHabit leaves;
};

TreeHabit oak() {
  TreeHabit habit;
  habit.branching.outline = {0.42F, 0, 0.35F};
  habit.branching.trunk_radius = 0.024F;
  habit.branching.leader = 0.72F;
  habit.branching.limbs = 11;
  habit.branching.wander = 0.13F;
  habit.leaves = {LeafPicture::broad, 0.40F, 0, 0.85F, 2, LeafPicture::oak_spray, LeafPicture::bark};
  return habit;
}

/// Narrower crowns stand on a trunk that goes through: hornbeams and their like.
TreeHabit upright_broadleaf() {
  TreeHabit habit;
  habit.branching.outline = {0.36F, 0.45F, 0.1F};
  habit.branching.leader = 0.9F;
  habit.branching.limbs = 11;
  habit.branching.low_angle = 1.05F;
  habit.leaves = {LeafPicture::small, 0.40F, 0.1F, 0.75F, 2, LeafPicture::oval_spray, LeafPicture::smooth_bark};
  return habit;
}

/// Hazels and their like: many stems from one foot that lean outward.
TreeHabit many_stemmed() {
  TreeHabit habit;
  habit.branching.outline = {0.6F, 0, 0};
  habit.branching.stems = 6;
  habit.branching.lean = 0.42F;
  habit.branching.trunk_radius = 0.011F;
  habit.branching.first = 0.22F;
  habit.branching.leader = 0.88F;
  habit.branching.limbs = 14;
  habit.branching.twigs = 1;
  habit.branching.shoots = 2;
  habit.branching.low_angle = 0.75F;
  habit.leaves = {LeafPicture::broad, 0.42F, 0.1F, 0.8F, 3, LeafPicture::oval_spray, LeafPicture::smooth_bark};
  return habit;
}

TreeHabit evergreen_oak() {
  TreeHabit habit;
  habit.branching.outline = {0.5F, 0, 0.25F};
  habit.branching.stems = 2;
  habit.branching.lean = 0.18F;
  habit.branching.trunk_radius = 0.022F;
  habit.branching.first = 0.22F;
  habit.branching.leader = 0.7F;
  habit.branching.limbs = 11;
  habit.branching.wander = 0.14F;
  habit.leaves = {LeafPicture::small, 0.40F, 0, 0.95F, 2, LeafPicture::leathery_spray, LeafPicture::bark};
  return habit;
}

/// Alders stand alone or, where they were browsed young, several from one foot.
TreeHabit alder(bool several) {
  TreeHabit habit;
  habit.branching.outline = {0.34F, 0.6F, 0};
  habit.branching.stems = several ? 3 : 1;
  habit.branching.lean = 0.13F;
  habit.branching.trunk_radius = several ? 0.0084F : 0.0135F;
  habit.branching.leader = 0.93F;
  habit.branching.limbs = 15;
  habit.branching.twigs = 1;
  habit.branching.shoots = 3;
  habit.branching.low_angle = 1.3F;
  habit.branching.high_angle = 0.6F;
  habit.branching.rise = 0.1F;
  habit.leaves = {LeafPicture::broad, 0.54F, 0.1F, 0.7F, 2, LeafPicture::round_spray, LeafPicture::plated_bark};
  return habit;
}

TreeHabit birch() {
  TreeHabit habit;
  habit.branching.outline = {0.4F, 0.5F, 0};
  habit.branching.trunk_radius = 0.011F;
  habit.branching.leader = 0.94F;
  habit.branching.limbs = 13;
  habit.branching.low_angle = 0.85F;
  habit.branching.high_angle = 0.35F;
  habit.branching.rise = 0.1F;
  habit.branching.shoots = 4;
  habit.branching.shoot_rise = -1.3F;
  habit.branching.shoot_length = 0.5F;
  habit.leaves = {LeafPicture::airy, 0.60F, 0.75F, 0.5F, 1, LeafPicture::birch_spray, LeafPicture::pale_bark};
  return habit;
}

TreeHabit habit_of(const PlantShape& shape, std::uint64_t seed) {
  TreeHabit habit;
  if (shape.model == "evergreen-oak") {
    habit = evergreen_oak();
  } else if (shape.model == "alder") {
    habit = alder(seed % 2 == 1);
  } else if (shape.model == "birch") {
    habit = birch();
  } else if (shape.trunk_fraction < 0.12F) {
    habit = many_stemmed();
  } else {
    habit = shape.crown_diameter < 0.68F * shape.height ? upright_broadleaf() : oak();
  }
  if (habit.branching.stems == 1) habit.branching.first = std::max(0.1F, shape.trunk_fraction);
  return habit;
}

/// Cards of one kind around a twig.
struct LeafCards {
  int count = 1;
  float size = 1;  ///< m
  LeafPicture picture = LeafPicture::broad;
  float fold = 0;
};

/// Leaves of one spot of a crown: many small cards along the last part of its twig, each turned its own way.
void leaves_along(PlantMeshBuilder& builder, const LeafSpot& spot, const CrownForm& crown, const CrownForm& bunch,
                  const LeafHabit& habit, const LeafCards& cards) {
  const float size = cards.size;
  for (int c = 0; c < cards.count; ++c) {
    const float back = (float(c) + builder.random.unit()) / float(cards.count);
    const glm::vec3 aside = builder.random.direction() * (0.5F + 0.5F * back);
    // Loosely around the twig, so that light and sky come through between the sprays.
    const glm::vec3 loose = builder.random.direction() * builder.random.unit() * 0.9F * size;
    const glm::vec3 from = spot.at - spot.along * std::max(spot.length, 1.4F * size) * 0.9F * back + loose;
    const glm::vec3 outward = glm::normalize((from - crown.centre) / crown.radii + builder.random.direction() * 0.3F);
    const glm::vec3 hanging(0, 0, -1);
    const glm::vec3 along =
        glm::normalize(glm::mix(spot.along, hanging, habit.hang) + aside * (0.5F + habit.spread) + outward * 0.25F);
    glm::vec3 facing = glm::vec3(0, 0, 0.85F * (1 - habit.hang)) + outward * 0.7F + builder.random.direction() * 0.5F;
    facing -= along * glm::dot(facing, along);
    if (glm::length(facing) < 0.05F) facing = perpendicular(along);
    FoliageCard card;
    card.width = card.height = size * builder.random.between(0.8F, 1.2F);
    card.centre = from + along * card.height * 0.42F;
    card.facing = glm::normalize(facing);
    card.upright = along;
    card.picture = cards.picture;
    card.fold = cards.fold;
    builder.card(card, &bunch);
  }
}

/// A card at a spot, turned away from its twig and half toward the outside of the crown, moved `inward` (m).
void leaf_card(PlantMeshBuilder& builder, const LeafSpot& spot, const CrownForm& crown, const CrownForm& bunch,
               const LeafHabit& habit, float size, float inward) {
  const glm::vec3 outward = glm::normalize((spot.at - crown.centre) / crown.radii + builder.random.direction() * 0.35F);
  const glm::vec3 hanging(0, 0, -1);
  glm::vec3 along =
      glm::normalize(glm::mix(spot.along, hanging, habit.hang) + builder.random.direction() * habit.spread + outward * 0.15F);
  // Hung cards face outward level; others lie more or less like tiles over the bunch.
  glm::vec3 facing = outward + glm::vec3(0, 0, 0.35F * (1 - habit.hang)) + builder.random.direction() * 0.35F;
  facing -= along * glm::dot(facing, along);
  if (glm::length(facing) < 0.05F) facing = perpendicular(along);
  FoliageCard card;
  card.width = card.height = size * builder.random.between(0.85F, 1.15F);
  card.centre = spot.at + along * card.height * 0.3F - outward * inward;
  card.facing = glm::normalize(facing);
  card.upright = along;
  card.picture = habit.picture;
  builder.card(card, &bunch);
}

}  // namespace

PlantMesh broadleaf_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  const TreeHabit habit = habit_of(shape, seed);
  const float radius = 0.5F * shape.crown_diameter;
  const float base = shape.height * shape.trunk_fraction;
  const CrownForm crown{{0, 0, 0.5F * (base + shape.height)}, {radius, radius, 0.5F * (shape.height - base)}};
  // All levels of detail are the same tree.
  MeshRandom grown(seed);
  const Branching branching = grow_branches(shape, habit.branching, grown);
  PlantMeshBuilder builder(crown, seed + 1);
  builder.set_bark(habit.leaves.bark);
  add_branches(builder, branching, detail);
  if (detail == PlantDetail::close) {
    // As much leaf as the coarser models have, in cards that show each leaf in its size.
    constexpr float most_cards = 1250;
    const float area = float(branching.spots.size()) * float(habit.leaves.cards) * std::pow(radius * habit.leaves.size, 2.0F);
    const int cards = std::max(1, int(most_cards / float(branching.spots.size())));
    const float size = 0.86F * std::sqrt(area / (float(cards) * float(branching.spots.size())));
    for (const LeafSpot& spot : branching.spots) {
      leaves_along(builder, spot, crown, branching.bunches[std::size_t(spot.limb)], habit.leaves,
                   {cards, size, habit.leaves.spray, 0.16F});
    }
    return builder.take();
  }
  if (near) {
    // Small cards: large ones are sheets where one looks along them. As much leaf as a card of the habit's size has.
    constexpr int near_cards = 2;
    const float size = 0.84F * radius * habit.leaves.size;
    for (const LeafSpot& spot : branching.spots) {
      leaves_along(builder, spot, crown, branching.bunches[std::size_t(spot.limb)], habit.leaves,
                   {near_cards * habit.leaves.cards, size, habit.leaves.picture, 0});
    }
    return builder.take();
  }
  // From afar fewer, larger cards stand for all of them.
  constexpr std::size_t most_afar = 38;
  const std::size_t every = std::max<std::size_t>(1, (branching.spots.size() + most_afar - 1) / most_afar);
  const float larger = 0.85F * std::sqrt(float(every) * float(habit.leaves.cards));
  const float size = radius * habit.leaves.size * larger;
  for (std::size_t i = 0; i < branching.spots.size(); i += every) {
    const LeafSpot& spot = branching.spots[i];
    const CrownForm& bunch = branching.bunches[std::size_t(spot.limb)];
    leaf_card(builder, spot, crown, bunch, habit.leaves, size, 0.38F * (size - size / larger));
  }
  return builder.take();
}

}  // namespace biotope
