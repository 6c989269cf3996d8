#include "render/plant_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/random.hpp"
#include "render/plant_mesh_builder.hpp"

namespace biotope {

glm::vec3 perpendicular(const glm::vec3& v) {
  const glm::vec3 other = std::abs(v.z) < 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  return glm::normalize(glm::cross(v, other));
}

float MeshRandom::unit() { return float(random_unit({seed_, 0x6d657368ULL, drawn_++})); }

glm::vec3 MeshRandom::direction() {
  const float z = between(-1, 1);
  const float turn = between(0, glm::two_pi<float>());
  const float level = std::sqrt(std::max(0.0F, 1 - z * z));
  return {level * std::cos(turn), level * std::sin(turn), z};
}

void PlantMeshBuilder::triangle(std::size_t a, std::size_t b, std::size_t c) {
  for (const std::size_t i : {a, b, c}) mesh_.indices.push_back(std::uint16_t(i));
}

glm::vec3 PlantMeshBuilder::soft_normal(const glm::vec3& at, const glm::vec3& facing, const CrownForm* bunch) const {
  const auto outward = [&](const CrownForm& form) {
    const glm::vec3 out = (at - form.centre) / (form.radii * form.radii);
    return glm::length(out) > 1e-4F ? glm::normalize(out) : glm::vec3(0, 0, 1);
  };
  const glm::vec3 side = bunch != nullptr ? glm::normalize(outward(crown_) * 0.9F + outward(*bunch) * 0.75F) : outward(crown_);
  const glm::vec3 out = glm::dot(facing, side) < 0 ? -facing : facing;
  return glm::normalize(side * 0.8F + out * 0.3F + glm::vec3(0, 0, 0.3F));
}

float PlantMeshBuilder::openness(const glm::vec3& at, const CrownForm* bunch) const {
  const glm::vec3 local = (at - crown_.centre) / crown_.radii;
  const float outside = glm::smoothstep(0.25F, 1.0F, glm::length(local));
  const float height = glm::smoothstep(-1.1F, 0.7F, local.z);
  float open = 0.18F + 0.44F * outside * (0.4F + 0.6F * height) + 0.38F * height;
  if (bunch != nullptr) {
    const glm::vec3 within = (at - bunch->centre) / bunch->radii;
    open *= 0.55F + 0.48F * glm::smoothstep(-0.9F, 1.1F, within.z + 0.45F * glm::length(within));
  }
  return glm::clamp(open, 0.0F, 1.0F);
}

float PlantMeshBuilder::shade_of_wood(const glm::vec3& at) const {
  return at.z < crown_.centre.z - crown_.radii.z ? 0.75F : 0.3F + 0.35F * openness(at, nullptr);
}

template <class Radius>
void PlantMeshBuilder::tube(std::span<const glm::vec3> points, int sides, float around, const Radius& radius) {
  const std::size_t first = mesh_.vertices.size();
  const std::size_t ring = std::size_t(sides) + 1;
  float travelled = 0;
  glm::vec3 right = perpendicular(glm::normalize(points[1] - points[0]));
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::vec3 along = glm::normalize(points[std::min(p + 1, points.size() - 1)] - points[p > 0 ? p - 1 : 0]);
    // The ring before, turned as little as may be.
    right = glm::normalize(right - along * glm::dot(right, along));
    const glm::vec3 forward = glm::cross(along, right);
    if (p > 0) travelled += glm::length(points[p] - points[p - 1]);
    for (std::size_t i = 0; i < ring; ++i) {
      const float turn = glm::two_pi<float>() * float(i) / float(sides);
      const glm::vec3 out = right * std::cos(turn) + forward * std::sin(turn);
      const glm::vec3 at = points[p] + out * radius(p, turn);
      mesh_.vertices.push_back(
          {at, out, {float(i) / float(sides) * around, travelled * 0.6F}, float(bark_), shade_of_wood(at), 2, 0});
    }
    if (p == 0) continue;
    for (std::size_t i = 0; i + 1 < ring; ++i) {
      const std::size_t a = first + (p - 1) * ring + i;
      triangle(a, a + 1, a + ring + 1);
      triangle(a, a + ring + 1, a + ring);
    }
  }
}

void PlantMeshBuilder::stem(std::span<const glm::vec3> points, std::span<const float> radii, int sides) {
  tube(points, sides, 2, [&](std::size_t p, float) { return radii[p]; });
}

