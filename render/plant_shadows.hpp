#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "core/base/status.hpp"
#include "render/plant_renderer.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"

namespace biotope {

/// What plants throw shadows, and when.
struct PlantShadowLook {
  std::shared_ptr<const FoodWeb> web;
  SpeciesVisibility visible;
  int month = 0;
  glm::dvec3 eye{0};
  /// m/s to the east and to the north, and seconds of what moves.
  glm::dvec3 wind{0};
};

/// All that a cascade's picture of plants follows from: equal ones are the same picture to the bit, whatever eye it was drawn
/// for.
struct PlantShadowPicture {
  /// A block of plants whose shadows fall into it.
  struct Block {
    Stratum stratum = Stratum::tree;
    int row = 0;
    int column = 0;
    std::uint32_t version = 0;
    bool operator==(const Block&) const = default;
  };
  /// The square, as ShadowCascade has it.
  int cascade = 0;
  ShadowLight light;
  float half_side = 0;
  glm::vec3 origin{0};
  glm::vec3 from_origin{0};
  std::shared_ptr<const FoodWeb> web;
  SpeciesVisibility visible;
  int month = 0;
  /// Nothing where leaves do not move in it.
  glm::vec3 wind{0};
  bool meshes = false;
  std::vector<Block> blocks;
  bool operator==(const PlantShadowPicture&) const = default;
};

/// What the picture of a cascade is of, with plants that were prepared for this frame.
[[nodiscard]] PlantShadowPicture shadow_picture(const PlantRenderer& plants, const PlantShadowLook& look, const ShadowView& view,
                                                int cascade);

/// Draws trees and shrubs as the light sees them: near the eye their meshes, farther away their far pictures turned toward the
/// light, whose outline is that of the shadow.
class PlantShadows {
 public:
  [[nodiscard]] static Result<PlantShadows> create();
  /// Draws a picture into a cascade that is open. The uniform block of the frame and the ShadowMap must be bound.
  DrawCount draw(const PlantRenderer& plants, const PlantShadowPicture& picture) const;

 private:
  DrawCount draw_meshes(const PlantRenderer& plants, const PlantShadowPicture& picture) const;
  DrawCount draw_pictures(const PlantRenderer& plants, const PlantShadowPicture& picture) const;

  ShaderProgram mesh_;
  ShaderProgram picture_;
  Buffer instances_;
  Buffer draws_;
  VertexArray array_;
};

}  // namespace biotope
