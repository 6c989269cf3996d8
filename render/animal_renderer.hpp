#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/movement/herd_simulation.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "render/animal_mesh.hpp"
#include "render/animal_pick.hpp"
#include "render/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/landscape_renderer.hpp"
#include "render/line_field.hpp"
#include "render/shader_program.hpp"
#include "render/terrain_renderer.hpp"

namespace biotope {

/// Draws the animals of every herd near the eye at their place on the clock, each species with its own mesh: herds within some
/// hundred metres as boids, the others at their guides.
class AnimalRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<AnimalRenderer>> create();

  /// Takes what animals move on; `shore` (may be null) tells where water is drawn. Call before draw and animal; costs nothing
  /// when nothing changed.
  void set_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore);
  /// `surface` is the ground as it is drawn; animals stand on it. Returns what was drawn; `drawn_animals` is increased by their
  /// number.
  DrawCount draw(const MapsSnapshot& maps, const LandscapeOptions& options, const glm::dvec3& eye, const Frustum& frustum,
                 const Grid<float>& surface, std::size_t& drawn_animals);

  /// The animals of the last draw.
  [[nodiscard]] std::span<const AnimalAt> drawn() const { return drawn_; }
  [[nodiscard]] std::optional<AnimalAt> animal(const MapsSnapshot& maps, int plan, int member, double hour,
                                               const Grid<float>& surface);

 private:
  static constexpr int levels_of_detail = 3;
  /// One animal as the shader reads it (shaders/landscape/animal_rig.glsl).
  struct Instance {
    glm::vec4 place;   ///< relative to the eye; w: size
    glm::vec4 motion;  ///< sine and cosine of the heading, strides walked, length of a stride at the species' size
    glm::vec4 pose;    ///< head down, lying, alarm, gait
    glm::vec4 stand;   ///< rise of the ground ahead and to the left, shade of the coat, headgear
  };
  /// Uniform block `Skeleton`.
  struct SkeletonUniforms {
    std::array<glm::vec4, 12> joints{};
    glm::vec4 neck_head{0};
    glm::vec4 graze{0};
    glm::vec4 body{0};
    glm::vec4 look{0};
  };
  struct Model {
    VertexArray array;
    Buffer vertices;
    Buffer indices;
    Buffer instances;
    GLsizei index_count = 0;
  };
  struct SpeciesModels {
    std::array<Model, levels_of_detail> models;
    Buffer skeleton_buffer;
    AnimalSkeleton skeleton;
    float female_headgear = 0;
    VertexArray shade_array;
    Buffer shade_instances;
  };

  AnimalRenderer() = default;
  void make_models(const FoodWeb& web);
  [[nodiscard]] std::vector<HerdRequest> herds_near(const LandscapeOptions& options, const glm::dvec3& eye) const;
  void place(const MapsSnapshot& maps, const HerdAnimal& animal, int plan, int member, const Grid<float>& surface,
             AnimalAt& at) const;
  [[nodiscard]] Instance instance(const HerdAnimal& animal, const AnimalAt& at, const MapsSnapshot& maps,
                                  const Grid<float>& surface, const glm::dvec3& eye) const;
  DrawCount draw_shades(const std::vector<std::array<std::vector<Instance>, levels_of_detail>>& instances, double quality);

  std::shared_ptr<const FoodWeb> web_;
  std::vector<SpeciesModels> species_;
  std::shared_ptr<const HerdWorld> world_;
  std::shared_ptr<const ShoreMap> shore_;
  std::unique_ptr<HerdSimulation> simulation_;
  std::vector<AnimalAt> drawn_;
  ShaderProgram near_;
  ShaderProgram far_;
  ShaderProgram shade_;
  Buffer shade_corners_;
};

}  // namespace biotope
