#include <algorithm>
#include <cmath>

#include "render/animal_renderer.hpp"
#include "render/animal_season.hpp"

namespace biotope {

namespace {

constexpr std::array<AnimalDetail, 3> details{AnimalDetail::fine, AnimalDetail::plain, AnimalDetail::silhouette};

/// What each animal brings, in the places that the shaders read: 16 floats.
void instance_attributes(const VertexArray& array) {
  glVertexArrayBindingDivisor(array.name(), 1, 1);
  for (GLuint i = 0; i < 4; ++i) float_attribute(array, 4 + i, 1, 4, GLuint(i * sizeof(glm::vec4)));
}

}  // namespace

AnimalRenderer::SkeletonUniforms AnimalRenderer::skeleton_uniforms(const AnimalShape& shape, const AnimalBuild& build,
                                                                   const AnimalSkeleton& skeleton) {
  SkeletonUniforms uniforms;
  for (std::size_t leg = 0; leg < 4; ++leg) {
    uniforms.joints[3 * leg] = glm::vec4(skeleton.legs[leg].hip, 0);
    uniforms.joints[3 * leg + 1] = glm::vec4(skeleton.legs[leg].knee, 0);
    uniforms.joints[3 * leg + 2] = glm::vec4(skeleton.legs[leg].foot, 0);
  }
  uniforms.neck_head = {skeleton.neck.x, skeleton.neck.z, skeleton.head.x, skeleton.head.z};
  uniforms.graze = {skeleton.graze_neck, skeleton.graze_head, skeleton.graze_pitch, skeleton.lie_drop};
  uniforms.body = {skeleton.hip_height, skeleton.tail.x, skeleton.tail.z, shape.shoulder_height};
  uniforms.look = {build.spots, 0.62F * build.trunk * shape.shoulder_height, 1.25F * build.belly_width * shape.shoulder_height,
                   0};
  return uniforms;
}

void AnimalRenderer::make_model(const AnimalMesh& mesh, Model& model) const {
  model.vertices = make_static_buffer(std::as_bytes(std::span(mesh.vertices)));
  model.indices = make_static_buffer(std::as_bytes(std::span(mesh.indices)));
  model.instances = make_buffer();
  model.index_count = GLsizei(mesh.indices.size());
  model.array = make_vertex_array();
  glVertexArrayElementBuffer(model.array.name(), model.indices.name());
  glVertexArrayVertexBuffer(model.array.name(), 0, model.vertices.name(), 0, sizeof(AnimalVertex));
  glVertexArrayVertexBuffer(model.array.name(), 1, model.instances.name(), 0, sizeof(Instance));
  float_attribute(model.array, 0, 0, 3, offsetof(AnimalVertex, position));
  float_attribute(model.array, 1, 0, 3, offsetof(AnimalVertex, normal));
  float_attribute(model.array, 2, 0, 3, offsetof(AnimalVertex, colour));
  float_attribute(model.array, 3, 0, 4, offsetof(AnimalVertex, rig));
  instance_attributes(model.array);
}

void AnimalRenderer::make_shade(SpeciesModels& species) const {
  species.shade_instances = make_buffer();
  species.shade_array = make_vertex_array();
  glVertexArrayVertexBuffer(species.shade_array.name(), 0, shade_corners_.name(), 0, sizeof(glm::vec2));
  glVertexArrayVertexBuffer(species.shade_array.name(), 1, species.shade_instances.name(), 0, sizeof(Instance));
  float_attribute(species.shade_array, 0, 0, 2, 0);
  instance_attributes(species.shade_array);
}

void AnimalRenderer::make_models(const FoodWeb& web) {
  static_assert(sizeof(Instance) == 4 * sizeof(glm::vec4));
  species_.clear();
  species_.resize(web.species.size());
  month_ = -1;
  for (std::size_t s = 0; s < web.species.size(); ++s) {
    if (web.species[s].is_plant()) continue;
    const AnimalShape& shape = web.species[s].animal().shape;
    const AnimalBuild build = animal_build(shape, web.species[s].scientific_name);
    SpeciesModels& species = species_[s];
    species.skeleton = animal_skeleton(shape, build);
    species.female_headgear = build.female_headgear;
    species.spots = build.spots;
    species.uniforms = skeleton_uniforms(shape, build, species.skeleton);
    for (std::size_t level = 0; level < details.size(); ++level) {
      make_model(make_animal_mesh(shape, web.species[s].scientific_name, details[level]), species.models[level]);
    }
    make_shade(species);
  }
}

void AnimalRenderer::set_month(int month) {
  if (month_ == month) return;
  month_ = month;
  for (std::size_t s = 0; s < species_.size(); ++s) {
    if (web_->species[s].is_plant()) continue;
    const AnimalCoat coat = animal_coat(web_->species[s].scientific_name, month);
    SpeciesModels& species = species_[s];
    species.uniforms.winter = {coat.grey, coat.pale, coat.shade, coat.hair * species.uniforms.body.w};
    species.uniforms.look.x = species.spots * coat.spots;
    species.uniforms.look.w = coat.young_spots;
    species.skeleton_buffer = make_static_buffer(std::as_bytes(std::span(&species.uniforms, 1)));
  }
}

}  // namespace biotope
