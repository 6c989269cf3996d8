#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/plant_branches.hpp"

namespace biotope {

namespace {

/// Brushes of needles around a point, the lower ones level, the upper ones upright.
void needle_bunch(PlantMeshBuilder& builder, const CrownForm& bunch, int cards, float size) {
  for (int i = 0; i < cards; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + builder.random.unit();
    const float lift = (float(i) + 0.5F) / float(cards);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float away = std::sqrt(1 - lift * lift);
    FoliageCard card;
    card.centre = bunch.centre + bunch.radii * glm::vec3(out.x * away * 0.7F, out.y * away * 0.7F, 1.1F * lift - 0.45F);
    card.facing = glm::normalize(out * (0.35F + away * 0.4F) + glm::vec3(0, 0, 0.9F) + builder.random.direction() * 0.5F);
    card.upright = glm::normalize(out + glm::vec3(0, 0, 0.6F) + builder.random.direction() * 0.3F);
    card.width = card.height = size * builder.random.between(0.85F, 1.2F);
    card.picture = LeafPicture::needles;
    builder.card(card, &bunch);
  }
}

/// The same close to the eye: single shoots with their needles.
void needle_shoots(PlantMeshBuilder& builder, const CrownForm& bunch, int cards, float size) {
  for (int i = 0; i < cards; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + builder.random.unit();
    const float lift = builder.random.unit();
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float away = std::sqrt(1 - lift * lift) * std::sqrt(builder.random.unit());
    FoliageCard card;
    card.centre = bunch.centre + bunch.radii * glm::vec3(out.x * away, out.y * away, 1.1F * lift - 0.4F);
    card.upright = glm::normalize(out * (0.3F + away) + glm::vec3(0, 0, 0.75F) + builder.random.direction() * 0.4F);
    const glm::vec3 side = out * 0.8F + glm::vec3(0, 0, 0.5F) + builder.random.direction() * 0.7F;
    const glm::vec3 facing = side - card.upright * glm::dot(side, card.upright);
    card.facing = glm::length(facing) > 0.05F ? glm::normalize(facing) : perpendicular(card.upright);
    card.width = card.height = size * builder.random.between(0.85F, 1.25F);
    card.picture = LeafPicture::pine_spray;
    card.fold = 0.2F;
    builder.card(card, &bunch);
  }
}

}  // namespace

PlantMesh pine_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  const float radius = 0.5F * shape.crown_diameter;
  const float base = shape.height * shape.trunk_fraction;
  const CrownForm crown{{0, 0, 0.5F * base + 0.5F * shape.height}, {radius, radius, 0.56F * (shape.height - base)}};
  BranchingHabit habit;
  habit.outline = {0.38F, 0.12F, 0.3F};
  habit.trunk_radius = 0.0125F;
  habit.first = shape.trunk_fraction + 0.04F;
  habit.leader = 0.95F;
  habit.limbs = 16;
  habit.low_angle = 1.5F;
  habit.high_angle = 0.7F;
  habit.rise = 0.4F;
  habit.shoots = 2;
  habit.shoot_angle = 0.75F;
  habit.shoot_length = 0.5F;
  habit.twigs = 0;
  habit.wander = 0.09F;
  MeshRandom grown(seed);
  const Branching branching = grow_branches(shape, habit, grown);
  PlantMeshBuilder builder(crown, seed + 1);
  builder.set_bark(LeafPicture::plated_bark);
  add_branches(builder, branching, detail);
  // Plates of needles at the ends of limbs and shoots, with air between them.
  const std::size_t every = near ? 1 : 3;
  for (std::size_t i = 0; i < branching.spots.size(); i += every) {
    const LeafSpot& spot = branching.spots[i];
    const float own = radius * builder.random.between(0.24F, 0.32F) * (near ? 1.0F : 1.55F);
    const glm::vec3 at = near ? spot.at : glm::mix(spot.at, crown.centre, 0.14F);
    if (detail == PlantDetail::close) {
      needle_shoots(builder, {at, {1.15F * own, 1.15F * own, 0.6F * own}}, 30, own * 0.66F);
      continue;
    }
    needle_bunch(builder, {at, {own, own, 0.5F * own}}, near ? 6 : 2, own * (near ? 1.45F : 1.9F));
  }
  return builder.take();
}

