#include "render/plant_undergrowth.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/random.hpp"
#include "render/landscape_renderer.hpp"
#include "render/plant_mesh_builder.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

namespace {

/// Side of the lattice that undergrowth stands on, one at most in a cell, m.
constexpr float lattice_side = 1;
/// Ferns and herbs stand in patches of some metres.
constexpr float patch_side = 7;

PlantMeshBuilder lit_from_above(float height, float radius, std::uint64_t seed) {
  return PlantMeshBuilder({{0, 0, -0.6F * height}, {radius, radius, 1.6F * height}}, seed);
}

PlantMesh fern_mesh(std::uint64_t seed) {
  PlantMeshBuilder builder = lit_from_above(0.6F, 0.6F, seed);
  constexpr int fronds = 11;
  for (int i = 0; i < fronds; ++i) {
    const float turn = glm::radians(137.5F) * float(i);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    const float lift = builder.random.between(0.35F, 1.5F);
    const glm::vec3 along = glm::normalize(out + glm::vec3(0, 0, lift));
    const float length = builder.random.between(0.45F, 0.75F);
    FoliageCard card;
    card.height = length;
    card.width = 0.40F * length;
    card.upright = along;
    card.facing = glm::normalize(glm::vec3(0, 0, 1) - along * along.z);
    card.centre = out * 0.04F + along * 0.5F * length;
    card.picture = LeafPicture::frond;
    card.fold = 0.26F;
    builder.card(card);
  }
  return builder.take();
}

PlantMesh shade_herb_mesh(std::uint64_t seed) {
  PlantMeshBuilder builder = lit_from_above(0.2F, 0.4F, seed);
  constexpr int whorls = 6;
  for (int i = 0; i < whorls; ++i) {
    const float turn = glm::radians(137.5F) * float(i);
    const float away = 0.24F * std::sqrt((float(i) + 0.3F) / whorls);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    FoliageCard card;
    card.width = card.height = builder.random.between(0.17F, 0.26F);
    card.facing = glm::normalize(out * 0.35F + glm::vec3(0, 0, 1) + builder.random.direction() * 0.2F);
    card.upright = out;
    card.centre = out * away + glm::vec3(0, 0, builder.random.between(0.07F, 0.2F));
    card.picture = LeafPicture::shade_leaves;
    card.fold = 0.12F;
    builder.card(card);
  }
  return builder.take();
}

PlantMesh sapling_mesh(std::uint64_t seed) {
  constexpr float height = 1.7F;
  PlantMeshBuilder builder = lit_from_above(height, 0.6F, seed);
  builder.set_bark(LeafPicture::smooth_bark);
  const glm::vec3 bend = 0.12F * builder.random.direction();
  const std::array<glm::vec3, 3> stem{glm::vec3(0, 0, -0.05F), glm::vec3(bend.x, bend.y, 0.5F * height),
                                      glm::vec3(-bend.x, bend.y, 0.95F * height)};
  const std::array<float, 3> radii{0.014F, 0.010F, 0.003F};
  builder.stem(stem, radii, 3);
  constexpr int sprays = 15;
  for (int i = 0; i < sprays; ++i) {
    const float t = (float(i) + 0.5F) / sprays;
    const float turn = glm::radians(137.5F) * float(i);
    const glm::vec3 out(std::cos(turn), std::sin(turn), 0);
    FoliageCard card;
    card.width = card.height = (0.52F - 0.22F * t) * builder.random.between(0.85F, 1.15F);
    card.upright = glm::normalize(out + glm::vec3(0, 0, 0.15F + 0.6F * t));
    card.facing = glm::normalize(glm::vec3(0, 0, 1) + builder.random.direction() * 0.35F - out * 0.3F);
    card.centre = glm::mix(stem[0], stem[2], 0.28F + 0.74F * t) + card.upright * 0.42F * card.height;
    card.picture = LeafPicture::oval_spray;
    card.fold = 0.12F;
    builder.card(card);
  }
  return builder.take();
}

PlantMesh fallen_branch_mesh(std::uint64_t seed) {
  PlantMeshBuilder builder = lit_from_above(0.25F, 1.2F, seed);
  const std::array<glm::vec3, 4> stem{glm::vec3(-1.1F, 0.1F, 0.05F), glm::vec3(-0.3F, -0.04F, 0.09F),
                                      glm::vec3(0.4F, 0.06F, 0.06F), glm::vec3(1.2F, -0.1F, 0.16F)};
  const std::array<float, 4> radii{0.042F, 0.036F, 0.026F, 0.008F};
  builder.stem(stem, radii, 5);
  for (int i = 0; i < 5; ++i) {
    const float side = i % 2 == 0 ? 1.0F : -1.0F;
    const glm::vec3 from = glm::mix(stem[1], stem[3], 0.18F * float(i));
    const glm::vec3 middle = from + glm::vec3(0.26F, 0.24F * side, builder.random.between(0.02F, 0.14F));
    const glm::vec3 tip = middle + glm::vec3(0.25F, 0.16F * side, builder.random.between(-0.06F, 0.12F));
    const std::array<glm::vec3, 3> twig{from, middle, tip};
    const std::array<float, 3> thin{0.015F, 0.010F, 0.003F};
    builder.stem(twig, thin, 3);
  }
  return builder.take();
}

PlantMesh log_mesh(std::uint64_t seed) {
  PlantMeshBuilder builder = lit_from_above(0.35F, 1.8F, seed);
  const std::array<glm::vec3, 6> stem{glm::vec3(-1.81F, 0, 0.12F),    glm::vec3(-1.8F, 0, 0.12F),
                                      glm::vec3(-0.7F, 0.06F, 0.13F), glm::vec3(0.6F, -0.04F, 0.12F),
                                      glm::vec3(1.7F, 0.05F, 0.13F),  glm::vec3(1.71F, 0.05F, 0.13F)};
  const std::array<float, 6> radii{0.02F, 0.19F, 0.175F, 0.165F, 0.145F, 0.02F};
  builder.stem(stem, radii, 10);
  builder.stem({0.3F, 0, 0.2F}, {0.42F, 0.16F, 0.42F}, 0.04F, 0.028F, 5);
  builder.stem({-0.9F, 0, 0.2F}, {-0.8F, -0.2F, 0.36F}, 0.035F, 0.022F, 5);
  return builder.take();
}

PlantTraits traits_of(const PlantShape& shape, Stratum stratum) {
  PlantTraits traits;
  traits.shape = shape;
  traits.stratum = stratum;
  return traits;
}

}  // namespace

