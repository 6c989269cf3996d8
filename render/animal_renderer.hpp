#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/pipeline/maps_snapshot.hpp"
#include "render/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/landscape_renderer.hpp"
#include "render/shader_program.hpp"
#include "render/terrain_renderer.hpp"

namespace biotope {

/// Draws the animals of every herd near the eye at their place on the clock, each species with its own mesh.
class AnimalRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<AnimalRenderer>> create();

  /// `surface` is the ground as it is drawn; animals stand on it. Returns what was drawn; `drawn_animals` is increased by their number.
  DrawCount draw(const MapsSnapshot& maps, const LandscapeOptions& options, const glm::dvec3& eye, const Frustum& frustum,
                 const Grid<float>& surface, std::size_t& drawn_animals);

 private:
  static constexpr int levels_of_detail = 3;
  struct Model {
    VertexArray array;
    Buffer vertices;
    Buffer indices;
    Buffer instances;
    GLsizei index_count = 0;
  };
  struct SpeciesModels {
    std::array<Model, levels_of_detail> models;
  };
  /// One animal as the shader reads it.
  struct Instance {
    glm::vec4 place;   ///< relative to the eye; w: size
    glm::vec4 motion;  ///< sine and cosine of the heading, phase of the stride, speed
    glm::vec4 pose;    ///< head down, pitch of the ground, shade of the coat, 0
  };

  AnimalRenderer() = default;
  void make_models(const FoodWeb& web);

  std::shared_ptr<const FoodWeb> web_;
  std::vector<SpeciesModels> species_;
  ShaderProgram program_;
};

}  // namespace biotope