PlantMesh spruce_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  const bool close = detail == PlantDetail::close;
  const float radius = 0.5F * shape.crown_diameter;
  const float base = shape.height * shape.trunk_fraction;
  const float length = shape.height - base;
  const CrownForm crown{{0, 0, base + 0.3F * length}, {radius, radius, 0.7F * length}};
  PlantMeshBuilder builder(crown, seed);
  const float trunk = shape.height * 0.014F;
  builder.stem({0, 0, -0.3F}, {0, 0, 0.97F * shape.height}, trunk * 1.3F, trunk * 0.08F, near ? 5 : 3);
  // Whorls of boughs that sweep down and out, shorter and closer together toward the top.
  const int whorls = close ? 34 : near ? 22 : 8;
  const float shrink = std::pow(0.07F, 1.0F / float(whorls));
  float left = 1;
  for (int whorl = 0; whorl < whorls; ++whorl, left *= shrink) {
    const float room = length * left * (1 - shrink);
    const float height = shape.height - length * left;
    const int boughs = (near ? (left > 0.45F ? 9 : 6) : (left > 0.35F ? 6 : 4)) + (close ? 4 : 0);
    for (int b = 0; b < boughs; ++b) {
      const float turn = glm::two_pi<float>() * (float(b) + builder.random.between(-0.28F, 0.28F)) / float(boughs) +
                         glm::radians(137.5F) * float(whorl);
      const float reach = radius * left * builder.random.between(0.7F, 1.02F);
      const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
      const float drop = (near ? 0.62F : 0.8F) * reach * (0.35F + 0.65F * left) + 0.5F * room;
      const glm::vec3 foot(0, 0, height + room * builder.random.between(0.5F, 1.5F) + 0.55F * drop);
      const glm::vec3 end = out * reach + glm::vec3(0, 0, height + builder.random.between(-0.3F, 0.5F) * room);
      const glm::vec3 along = end - foot;
      const glm::vec3 over = glm::normalize(out * drop + glm::vec3(0, 0, reach) + builder.random.direction() * 0.3F * reach);
      const float width = (near ? 1.35F : 1.6F) * glm::two_pi<float>() * reach / float(boughs);
      const CrownForm bunch{0.5F * (foot + end), glm::vec3(0.6F * reach, 0.6F * reach, 0.35F * reach + 0.02F)};
      builder.card(
          {0.5F * (foot + end), over, along, width, glm::length(along) * 1.04F, LeafPicture::bough, close ? 0.12F : 0.0F},
          &bunch);
    }
  }
  // The leader: two upright cards.
  for (const float turn : {0.3F, 1.9F}) {
    const float size = 0.12F * length;
    const glm::vec3 facing(std::cos(turn), std::sin(turn), 0);
    builder.card({{0, 0, shape.height - 0.5F * size}, facing, {0, 0, 1}, size * 0.32F, size, LeafPicture::bough});
  }
  return builder.take();
}