void PlantMeshBuilder::trunk(std::span<const glm::vec3> points, std::span<const float> radii, int sides, int roots) {
  // Rings close together at the foot, where it spreads.
  const float thick = radii[1];
  const glm::vec3 up = points[1] - points[0];
  std::vector<glm::vec3> rings;
  std::vector<float> widths;
  for (const float height : {-0.3F, 0.0F, 0.5F, 1.3F, 3.0F}) {
    const float part = (height * thick - points[0].z) / std::max(up.z, 0.01F);
    if (part >= 1) break;
    rings.push_back(points[0] + up * part);
    widths.push_back(glm::mix(radii[0] / 1.3F, radii[1], std::max(0.0F, part)));
  }
  const std::size_t foot = rings.size();
  rings.insert(rings.end(), points.begin() + 1, points.end());
  widths.insert(widths.end(), radii.begin() + 1, radii.end());
  const float start = random.between(0, glm::two_pi<float>());
  tube(rings, sides, std::max(2.0F, std::round(6 * thick)), [&](std::size_t p, float turn) {
    if (p >= foot) return widths[p];
    const float spread = std::exp(-std::max(0.0F, rings[p].z) / (0.75F * thick));
    return widths[p] * (1 + spread * (0.38F + 0.34F * std::cos(float(roots) * turn + start)));
  });
}

void PlantMeshBuilder::stem(const glm::vec3& from, const glm::vec3& to, float radius_from, float radius_to, int sides) {
  const std::array<glm::vec3, 2> points{from, to};
  const std::array<float, 2> radii{radius_from, radius_to};
  stem(points, radii, sides);
}

void PlantMeshBuilder::strip(std::span<const glm::vec3> points, std::span<const float> radii, const glm::vec3& facing) {
  const std::size_t first = mesh_.vertices.size();
  float travelled = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const glm::vec3 along = glm::normalize(points[std::min(p + 1, points.size() - 1)] - points[p > 0 ? p - 1 : 0]);
    const glm::vec3 across = glm::cross(along, facing);
    const glm::vec3 side = glm::length(across) > 1e-3F ? glm::normalize(across) : perpendicular(along);
    if (p > 0) travelled += glm::length(points[p] - points[p - 1]);
    for (const float s : {-1.0F, 1.0F}) {
      const glm::vec3 at = points[p] + side * s * radii[p];
      // The middle of a strip looks toward one, its edges to the sides.
      const glm::vec3 normal = glm::normalize(glm::vec3(0, 0, 0.7F) + side * s);
      mesh_.vertices.push_back({at, normal, {0.5F + 0.2F * s, travelled * 0.6F}, float(bark_), shade_of_wood(at), 2, 0});
    }
    if (p == 0) continue;
    const std::size_t a = first + 2 * (p - 1);
    triangle(a, a + 1, a + 3);
    triangle(a, a + 3, a + 2);
  }
}

CardBox card_box(LeafPicture picture) {
  switch (picture) {
    case LeafPicture::broad:
      return {{0.14F, 0}, {0.81F, 1}};
    case LeafPicture::small:
      return {{0.18F, 0}, {0.87F, 1}};
    case LeafPicture::airy:
      return {{0.18F, 0}, {0.72F, 1}};
    case LeafPicture::needles:
      return {{0.01F, 0.04F}, {0.98F, 0.98F}};
    case LeafPicture::blades:
      return {{0, 0}, {1, 0.84F}};
    case LeafPicture::rosette:
      return {{0.07F, 0}, {0.99F, 0.94F}};
    case LeafPicture::flower:
      return {{0.21F, 0}, {0.89F, 0.87F}};
    case LeafPicture::flower_head:
      return {{0.07F, 0.03F}, {0.88F, 0.97F}};
    case LeafPicture::birch_spray:
      return {{0.05F, 0}, {0.95F, 0.86F}};
    case LeafPicture::pine_spray:
      return {{0.06F, 0.04F}, {0.95F, 0.93F}};
    case LeafPicture::scale_spray:
      return {{0.17F, 0}, {0.93F, 1}};
    case LeafPicture::frond:
      return {{0.13F, 0}, {0.87F, 1}};
    default:
      return {};
  }
}