UndergrowthLook undergrowth_look(Undergrowth kind) {
  PlantShape shape;
  shape.flower_colour = {0, 0, 0};
  switch (kind) {
    case Undergrowth::fern:
      shape.leaf_colour = {0.30F, 0.44F, 0.17F};
      shape.autumn_colour = {0.44F, 0.33F, 0.20F};
      return {traits_of(shape, Stratum::herb)};
    case Undergrowth::shade_herb:
      shape.leaf_colour = {0.28F, 0.44F, 0.18F};
      shape.autumn_colour = {0.36F, 0.40F, 0.18F};
      return {traits_of(shape, Stratum::herb)};
    case Undergrowth::sapling:
      // Young hornbeams and oaks keep their withered leaves through the winter.
      shape.leaf_colour = {0.33F, 0.47F, 0.18F};
      shape.autumn_colour = {0.50F, 0.38F, 0.25F};
      return {traits_of(shape, Stratum::herb), {0.44F, 0.41F, 0.37F}};
    case Undergrowth::fallen_branch:
      return {traits_of(shape, Stratum::herb), {0.42F, 0.38F, 0.33F}};
    case Undergrowth::log:
      return {traits_of(shape, Stratum::herb), {0.40F, 0.35F, 0.29F}};
    case Undergrowth::stone:
      return {traits_of(shape, Stratum::herb), {0.56F, 0.55F, 0.52F}};
  }
  return {};
}

PlantMesh undergrowth_mesh(Undergrowth kind, std::uint64_t seed) {
  switch (kind) {
    case Undergrowth::fern:
      return fern_mesh(seed);
    case Undergrowth::shade_herb:
      return shade_herb_mesh(seed);
    case Undergrowth::sapling:
      return sapling_mesh(seed);
    case Undergrowth::fallen_branch:
      return fallen_branch_mesh(seed);
    case Undergrowth::log:
      return log_mesh(seed);
    case Undergrowth::stone: {
      PlantMeshBuilder builder = lit_from_above(0.4F, 0.5F, seed);
      builder.set_bark(LeafPicture::stone);
      builder.boulder({0.42F, 0.33F, 0.27F}, 9, 6);
      return builder.take();
    }
  }
  return {};
}

