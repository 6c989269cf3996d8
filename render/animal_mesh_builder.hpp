#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/animal_mesh.hpp"

namespace biotope {

/// A cross-section of a body or limb: an ellipse from `top` to `bottom` (in the plane of symmetry of its part), `width` to either
/// side.
struct BodySection {
  glm::vec3 top;
  glm::vec3 bottom;
  float width;
  glm::vec4 rig{0};
  glm::vec3 colour{0.5F};
};

/// Colour of a point of a section's rim: `height` -1 at the bottom .. 1 at the top.
using RimColour = glm::vec3 (*)(const void* paint, const BodySection& section, float height);

/// Sections of a part by its corners around, and how many of its sections are left out.
class AnimalMeshBuilder {
 public:
  explicit AnimalMeshBuilder(AnimalDetail detail) : detail_(detail) {}

  [[nodiscard]] AnimalDetail detail() const { return detail_; }
  /// Corners around a limb that has `fine` of them at the finest detail.
  [[nodiscard]] int sides(int fine) const;

  /// Joins sections by a skin that is closed at both ends. Normals are those of the skin.
  void loft(std::span<const BodySection> sections, int sides, RimColour colour = nullptr, const void* paint = nullptr);
  /// A tapering limb through points, round, of one colour each.
  struct Joint {
    glm::vec3 at;
    float radius;
    glm::vec3 colour;
    glm::vec4 rig{0};
    float stretch = 1;  ///< of the radius in the plane of symmetry
  };
  void limb(std::span<const Joint> joints, int sides);
  /// A small ball.
  void ball(glm::vec3 centre, float radius, glm::vec3 colour, glm::vec4 rig);

  [[nodiscard]] AnimalMesh take();

 private:
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void smooth(std::size_t first_vertex, std::size_t first_index);

  AnimalDetail detail_;
  AnimalMesh mesh_;
};

}  // namespace biotope
