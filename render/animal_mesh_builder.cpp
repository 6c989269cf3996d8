#include "render/animal_mesh_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace biotope {

int AnimalMeshBuilder::sides(int fine) const {
  if (detail_ == AnimalDetail::fine) return fine;
  if (detail_ == AnimalDetail::plain) return std::max(3, (fine + 1) / 2);
  return fine >= 10 ? 4 : 3;
}

void AnimalMeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
}

/// Normals of the part that was added last: the mean of its faces', turned outward as a whole.
void AnimalMeshBuilder::smooth(std::size_t first_vertex, std::size_t first_index) {
  for (std::size_t v = first_vertex; v < mesh_.vertices.size(); ++v) mesh_.vertices[v].normal = glm::vec3(0);
  double volume = 0;
  for (std::size_t i = first_index; i + 2 < mesh_.indices.size(); i += 3) {
    AnimalVertex& a = mesh_.vertices[mesh_.indices[i]];
    AnimalVertex& b = mesh_.vertices[mesh_.indices[i + 1]];
    AnimalVertex& c = mesh_.vertices[mesh_.indices[i + 2]];
    const glm::vec3 face = glm::cross(b.position - a.position, c.position - a.position);
    for (AnimalVertex* vertex : {&a, &b, &c}) vertex->normal += face;
    volume += double(glm::dot(a.position - mesh_.vertices[first_vertex].position, face));
  }
  const float side = volume >= 0 ? 1.0F : -1.0F;
  for (std::size_t v = first_vertex; v < mesh_.vertices.size(); ++v) {
    glm::vec3& normal = mesh_.vertices[v].normal;
    const float size = glm::length(normal);
    normal = size > 1e-12F ? normal * (side / size) : glm::vec3(0, 0, 1);
  }
}

void AnimalMeshBuilder::loft(std::span<const BodySection> sections, int around, RimColour colour, const void* paint) {
  const std::size_t first_vertex = mesh_.vertices.size();
  const std::size_t first_index = mesh_.indices.size();
  const auto corners = std::uint32_t(around);
  const auto rim = [&](const BodySection& section, float height) {
    return colour ? colour(paint, section, height) : section.colour;
  };
  for (const BodySection& section : sections) {
    const glm::vec3 middle = 0.5F * (section.top + section.bottom);
    const glm::vec3 up = 0.5F * (section.top - section.bottom);
    for (int s = 0; s < around; ++s) {
      const float angle = 2 * std::numbers::pi_v<float> * float(s) / float(around) + std::numbers::pi_v<float> * 0.5F;
      const float height = std::sin(angle);
      mesh_.vertices.push_back({middle + up * height + glm::vec3(0, std::cos(angle) * section.width, 0), glm::vec3(0),
                                rim(section, height), section.rig});
    }
  }
  for (std::uint32_t i = 0; i + 1 < sections.size(); ++i) {
    for (std::uint32_t s = 0; s < corners; ++s) {
      const auto a = std::uint32_t(first_vertex) + i * corners + s;
      const auto b = std::uint32_t(first_vertex) + i * corners + (s + 1) % corners;
      triangle(a, b, a + corners);
      triangle(b, b + corners, a + corners);
    }
  }
  // Ends: a fan about the section's middle.
  for (const bool last : {false, true}) {
    const BodySection& section = last ? sections.back() : sections.front();
    const auto ring = std::uint32_t(first_vertex + (last ? (sections.size() - 1) * std::size_t(around) : 0));
    const auto centre = std::uint32_t(mesh_.vertices.size());
    mesh_.vertices.push_back({0.5F * (section.top + section.bottom), glm::vec3(0), rim(section, 0), section.rig});
    for (std::uint32_t s = 0; s < corners; ++s) {
      const std::uint32_t next = (s + 1) % corners;
      if (last)
        triangle(ring + s, ring + next, centre);
      else
        triangle(ring + next, ring + s, centre);
    }
  }
  smooth(first_vertex, first_index);
}

void AnimalMeshBuilder::limb(std::span<const Joint> joints, int around) {
  const std::size_t first_vertex = mesh_.vertices.size();
  const std::size_t first_index = mesh_.indices.size();
  const auto corners = std::uint32_t(around);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    const glm::vec3 before = joints[i == 0 ? 0 : i - 1].at;
    const glm::vec3 after = joints[std::min(i + 1, joints.size() - 1)].at;
    const glm::vec3 along = glm::normalize(after - before + glm::vec3(0, 0, 1e-7F));
    const glm::vec3 reference = std::abs(along.y) > 0.8F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 side = glm::normalize(reference - along * glm::dot(reference, along));
    const glm::vec3 other = glm::cross(along, side);
    for (int s = 0; s < around; ++s) {
      const float angle = 2 * std::numbers::pi_v<float> * (float(s) + 0.25F) / float(around);
      const glm::vec3 out = side * std::cos(angle) + other * (std::sin(angle) * joint.stretch);
      mesh_.vertices.push_back({joint.at + out * joint.radius, glm::vec3(0), joint.colour, joint.rig});
    }
  }
  for (std::uint32_t i = 0; i + 1 < joints.size(); ++i) {
    for (std::uint32_t s = 0; s < corners; ++s) {
      const auto a = std::uint32_t(first_vertex) + i * corners + s;
      const auto b = std::uint32_t(first_vertex) + i * corners + (s + 1) % corners;
      triangle(a, b, a + corners);
      triangle(b, b + corners, a + corners);
    }
  }
  if (detail_ != AnimalDetail::silhouette) {
    const auto centre = std::uint32_t(mesh_.vertices.size());
    const auto ring = std::uint32_t(first_vertex + (joints.size() - 1) * std::size_t(around));
    mesh_.vertices.push_back({joints.back().at, glm::vec3(0), joints.back().colour, joints.back().rig});
    for (std::uint32_t s = 0; s < corners; ++s) triangle(ring + s, ring + (s + 1) % corners, centre);
  }
  smooth(first_vertex, first_index);
}

void AnimalMeshBuilder::ball(glm::vec3 centre, float radius, glm::vec3 colour, glm::vec4 rig) {
  // Rings of six about its upright axis.
  const auto ring = [&](float height) {
    const float lift = radius * height;
    const float wide = radius * std::sqrt(1 - height * height);
    return Joint{centre + glm::vec3(0, 0, lift), wide, colour, rig, 1};
  };
  const std::array<Joint, 4> joints{ring(-0.94F), ring(-0.4F), ring(0.4F), ring(0.94F)};
  limb(joints, 6);
}

AnimalMesh AnimalMeshBuilder::take() { return std::move(mesh_); }

}  // namespace biotope
