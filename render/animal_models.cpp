#include <algorithm>
#include <cmath>

#include "render/animal_renderer.hpp"

namespace biotope {

namespace {

constexpr std::array<AnimalDetail, 3> details{AnimalDetail::fine, AnimalDetail::plain, AnimalDetail::silhouette};

}  // namespace

void AnimalRenderer::make_models(const FoodWeb& web) {
  species_.clear();
  species_.resize(web.species.size());
  for (std::size_t s = 0; s < web.species.size(); ++s) {
    if (web.species[s].is_plant()) continue;
    const AnimalShape& shape = web.species[s].animal().shape;
    const AnimalBuild build = animal_build(shape, web.species[s].scientific_name);
    SpeciesModels& species = species_[s];
    species.skeleton = animal_skeleton(shape, build);
    species.female_headgear = build.female_headgear;
    SkeletonUniforms uniforms;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      uniforms.joints[3 * leg] = glm::vec4(species.skeleton.legs[leg].hip, 0);
      uniforms.joints[3 * leg + 1] = glm::vec4(species.skeleton.legs[leg].knee, 0);
      uniforms.joints[3 * leg + 2] = glm::vec4(species.skeleton.legs[leg].foot, 0);
    }
    const AnimalSkeleton& k = species.skeleton;
    uniforms.neck_head = {k.neck.x, k.neck.z, k.head.x, k.head.z};
    uniforms.graze = {k.graze_neck, k.graze_head, k.graze_pitch, k.lie_drop};
    uniforms.body = {k.hip_height, k.tail.x, k.tail.z, shape.shoulder_height};
    uniforms.look = {build.spots, 0.62F * build.trunk * shape.shoulder_height, 1.25F * build.belly_width * shape.shoulder_height,
                     0};
    species.skeleton_buffer = make_static_buffer(std::as_bytes(std::span(&uniforms, 1)));
    const auto instance_attributes = [&](const VertexArray& array) {
      glVertexArrayBindingDivisor(array.name(), 1, 1);
      float_attribute(array, 4, 1, 4, offsetof(Instance, place));
      float_attribute(array, 5, 1, 4, offsetof(Instance, motion));
      float_attribute(array, 6, 1, 4, offsetof(Instance, pose));
      float_attribute(array, 7, 1, 4, offsetof(Instance, stand));
    };
    for (std::size_t level = 0; level < details.size(); ++level) {
      const AnimalMesh mesh = make_animal_mesh(shape, web.species[s].scientific_name, details[level]);
      Model& model = species.models[level];
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
    species.shade_instances = make_buffer();
    species.shade_array = make_vertex_array();
    glVertexArrayVertexBuffer(species.shade_array.name(), 0, shade_corners_.name(), 0, sizeof(glm::vec2));
    glVertexArrayVertexBuffer(species.shade_array.name(), 1, species.shade_instances.name(), 0, sizeof(Instance));
    float_attribute(species.shade_array, 0, 0, 2, 0);
    instance_attributes(species.shade_array);
  }
}

}  // namespace biotope
