#pragma once

#include <array>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/background_thread.hpp"
#include "core/movement/herd_simulation.hpp"
#include "core/pipeline/maps_snapshot.hpp"
#include "render/animal_mesh.hpp"
#include "render/animal_pick.hpp"
#include "render/animal_surroundings.hpp"
#include "render/animal_wading.hpp"
#include "render/frame.hpp"
#include "render/gl_objects.hpp"
#include "render/landscape_renderer.hpp"
#include "render/line_field.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"
#include "render/terrain_renderer.hpp"

namespace biotope {

/// Draws the animals of every herd near the eye at their place on the clock, each species with its own mesh: herds within some
/// hundred metres as boids, the others at their guides.
class AnimalRenderer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<AnimalRenderer>> create();

  /// Takes what animals move on; `shore` (may be null) tells where water is drawn, `trees` (without a snapshot: none) where
  /// trunks stand. Call before draw and animal; costs nothing when nothing changed. Herds around which nothing changed go on.
  /// Unless it has to be `at_once`, another thread finds where the herds are now, and until it has animals stay where they were;
  /// in another landscape there are none until then.
  void set_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore, const PlantPlacement& trees, bool at_once);
  /// Whether animals are where the last world has them.
  [[nodiscard]] bool settled() const { return change_ == nullptr && !behind_; }
  /// Places the animals of an hour that the camera sees (where they may lag, those of another hour only once they are found), and
  /// those whose shadows `light` (may be null) sees. `surface` is the ground as it is drawn; animals stand on it. Call before the
  /// draws of a frame.
  void prepare(const MapsSnapshot& maps, const LandscapeOptions& options, const glm::dvec3& eye, const Frustum& frustum,
               const Grid<float>& surface, const ShadowView* light);
  /// Where shadows of those that were prepared fall into a cascade.
  [[nodiscard]] const ShadowBox& shadow_box(int cascade) const { return shadow_boxes_[std::size_t(cascade)]; }
  /// Draws those that throw shadows into a cascade of the ShadowMap that is open.
  DrawCount draw_shadows(int cascade) const;
  /// Draws what was prepared; `shadows`: with those of the ShadowMap that is bound.
  DrawCount draw(const LandscapeOptions& options, bool shadows) const;

  /// The animals that were prepared.
  [[nodiscard]] std::span<const AnimalAt> drawn() const { return drawn_; }
  [[nodiscard]] std::optional<AnimalAt> animal(int plan, int member, double hour, const Grid<float>& surface);

  /// Memory of the simulated runs of herds, and the most that is kept.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] static std::size_t most_bytes() { return HerdSimulation::most_bytes; }

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
    glm::vec4 winter{0, 0, 1, 0};
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
    SkeletonUniforms uniforms;
    Buffer skeleton_buffer;
    AnimalSkeleton skeleton;
    float female_headgear = 0;
    float spots = 0;
    VertexArray shade_array;
    Buffer shade_instances;
  };

  /// What was prepared last.
  struct Look {
    LandscapeOptions options;
    glm::dvec3 eye{0};
  };
  /// Herds as they were placed last.
  struct Placed {
    std::vector<HerdRequest> requests;
    std::vector<std::vector<HerdAnimal>> herds;
    /// What they were placed for; nothing before the first time.
    std::optional<Look> look;
    [[nodiscard]] std::size_t animals() const;
  };
  /// A change of the world, or only of the look, in the hands of another thread, and with it the simulation.
  struct Change {
    /// Of the look alone: what was found.
    std::optional<Placed> placed;
    std::shared_ptr<const ShoreMap> shore;
    std::shared_ptr<const AnimalSurroundings> surroundings;
    std::shared_ptr<const HerdWorld> world;
    /// A new one, where that of before cannot go on.
    std::unique_ptr<HerdSimulation> simulation;
    /// The herds in the new world, as they were looked at last.
    Placed arrived;
    std::future<void> done;
  };

  AnimalRenderer() = default;
  [[nodiscard]] bool moves_on(const MapsSnapshot& maps, bool same_details) const;
  /// Takes over what a change has found; false where it is still at it and need not be waited for.
  bool finish_change(bool wait);
  void change_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore, const PlantPlacement& trees,
                    bool same_details);
  /// Whether herds are far in time from where they were placed: it takes minutes of their simulation.
  [[nodiscard]] bool leaps_to(const Look& look) const;
  /// Places the herds of a look, or in a window has another thread do it where that takes long (far in time, or so many that they
  /// are always a picture behind); until it has they stay where they were.
  void place_herds(const Look& look);
  void place_elsewhere(const Look& look);
  [[nodiscard]] static Placed placed_herds(HerdSimulation& simulation, const HerdWorld& world, const Look& look);
  /// Has another thread free the animals' world.
  void retire_world();
  void make_models(const FoodWeb& web);
  void make_model(const AnimalMesh& mesh, Model& model) const;
  void make_shade(SpeciesModels& species) const;
  [[nodiscard]] static SkeletonUniforms skeleton_uniforms(const AnimalShape& shape, const AnimalBuild& build,
                                                          const AnimalSkeleton& skeleton);
  /// Gives every species the coat of a month (0: January on the northern hemisphere).
  void set_month(int month);
  [[nodiscard]] float headgear(const AnimalAt& at) const;
  /// Herds that may be in sight, and how near they are.
  [[nodiscard]] static std::vector<HerdRequest> herds_near(const HerdWorld& world, const Look& look);
  void place(const HerdAnimal& animal, int plan, int member, const Grid<float>& surface, AnimalAt& at) const;
  /// Height that an animal's feet are at, under whatever water is drawn.
  [[nodiscard]] double feet_height(const Grid<float>& surface, glm::dvec2 place, double shoulder) const;
  [[nodiscard]] Instance instance(const HerdAnimal& animal, const AnimalAt& at, const Grid<float>& surface,
                                  const glm::dvec3& eye) const;
  [[nodiscard]] std::array<bool, shadow_cascades> casts_of(const glm::vec3& centre, float radius, const ShadowView* light);
  DrawCount draw_shades(double quality, float strength) const;

  std::shared_ptr<const FoodWeb> web_;
  /// Of the coats that are shown; none yet below 0.
  int month_ = -1;
  std::vector<SpeciesModels> species_;
  std::shared_ptr<const HerdWorld> world_;
  std::shared_ptr<const ShoreMap> shore_;
  std::shared_ptr<const AnimalSurroundings> surroundings_;
  AnimalWading wading_;
  std::unique_ptr<HerdSimulation> simulation_;
  std::optional<Look> looked_;
  Placed placed_;
  /// Whether animals may stay where they were for some pictures.
  bool may_lag_ = false;
  std::size_t bytes_ = 0;
  std::unique_ptr<Change> change_;
  /// Whether there is a newer world than the one that is shown or being changed to.
  bool behind_ = false;
  std::vector<AnimalAt> drawn_;
  /// By species: those in sight, by level of detail, and those that throw shadows into each cascade.
  std::vector<std::array<std::vector<Instance>, levels_of_detail>> seen_;
  std::vector<std::array<std::vector<Instance>, shadow_cascades>> casting_;
  std::array<ShadowBox, shadow_cascades> shadow_boxes_{};
  ShaderProgram near_;
  ShaderProgram shadowed_;
  ShaderProgram caster_;
  ShaderProgram far_;
  ShaderProgram shade_;
  Buffer shade_corners_;
  BackgroundThread thread_;
};

}  // namespace biotope
