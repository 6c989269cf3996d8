#pragma once

#include "core/base/status.hpp"
#include "render/plant_renderer.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"

namespace biotope {

/// Draws trees and shrubs as the light sees them: near the eye their meshes, farther away their far pictures turned toward the
/// light, whose outline is that of the shadow.
class PlantShadows {
 public:
  [[nodiscard]] static Result<PlantShadows> create();
  /// Draws the plants of a renderer that was prepared for this frame into a cascade that is open. The uniform block of the frame
  /// must be bound.
  DrawCount draw(const PlantRenderer& plants, const SpeciesVisibility& visible, const glm::dvec3& eye, const ShadowView& view,
                 int cascade) const;

 private:
  DrawCount draw_meshes(const PlantRenderer& plants, const SpeciesVisibility& visible, const glm::dvec3& eye,
                        const ShadowView& view) const;
  DrawCount draw_pictures(const PlantRenderer& plants, const glm::dvec3& eye, const ShadowView& view, int cascade) const;

  ShaderProgram mesh_;
  ShaderProgram picture_;
  Buffer instances_;
  Buffer draws_;
  VertexArray array_;
};

}  // namespace biotope
