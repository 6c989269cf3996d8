#include "render/animal_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "render/animal_members.hpp"
#include "render/animal_mesh.hpp"

namespace biotope {

namespace {

/// Beyond these distances (times quality, m) an animal is drawn plainly, as a silhouette, and not at all: it would be smaller than a pixel.
constexpr double fine_distance = 35;
constexpr double plain_distance = 110;
constexpr double farthest = 900;
constexpr std::array<AnimalDetail, 3> details{AnimalDetail::fine, AnimalDetail::plain, AnimalDetail::silhouette};

/// Stride of a walk, m, from the shoulder's height (methods: stride of about 2.4 hip heights at a slow walk's Froude number).
float stride_length(float shoulder) { return std::max(0.3F, 1.25F * shoulder); }

float surface_height(const Grid<float>& surface, const Terrain& terrain, glm::dvec2 place) {
  const double scale = double(surface.width()) / terrain.height.width();
  const double x = place.x / terrain.cell_size * scale - 0.5;
  const double y = (double(terrain.height.height()) - place.y / terrain.cell_size) * scale - 0.5;
  return sample_bilinear(surface, x, y);
}

}  // namespace

Result<std::unique_ptr<AnimalRenderer>> AnimalRenderer::create() {
  std::unique_ptr<AnimalRenderer> renderer(new AnimalRenderer);
  auto program = load_shader_program("landscape/animal.vert", "landscape/animal.frag");
  if (!program) return tl::unexpected(program.error());
  renderer->program_ = std::move(*program);
  return renderer;
}

void AnimalRenderer::make_models(const FoodWeb& web) {
  species_.clear();
  species_.resize(web.species.size());
  for (std::size_t s = 0; s < web.species.size(); ++s) {
    if (web.species[s].is_plant()) continue;
    for (std::size_t level = 0; level < details.size(); ++level) {
      const AnimalMesh mesh = make_animal_mesh(web.species[s].animal().shape, details[level]);
      Model& model = species_[s].models[level];
      model.vertices = make_static_buffer(std::as_bytes(std::span(mesh.vertices)));
      model.indices = make_static_buffer(std::as_bytes(std::span(mesh.indices)));
      model.instances = make_buffer();
      model.index_count = GLsizei(mesh.indices.size());
      model.array = make_vertex_array();
      glVertexArrayElementBuffer(model.array.name(), model.indices.name());
      glVertexArrayVertexBuffer(model.array.name(), 0, model.vertices.name(), 0, sizeof(AnimalVertex));
      glVertexArrayVertexBuffer(model.array.name(), 1, model.instances.name(), 0, sizeof(Instance));
      glVertexArrayBindingDivisor(model.array.name(), 1, 1);
      float_attribute(model.array, 0, 0, 3, offsetof(AnimalVertex, position));
      float_attribute(model.array, 1, 0, 3, offsetof(AnimalVertex, normal));
      float_attribute(model.array, 2, 0, 3, offsetof(AnimalVertex, colour));
      float_attribute(model.array, 3, 0, 4, offsetof(AnimalVertex, rig));
      float_attribute(model.array, 4, 1, 4, offsetof(Instance, place));
      float_attribute(model.array, 5, 1, 4, offsetof(Instance, motion));
      float_attribute(model.array, 6, 1, 4, offsetof(Instance, pose));
    }
  }
}

DrawCount AnimalRenderer::draw(const MapsSnapshot& maps, const LandscapeOptions& options, const glm::dvec3& eye, const Frustum& frustum,
                               const Grid<float>& surface, std::size_t& drawn_animals) {
  if (!options.animals || !maps.plans || !maps.graph || !maps.web) return {};
  if (web_ != maps.web) {
    web_ = maps.web;
    make_models(*web_);
  }
  const Terrain& terrain = maps.terrain();
  std::vector<std::array<std::vector<Instance>, levels_of_detail>> instances(species_.size());
  for (std::size_t p = 0; p < maps.plans->size(); ++p) {
    const DailyPlan& plan = (*maps.plans)[p];
    const auto s = std::size_t(plan.species);
    if (s < options.visible_species.size() && !options.visible_species[s]) continue;
    const AnimalShape& shape = web_->species[s].animal().shape;
    const HerdState state = herd_state(plan, maps.graph->levels[std::size_t(plan.level)], options.hour, terrain.cell_size);
    const glm::dvec2 middle{(double(state.at.x) + 0.5) * terrain.cell_size,
                            (terrain.height.height() - 0.5 - double(state.at.y)) * terrain.cell_size};
    const double reach = double(shape.body_length) * (4 + 3.0 * std::sqrt(double(plan.size)) + double(plan.size));
    if (glm::length(middle - glm::dvec2(eye)) > farthest * double(options.quality) + reach) continue;
    std::uint64_t number = 0;
    for (const HerdMember& member : herd_members(maps, plan, p, options.hour)) {
      const double ground = double(surface_height(surface, terrain, member.place));
      const glm::dvec3 offset = glm::dvec3(member.place, ground) - eye;
      const double distance = glm::length(offset);
      const float size = shape.shoulder_height * member.size;
      ++number;
      if (distance > farthest * double(options.quality) || !frustum.meets_sphere(glm::vec3(offset) + glm::vec3(0, 0, 0.6F * size), 1.6F * size)) continue;
      const glm::dvec2 ahead{std::sin(double(member.heading)), std::cos(double(member.heading))};
      const double step = 0.5 * double(shape.body_length);
      const double rise = double(surface_height(surface, terrain, member.place + ahead * step)) -
                          double(surface_height(surface, terrain, member.place - ahead * step));
      const float phase = member.walked / stride_length(shape.shoulder_height);
      const auto shade = float(0.9 + 0.2 * random_unit({maps.document.seed, p, number}));
      const double near = distance / double(options.quality);
      const std::size_t level = near < fine_distance ? 0 : near < plain_distance ? 1 : 2;
      instances[s][level].push_back({glm::vec4(offset, member.size),
                                     {std::sin(member.heading), std::cos(member.heading), phase - std::floor(phase), member.speed},
                                     {member.head_down, float(std::atan2(rise, 2 * step)), shade, 0}});
    }
  }

  program_.use();
  DrawCount count;
  for (std::size_t s = 0; s < species_.size(); ++s) {
    for (std::size_t level = 0; level < levels_of_detail; ++level) {
      const auto& list = instances[s][level];
      if (list.empty()) continue;
      const Model& model = species_[s].models[level];
      stream(model.instances, std::span<const Instance>(list));
      glBindVertexArray(model.array.name());
      glDrawElementsInstanced(GL_TRIANGLES, model.index_count, GL_UNSIGNED_INT, nullptr, GLsizei(list.size()));
      ++count.draw_calls;
      count.triangles += std::size_t(model.index_count) / 3 * list.size();
      drawn_animals += list.size();
    }
  }
  return count;
}

}  // namespace biotope
