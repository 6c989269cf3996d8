#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "render/gl_objects.hpp"
#include "render/ground_maps.hpp"
#include "render/plant_mesh.hpp"
#include "render/plant_model_maker.hpp"
#include "render/plant_placement.hpp"
#include "render/shader_program.hpp"
#include "render/texel_upload.hpp"

namespace biotope {

/// Texture units of the plants' pictures.
inline constexpr GLuint leaves_unit = 8;
inline constexpr GLuint far_pictures_unit = 9;
inline constexpr GLuint far_surfaces_unit = 10;
/// Uniform block of what the shaders know of every kind.
inline constexpr GLuint kinds_binding = 1;
[[nodiscard]] inline int model_of(const PlantInstance& plant) {
  const float scaled = plant.tint * 61.0F;
  return int((scaled - std::floor(scaled)) * float(plant_models));
}

/// While it lives, drawing goes to another framebuffer with a viewport of that size; the framebuffer and viewport of before come
/// back with its end.
class DrawnElsewhere {
 public:
  DrawnElsewhere(int width, int height) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_VIEWPORT, viewport_.data());
    glViewport(0, 0, width, height);
  }
  ~DrawnElsewhere() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }
  DrawnElsewhere(const DrawnElsewhere&) = delete;
  DrawnElsewhere& operator=(const DrawnElsewhere&) = delete;

 private:
  GLint framebuffer_ = 0;
  std::array<GLint, 4> viewport_{};
};

/// A mesh on the graphics side.
struct PlantMeshBuffers {
  Buffer vertices;
  Buffer indices;  ///< in all orders of plant_mesh_order.hpp
  VertexArray array;
  GLsizei index_count = 0;  ///< of one order
};
/// Uploads a mesh; binding 1 of its array takes PlantInstance per instance (attributes 4 and 5).
[[nodiscard]] PlantMeshBuffers upload(const OrderedMesh& mesh);
/// Declares PlantInstance at binding 1.
void instance_attributes(const VertexArray& array);

/// One species of plant, ready to draw.
struct PlantKind {
  int species = 0;  ///< number in the web; -1 for undergrowth
  Stratum stratum = Stratum::herb;
  PlantShape shape;
  glm::vec3 wood{0};       ///< linear colour of its bark
  glm::vec3 high_wood{0};  ///< and of that of its upper half
  PlantExtent extent;      ///< of the larger of its models
  std::array<PlantMeshBuffers, plant_models> close;
  std::array<PlantMeshBuffers, plant_models> near;
  std::array<PlantMeshBuffers, plant_models> mid;
  SeasonalFoliage foliage;  ///< of the month drawn
  float bloom = 0;          ///< share of plants in flower
  bool pictured = false;    ///< its far pictures show that foliage
};

/// Colours of a kind's wood for the programs plant_mesh and plant_bake.
void set_wood(const ShaderProgram& program, const PlantKind& kind);
/// Flowers of a kind for the program plant_tuft.
void set_flowers(const ShaderProgram& program, const PlantKind& kind);

/// The plants of a web and their pictures from afar (impostors): every woody kind seen from three heights, as colour and as
/// surface (normal and openness). Pictures are taken again when the month changes.
class PlantKinds {
 public:
  [[nodiscard]] static Result<PlantKinds> create();
  /// Takes the models of a web's plants in; until upload() has brought all of them to the graphics side those of before are
  /// drawn.
  void take(std::shared_ptr<const PlantModels> models);
  /// Uploads models that were taken in, as much as the budget leaves. True when those taken in last are the ones drawn.
  bool upload(UploadBudget& budget);
  /// Colours and pictures of a month.
  void set_month(const FoodWeb& web, int month);
  /// Plants of other species are not drawn from afar and cast no shade. True when that is a change.
  bool set_visible(const SpeciesVisibility& visible);

  [[nodiscard]] const std::vector<PlantKind>& kinds() const { return kinds_; }
  /// By Undergrowth: its mesh is near[0].
  [[nodiscard]] const std::vector<PlantKind>& undergrowth() const { return undergrowth_; }
  /// Below medium quality pictures take the nearest of their mipmaps.
  void set_quality(float quality) const;
  /// Binds leaf pictures, far pictures and what the shaders know of kinds.
  void bind() const;
  /// Only the last of these.
  void bind_kinds() const { glBindBufferBase(GL_UNIFORM_BUFFER, kinds_binding, uniforms_.name()); }
  [[nodiscard]] static int picture_side() { return 128; }

 private:
  void make_undergrowth();
  void upload_kind(std::size_t kind);
  void make_far_pictures();
  void upload_kinds();
  void take_pictures();
  void take_picture(const PlantKind& kind, int model, float elevation) const;

  ShaderProgram bake_;
  Texture leaves_;
  Texture far_pictures_;
  Texture far_surfaces_;
  Buffer uniforms_;
  std::shared_ptr<const PlantModels> coming_;
  /// Those of them that are uploaded.
  std::vector<PlantKind> coming_kinds_;
  std::vector<PlantKind> kinds_;
  std::vector<PlantKind> undergrowth_;
  SpeciesVisibility visible_;
  int month_ = -1;
};

}  // namespace biotope