std::array<float, undergrowth_kinds> undergrowth_density(const ForestFloor& floor) {
  const float shade = glm::smoothstep(0.22F, 0.65F, floor.canopy);
  const float damp = glm::smoothstep(2.5F, 6.5F, floor.moisture);
  const float leafy = 1 - floor.evergreen;
  // Where herbs were taken away, others do not come up in their place.
  const float green = 0.25F + 0.75F * std::min(1.0F, 2.5F * floor.herbs);
  const float steep = glm::smoothstep(0.25F, 0.6F, floor.slope);
  return {0.30F * shade * damp * green * (0.35F + 0.65F * leafy),
          0.75F * shade * green * (0.25F + 0.75F * leafy) * (0.4F + 0.6F * damp),
          0.055F * shade * (0.3F + 0.7F * leafy),
          0.045F * glm::smoothstep(0.1F, 0.6F, floor.canopy),
          0.006F * shade,
          0.004F + 0.010F * shade + 0.05F * steep};
}

std::vector<PlantInstance> PlantPlacement::undergrowth(int column, int row) const {
  std::vector<PlantInstance> out;
  if (!snapshot_ || kinds_[std::size_t(Stratum::tree)].empty()) return out;
  constexpr int cells = int(herb_block_side / lattice_side);
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      if (const auto one = undergrowth_at(column * cells + i, row * cells + j)) out.push_back(*one);
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const PlantInstance& a, const PlantInstance& b) { return a.rank < b.rank; });
  return out;
}

std::optional<PlantInstance> PlantPlacement::undergrowth_at(int lattice_x, int lattice_y) const {
  const Terrain& terrain = snapshot_->terrain();
  const std::uint64_t seed = snapshot_->document.seed;
  const std::uint64_t own = random_bits({seed, 0x666c6f6f72ULL, std::uint64_t(lattice_x), std::uint64_t(lattice_y)});
  const auto draw = [](std::uint64_t place, std::uint64_t what) { return float(mix_bits(place + what) >> 40U) * 0x1.0p-24F; };
  PlantInstance plant;
  plant.x = (float(lattice_x) + draw(own, 1)) * lattice_side;
  plant.y = (float(lattice_y) + draw(own, 2)) * lattice_side;
  const int map_x = int(std::floor(plant.x / float(terrain.cell_size)));
  const int map_y = terrain.height.height() - 1 - int(std::floor(plant.y / float(terrain.cell_size)));
  if (!terrain.height.contains(map_x, map_y) || !grows_at(map_x, map_y, plant.x, plant.y, 1.5F)) return std::nullopt;
  const auto density = undergrowth_density(forest_floor(map_x, map_y));
  const std::uint64_t patch = random_bits({seed, 0x7061746368ULL, std::uint64_t(std::int64_t(std::floor(plant.x / patch_side))),
                                           std::uint64_t(std::int64_t(std::floor(plant.y / patch_side)))});
  float chance = draw(own, 3);
  for (int kind = 0; kind < undergrowth_kinds; ++kind) {
    const bool in_patches = Undergrowth(kind) == Undergrowth::fern || Undergrowth(kind) == Undergrowth::shade_herb;
    const float here = in_patches ? 2 * draw(patch, std::uint64_t(kind)) : 1.0F;
    const float share = density[std::size_t(kind)] * lattice_side * lattice_side * here;
    if (chance >= share) {
      chance -= share;
      continue;
    }
    plant.z = ground_height(terrain, plant.x, plant.y);
    plant.plant = float(first_undergrowth_kind + kind);
    plant.scale = 0.6F + 0.8F * draw(own, 4) * draw(own, 4);
    if (Undergrowth(kind) == Undergrowth::stone) plant.scale *= 0.45F + 1.3F * draw(own, 8) * draw(own, 8);
    plant.turn = glm::two_pi<float>() * draw(own, 5);
    plant.tint = draw(own, 6);
    plant.rank = draw(own, 7);
    return plant;
  }
  return std::nullopt;
}

ForestFloor PlantPlacement::forest_floor(int x, int y) const {
  ForestFloor floor;
  for (const Kind& kind : kinds_[std::size_t(Stratum::tree)]) {
    const float cover = cover_fraction((*kind.cover)(x, y));
    floor.canopy += cover;
    floor.evergreen += kind.evergreen ? cover : 0.0F;
  }
  if (floor.canopy > 0) floor.evergreen /= floor.canopy;
  floor.canopy = std::min(1.0F, floor.canopy);
  for (const Kind& kind : kinds_[std::size_t(Stratum::herb)]) floor.herbs += cover_fraction((*kind.cover)(x, y));
  if (snapshot_->environment) floor.moisture = snapshot_->environment->map(Resource::moisture).mean(x, y);
  if (snapshot_->derivatives) floor.slope = snapshot_->derivatives->slope(x, y);
  return floor;
}

}  // namespace biotope
