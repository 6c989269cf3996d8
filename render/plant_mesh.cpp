#include "render/plant_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/random.hpp"
#include "render/plant_mesh_builder.hpp"

namespace biotope {

namespace {

/// Any unit vector perpendicular to a unit vector.
glm::vec3 perpendicular(const glm::vec3& v) {
  const glm::vec3 other = std::abs(v.z) < 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  return glm::normalize(glm::cross(v, other));
}

}  // namespace

float MeshRandom::unit() { return float(random_unit({seed_, 0x6d657368ULL, drawn_++})); }

glm::vec3 MeshRandom::direction() {
  const float z = between(-1, 1);
  const float turn = between(0, glm::two_pi<float>());
  const float level = std::sqrt(std::max(0.0F, 1 - z * z));
  return {level * std::cos(turn), level * std::sin(turn), z};
}

void PlantMeshBuilder::quad(const std::array<PlantVertex, 4>& corners) {
  const auto first = std::uint16_t(mesh_.vertices.size());
  mesh_.vertices.insert(mesh_.vertices.end(), corners.begin(), corners.end());
  for (const int i : {0, 1, 2, 0, 2, 3}) mesh_.indices.push_back(std::uint16_t(first + i));
}

glm::vec3 PlantMeshBuilder::soft_normal(const glm::vec3& at, const glm::vec3& facing) const {
  const glm::vec3 outward = (at - crown_.centre) / (crown_.radii * crown_.radii);
  const glm::vec3 side = glm::length(outward) > 1e-4F ? glm::normalize(outward) : glm::vec3(0, 0, 1);
  const glm::vec3 out = glm::dot(facing, side) < 0 ? -facing : facing;
  return glm::normalize(side * 0.75F + out * 0.35F + glm::vec3(0, 0, 0.15F));
}

float PlantMeshBuilder::openness(const glm::vec3& at) const {
  const glm::vec3 local = (at - crown_.centre) / crown_.radii;
  const float outside = glm::smoothstep(0.25F, 1.05F, glm::length(local));
  const float height = glm::smoothstep(-1.1F, 0.7F, local.z);
  return glm::clamp(0.16F + 0.50F * outside * (0.45F + 0.55F * height) + 0.36F * height, 0.0F, 1.0F);
}

void PlantMeshBuilder::stem(const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to, int sides) {
  const glm::vec3 along = glm::normalize(to - from);
  const glm::vec3 right = perpendicular(along);
  const glm::vec3 forward = glm::cross(along, right);
  for (int i = 0; i < sides; ++i) {
    std::array<PlantVertex, 4> corners{};
    for (int c = 0; c < 4; ++c) {
      const bool next = c == 1 || c == 2;
      const bool top = c >= 2;
      const float turn = glm::two_pi<float>() * float(i + (next ? 1 : 0)) / float(sides);
      const glm::vec3 out = right * std::cos(turn) + forward * std::sin(turn);
      const glm::vec3 at = top ? to + out * radius_to : from + out * radius_from;
      const float shade = at.z < crown_.centre.z - crown_.radii.z ? 0.75F : 0.35F + 0.3F * openness(at);
      corners[std::size_t(c)] = {at,
                                 out,
                                 {float(i + (next ? 1 : 0)) / float(sides), top ? glm::length(to - from) : 0.0F},
                                 float(LeafPicture::bark),
                                 shade,
                                 2,
                                 0};
    }
    quad(corners);
  }
}

void PlantMeshBuilder::card(const FoliageCard& card) {
  const glm::vec3 right = glm::normalize(glm::cross(card.upright, card.facing));
  const glm::vec3 up = glm::cross(card.facing, right);
  const float fall = random.unit();
  std::array<PlantVertex, 4> corners{};
  constexpr std::array<glm::vec2, 4> uvs{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t c = 0; c < 4; ++c) {
    const glm::vec3 at = card.centre + right * ((uvs[c].x - 0.5F) * card.width) + up * ((uvs[c].y - 0.5F) * card.height);
    corners[c] = {at, soft_normal(at, card.facing), uvs[c], float(card.picture), openness(at), fall, 1};
  }
  quad(corners);
}

void PlantMeshBuilder::lobe(const CrownForm& form, int cards, float size, LeafPicture picture, float roughness) {
  const float start = random.between(0, glm::two_pi<float>());
  for (int i = 0; i < cards; ++i) {
    // Golden angle over the sphere: even cover with few cards.
    const float z = 1 - 2 * (float(i) + 0.5F) / float(cards);
    const float level = std::sqrt(std::max(0.0F, 1 - z * z));
    const float turn = start + glm::radians(137.5F) * float(i);
    const glm::vec3 out(level * std::cos(turn), level * std::sin(turn), z);
    FoliageCard leaf;
    leaf.centre = form.centre + out * form.radii * random.between(0.62F, 0.86F);
    leaf.facing = glm::normalize(out + random.direction() * roughness);
    leaf.upright = glm::normalize(random.direction() + glm::vec3(0, 0, 0.8F) + out * 0.3F);
    if (std::abs(glm::dot(leaf.facing, leaf.upright)) > 0.97F) leaf.upright = perpendicular(leaf.facing);
    leaf.width = leaf.height = size * random.between(0.85F, 1.15F);
    leaf.picture = picture;
    card(leaf);
  }
}

PlantMesh make_plant_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const std::string& model = shape.model;
  if (model == "conifer")
    return shape.trunk_fraction >= 0.25F ? pine_mesh(shape, detail, seed) : spruce_mesh(shape, detail, seed);
  if (model == "mountain-pine") return mountain_pine_mesh(shape, detail, seed);
  if (model == "juniper") return juniper_mesh(shape, detail, seed);
  if (model == "shrub") return shrub_mesh(shape, detail, seed);
  if (model == "grass" || model == "herb" || model == "flower") return tuft_mesh(shape, detail, seed);
  const bool tree = model == "broadleaf" || model == "evergreen-oak" || model == "alder" || model == "birch" || shape.height > 3;
  return tree ? broadleaf_mesh(shape, detail, seed) : tuft_mesh(shape, detail, seed);
}

PlantExtent extent_of(const PlantMesh& mesh) {
  PlantExtent extent;
  for (const PlantVertex& vertex : mesh.vertices) {
    extent.radius = std::max(extent.radius, std::hypot(vertex.position.x, vertex.position.y));
    extent.height = std::max(extent.height, vertex.position.z);
  }
  return extent;
}

}  // namespace biotope