PlantMesh mountain_pine_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  const bool close = detail == PlantDetail::close;
  const float radius = 0.5F * shape.crown_diameter;
  const CrownForm crown{{0, 0, 0.38F * shape.height}, {radius, radius, 0.62F * shape.height}};
  PlantMeshBuilder builder(crown, seed);
  builder.set_bark(LeafPicture::plated_bark);
  const auto brushes = [&](const CrownForm& bunch, int cards, float size) {
    if (close) {
      needle_shoots(builder, bunch, 5 * cards, 0.5F * size);
    } else {
      needle_bunch(builder, bunch, cards, size);
    }
  };
  // Many bowed stems from one foot that turn up at their ends, each with upright brushes of needles.
  const int stems = near ? 13 : 6;
  for (int i = 0; i < stems; ++i) {
    const float t = std::sqrt((float(i) + 0.35F) / float(stems));
    const float turn = glm::radians(137.5F) * float(i);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float rise = shape.height * (0.9F - 0.52F * t * t) * builder.random.between(0.85F, 1.1F);
    const glm::vec3 elbow = out * radius * 0.5F * t + glm::vec3(0, 0, 0.16F * rise);
    const glm::vec3 tip = out * radius * (near ? 0.8F : 0.7F) * t + glm::vec3(0, 0, (near ? 0.76F : 0.66F) * rise);
    if (near) {
      const std::array<glm::vec3, 3> points{glm::vec3(0, 0, -0.1F), elbow, tip};
      const std::array<float, 3> radii{0.02F * shape.height, 0.015F * shape.height, 0.006F * shape.height};
      builder.stem(points, radii, 3);
    }
    const float size = (near ? 0.33F : 0.5F) * radius * builder.random.between(0.9F, 1.15F);
    brushes({tip, {size, size, size * 1.3F}}, near ? 10 : 5, size * (near ? 1.25F : 1.6F));
    if (near) brushes({glm::mix(elbow, tip, 0.4F), {size, size, size}}, 5, size * 1.2F);
  }
  // Boughs that lie on the ground around it.
  const int low = near ? 14 : 6;
  for (int i = 0; i < low; ++i) {
    const float turn = glm::radians(137.5F) * float(i) + 0.5F;
    const glm::vec3 at(std::cos(turn) * radius * 0.72F, std::sin(turn) * radius * 0.72F, 0.14F * shape.height);
    const float size = radius * (near ? 0.26F : 0.4F);
    brushes({at, {size, size, size * 0.8F}}, near ? 4 : 2, size * 1.4F);
  }
  return builder.take();
}

PlantMesh juniper_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const bool near = detail != PlantDetail::mid;
  const bool close = detail == PlantDetail::close;
  const float radius = 0.5F * shape.crown_diameter;
  const CrownForm crown{{0, 0, 0.45F * shape.height}, {radius, radius, 0.55F * shape.height}};
  PlantMeshBuilder builder(crown, seed);
  builder.stem({0, 0, -0.1F}, {0, 0, 0.4F * shape.height}, 0.035F * shape.height, 0.02F * shape.height, near ? 5 : 3);
  // Flames of scale leaves around the axis. A slender bush is a column to a point, a broad one a low dome of several.
  const bool broad = shape.crown_diameter > 0.55F * shape.height;
  const int rings = close ? 16 : near ? (broad ? 9 : 12) : 5;
  for (int ring = 0; ring < rings; ++ring) {
    const float t = (float(ring) + 0.3F) / float(rings);
    const float reach = radius * std::pow(std::sin(glm::pi<float>() * (0.2F + 0.78F * t)), broad ? 0.6F : 0.85F);
    const int flames = close ? 34 : near ? (broad ? 17 : 12) : 8;
    for (int i = 0; i < flames; ++i) {
      const float turn = glm::two_pi<float>() * (float(i) + builder.random.unit() * 0.7F) / float(flames) + 2.4F * float(ring);
      const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
      const float size = shape.height *
                         (close  ? 0.17F
                          : near ? (broad ? 0.26F : 0.22F)
                                 : 0.4F) *
                         builder.random.between(0.75F, 1.25F);
      const glm::vec3 facing = glm::normalize(out + builder.random.direction() * 0.6F);
      const glm::vec3 foot =
          out * reach * builder.random.between(0.45F, near ? 0.82F : 0.66F) + glm::vec3(0, 0, shape.height * t * 0.84F);
      const glm::vec3 upright = glm::normalize(glm::vec3(0, 0, 1) + out * (broad ? 0.7F : 0.2F) * builder.random.unit());
      const CrownForm bunch{foot, glm::vec3(0.5F * size)};
      const LeafPicture picture = close ? LeafPicture::scale_spray : LeafPicture::bough;
      const float width = size * (close ? 0.85F : 0.5F);
      builder.card({foot + upright * 0.35F * size, facing, upright, width, size, picture, close ? 0.15F : 0.0F}, &bunch);
    }
  }
  return builder.take();
}

}  // namespace biotope