void PlantMeshBuilder::card(const FoliageCard& card, const CrownForm* bunch) {
  const std::size_t first = mesh_.vertices.size();
  const glm::vec3 right = glm::normalize(glm::cross(card.upright, card.facing));
  const glm::vec3 up = glm::cross(card.facing, right);
  const float fall = random.unit();
  // Columns from left to right; a folded card's middle stands out and its tip bends down over the rest.
  const int columns = card.fold > 0 ? 3 : 2;
  const CardBox box = card_box(card.picture);
  for (int column = 0; column < columns; ++column) {
    const float u = column == 0 ? box.low.x : column == columns - 1 ? box.high.x : 0.5F;
    const float out = columns == 3 && column == 1 ? card.fold * card.width : 0.0F;
    for (const float v : {box.low.y, box.high.y}) {
      const glm::vec3 at = card.centre + right * ((u - 0.5F) * card.width) + up * ((v - 0.5F) * card.height) +
                           card.facing * (out - 0.7F * card.fold * card.height * v);
      const glm::vec3 faces = glm::normalize(card.facing + right * (card.fold * 3 * (u - 0.5F)));
      mesh_.vertices.push_back({at, soft_normal(at, faces, bunch), {u, v}, float(card.picture), openness(at, bunch), fall, 1});
    }
    if (column == 0) continue;
    const std::size_t a = first + 2 * (std::size_t(column) - 1);
    triangle(a, a + 2, a + 3);
    triangle(a, a + 3, a + 1);
  }
}

void PlantMeshBuilder::bunch(const CrownForm& form, int cards, float size, LeafPicture picture, float roughness, float fold) {
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
    leaf.fold = fold;
    card(leaf, &form);
  }
}

void PlantMeshBuilder::blade(const glm::vec3& foot, const glm::vec3& knee, const glm::vec3& tip, float width, float shade) {
  const std::size_t first = mesh_.vertices.size();
  const glm::vec3 along = tip - foot;
  const glm::vec3 level(along.y, -along.x, 0);
  const glm::vec3 side = glm::length(level) > 1e-4F ? glm::normalize(level) : glm::vec3(1, 0, 0);
  const float own = random.unit();
  // One place of a picture without holes: a shade of its own for every blade.
  const glm::vec2 uv(own, random.unit());
  const auto add = [&](const glm::vec3& at, float light) {
    mesh_.vertices.push_back({at, glm::vec3(0, 0, 1), uv, float(LeafPicture::bark), shade * light, own, 1});
  };
  add(foot - side * width * 0.5F, 0.42F);
  add(foot + side * width * 0.5F, 0.42F);
  add(knee - side * width * 0.42F, 0.8F);
  add(knee + side * width * 0.42F, 0.8F);
  add(tip, 1);
  triangle(first, first + 1, first + 3);
  triangle(first, first + 3, first + 2);
  triangle(first + 2, first + 3, first + 4);
}

void PlantMeshBuilder::boulder(const glm::vec3& radii, int around, int rings) {
  const std::size_t first = mesh_.vertices.size();
  const std::size_t row = std::size_t(around) + 1;
  // A few planes cut its corners off.
  std::array<glm::vec3, 7> planes;
  std::array<float, 7> away{};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    planes[i] = random.direction();
    away[i] = random.between(0.62F, 0.9F);
  }
  for (int ring = 0; ring <= rings; ++ring) {
    const float polar = glm::pi<float>() * (0.02F + 0.66F * float(ring) / float(rings));
    for (std::size_t i = 0; i < row; ++i) {
      const float turn = glm::two_pi<float>() * float(i) / float(around);
      const glm::vec3 out(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
      float reach = 1;
      glm::vec3 normal = out;
      for (std::size_t p = 0; p < planes.size(); ++p) {
        const float facing = glm::dot(out, planes[p]);
        if (facing <= 0.05F || away[p] / facing >= reach) continue;
        reach = away[p] / facing;
        normal = glm::normalize(planes[p] + 0.35F * out);
      }
      const glm::vec3 at = out * reach * radii;
      const float open = glm::clamp(0.45F + 0.8F * at.z / radii.z, 0.3F, 1.0F);
      mesh_.vertices.push_back({at, normal, {2 * float(i) / float(around), polar * 0.6F}, float(bark_), open, 2, 0});
    }
    if (ring == 0) continue;
    for (std::size_t i = 0; i + 1 < row; ++i) {
      const std::size_t a = first + (std::size_t(ring) - 1) * row + i;
      triangle(a, a + 1, a + row + 1);
      triangle(a, a + row + 1, a + row);
    }
  }
}

PlantMesh make_plant_mesh(const PlantShape& shape, PlantDetail detail, std::uint64_t seed) {
  const std::string& model = shape.model;
  if (model == "conifer") return shape.trunk_fraction > 0.25F ? pine_mesh(shape, detail, seed) : spruce_mesh(shape, detail, seed);
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
