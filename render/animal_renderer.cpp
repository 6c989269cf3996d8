#include "render/animal_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "render/animal_world.hpp"

namespace biotope {

namespace {

/// Beyond these distances (times quality, m, for an animal of 1 m at the shoulder) an animal is drawn plainly, as a silhouette,
/// and not at all: it would be smaller than a pixel.
constexpr double fine_distance = 38;
constexpr double plain_distance = 100;
constexpr double farthest = 1000;
/// Herds nearer than the first are simulated, those beyond the second follow their guides; m.
constexpr double boids_near = 260;
constexpr double boids_far = 340;
/// Shadows are drawn up to this distance, times quality, m.
constexpr double shade_distance = 220;
constexpr GLuint skeleton_binding = 2;

/// Froude numbers v2 / (g hip) at which a walk becomes a trot and a trot a gallop, each gradually around it.
constexpr double trot_froude = 0.5;
constexpr double gallop_froude = 2.5;

float gait_of(double speed, double hip) {
  const double froude = speed * speed / (9.81 * hip);
  return float(smooth_step(0.75 * trot_froude, 1.35 * trot_froude, froude) +
               smooth_step(0.8 * gallop_froude, 1.3 * gallop_froude, froude));
}

}  // namespace

Result<std::unique_ptr<AnimalRenderer>> AnimalRenderer::create() {
  std::unique_ptr<AnimalRenderer> renderer(new AnimalRenderer);
  const auto load = [](ShaderProgram& program, const char* vertex, const char* fragment) -> Status {
    auto loaded = load_shader_program(vertex, fragment);
    if (!loaded) return tl::unexpected(loaded.error());
    program = std::move(*loaded);
    return {};
  };
  for (const Status& status : {load(renderer->near_, "landscape/animal_near.vert", "landscape/animal_near.frag"),
                               load(renderer->far_, "landscape/animal_far.vert", "landscape/animal_far.frag"),
                               load(renderer->shade_, "landscape/animal_shade.vert", "landscape/animal_shade.frag")}) {
    if (!status) return tl::unexpected(status.error());
  }
  constexpr std::array<glm::vec2, 4> corners{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  renderer->shade_corners_ = make_static_buffer(std::as_bytes(std::span(corners)));
  return renderer;
}

void AnimalRenderer::set_world(const MapsSnapshot& maps, std::shared_ptr<const ShoreMap> shore) {
  const bool same = world_ && world_->plans == maps.plans && world_->graph == maps.graph && world_->web == maps.web &&
                    shore_ == shore && world_->ground.terrain == maps.surface() && world_->ground.hydrology == maps.hydrology &&
                    world_->ground.derivatives == maps.derivatives && world_->levels == maps.animals &&
                    world_->seed == maps.document.seed;
  if (same) return;
  shore_ = shore;
  world_ = herd_world(maps, std::move(shore));
  simulation_ = world_ ? std::make_unique<HerdSimulation>(world_) : nullptr;
}

/// Herds that may be in sight, and how near they are.
std::vector<HerdRequest> AnimalRenderer::herds_near(const LandscapeOptions& options, const glm::dvec3& eye) const {
  std::vector<HerdRequest> requests;
  const std::vector<DailyPlan>& plans = *world_->plans;
  for (std::size_t p = 0; p < plans.size(); ++p) {
    const DailyPlan& plan = plans[p];
    const auto s = std::size_t(plan.species);
    if (s < options.visible_species.size() && !options.visible_species[s]) continue;
    const AnimalShape& shape = world_->traits(plan).shape;
    const Place middle = world_->place_of(world_->state(plan, options.hour * 3600).at);
    const double reach = double(shape.body_length) * (6 + 2.0 * std::sqrt(double(plan.size)) + 0.8 * double(plan.size)) +
                         (plan.followed >= 0 ? 260 : 60);
    const double distance = length(middle - Place{eye.x, eye.y});
    const double flat = std::max(0.0, distance - reach);
    const double height = eye.z - double(ground_height(world_->terrain(), middle.x, middle.y));
    if (std::hypot(flat, height) > farthest * double(options.quality) * double(shape.shoulder_height)) continue;
    requests.push_back({int(p), float(1 - smooth_step(boids_near, boids_far, std::hypot(distance, height)))});
  }
  return requests;
}

void AnimalRenderer::place(const MapsSnapshot& maps, const HerdAnimal& animal, int plan, int member, const Grid<float>& surface,
                           AnimalAt& at) const {
  const DailyPlan& day = (*world_->plans)[std::size_t(plan)];
  const AnimalShape& shape = world_->traits(day).shape;
  at.plan = plan;
  at.member = member;
  at.species = day.species;
  const glm::dvec2 place(animal.place.x, animal.place.y);
  at.place = glm::dvec3(place, double(standing_height(surface, maps.terrain(), place)));
  at.heading = animal.heading;
  at.speed = animal.speed;
  at.height = shape.shoulder_height * animal.size;
  at.length = shape.body_length * animal.size;
  at.young = animal.young;
  at.male = animal.male;
}

AnimalRenderer::Instance AnimalRenderer::instance(const HerdAnimal& animal, const AnimalAt& at, const MapsSnapshot& maps,
                                                  const Grid<float>& surface, const glm::dvec3& eye) const {
  const SpeciesModels& species = species_[std::size_t(at.species)];
  const Terrain& terrain = maps.terrain();
  const glm::dvec2 place(at.place);
  const glm::dvec2 ahead{std::sin(double(at.heading)), std::cos(double(at.heading))};
  const glm::dvec2 left{-ahead.y, ahead.x};
  const double size = double(animal.size);
  // The ground under the feet: a plane through the places of fore and hind hooves.
  const double fore = double(species.skeleton.legs[1].foot.x) * size;
  const double hind = double(species.skeleton.legs[0].foot.x) * size;
  const auto height = [&](glm::dvec2 p) { return double(standing_height(surface, terrain, p)); };
  const double at_fore = height(place + ahead * fore);
  const double at_hind = height(place + ahead * hind);
  const double rise = (at_fore - at_hind) / (fore - hind);
  const double side = 0.3 * double(at.height);
  const double rise_left = (height(place + left * side) - height(place - left * side)) / (2 * side);
  const double ground = at_hind - rise * hind;
  const double hip = hip_height(double(at.height));
  const double stride = at.speed > 0.02F ? stride_length(hip, double(at.speed)) : 0.0;
  // Strides grow from nothing, so that feet come to rest under the body.
  const double begun = smooth_step(0.02, 0.25, double(at.speed));
  const auto shade = float(0.86 + 0.24 * random_unit({world_->seed, std::uint64_t(at.plan), std::uint64_t(at.member)}));
  const float headgear = at.young ? -1.0F : at.male ? 1.0F : species.female_headgear;
  return {glm::vec4(glm::vec3(glm::dvec3(place, ground) - eye), animal.size),
          {float(ahead.x), float(ahead.y), animal.cycles, float(stride * begun / size)},
          {animal.head_down, animal.lying, animal.alarm, gait_of(double(at.speed), hip)},
          {float(rise), float(rise_left), shade, headgear}};
}

DrawCount AnimalRenderer::draw(const MapsSnapshot& maps, const LandscapeOptions& options, const glm::dvec3& eye,
                               const Frustum& frustum, const Grid<float>& surface, std::size_t& drawn_animals) {
  drawn_.clear();
  if (!options.animals || !simulation_) return {};
  if (web_ != maps.web) {
    web_ = maps.web;
    make_models(*web_);
  }
  const std::vector<HerdRequest> requests = herds_near(options, eye);
  const std::vector<std::vector<HerdAnimal>> herds = simulation_->animals(requests, options.hour);
  std::vector<std::array<std::vector<Instance>, levels_of_detail>> instances(species_.size());
  for (std::size_t r = 0; r < requests.size(); ++r) {
    for (std::size_t m = 0; m < herds[r].size(); ++m) {
      const HerdAnimal& animal = herds[r][m];
      AnimalAt at;
      place(maps, animal, requests[r].plan, int(m), surface, at);
      const glm::dvec3 offset = at.place - eye;
      const double seen_at = glm::length(offset) / (double(options.quality) * double(at.height));
      if (seen_at > farthest || !frustum.meets_sphere(glm::vec3(offset) + glm::vec3(0, 0, 0.6F * at.height),
                                                      std::max(1.3F * at.height, 0.8F * at.length)))
        continue;
      const std::size_t level = seen_at < fine_distance ? 0 : seen_at < plain_distance ? 1 : 2;
      instances[std::size_t(at.species)][level].push_back(instance(animal, at, maps, surface, eye));
      drawn_.push_back(at);
    }
  }

  DrawCount count;
  for (std::size_t s = 0; s < species_.size(); ++s) {
    for (std::size_t level = 0; level < levels_of_detail; ++level) {
      const auto& list = instances[s][level];
      if (list.empty()) continue;
      (level < 2 ? near_ : far_).use();
      const Model& model = species_[s].models[level];
      glBindBufferBase(GL_UNIFORM_BUFFER, skeleton_binding, species_[s].skeleton_buffer.name());
      stream(model.instances, std::span<const Instance>(list));
      glBindVertexArray(model.array.name());
      glDrawElementsInstanced(GL_TRIANGLES, model.index_count, GL_UNSIGNED_INT, nullptr, GLsizei(list.size()));
      ++count.draw_calls;
      count.triangles += std::size_t(model.index_count) / 3 * list.size();
      drawn_animals += list.size();
    }
  }
  const DrawCount shades = draw_shades(instances, double(options.quality));
  count.draw_calls += shades.draw_calls;
  count.triangles += shades.triangles;
  return count;
}

/// Shadows on the ground, darker where animals stand together.
DrawCount AnimalRenderer::draw_shades(const std::vector<std::array<std::vector<Instance>, levels_of_detail>>& instances,
                                      double quality) {
  DrawCount count;
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2, -2);
  shade_.use();
  std::vector<Instance> list;
  for (std::size_t s = 0; s < species_.size(); ++s) {
    list.clear();
    for (const auto& level : instances[s]) {
      for (const Instance& one : level) {
        if (glm::length(glm::vec3(one.place)) < shade_distance * quality) list.push_back(one);
      }
    }
    if (list.empty()) continue;
    glBindBufferBase(GL_UNIFORM_BUFFER, skeleton_binding, species_[s].skeleton_buffer.name());
    stream(species_[s].shade_instances, std::span<const Instance>(list));
    glBindVertexArray(species_[s].shade_array.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(list.size()));
    ++count.draw_calls;
    count.triangles += 2 * list.size();
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0, 0);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  return count;
}

std::optional<AnimalAt> AnimalRenderer::animal(const MapsSnapshot& maps, int plan, int member, double hour,
                                               const Grid<float>& surface) {
  if (!simulation_ || plan < 0 || std::size_t(plan) >= world_->plans->size()) return std::nullopt;
  const std::vector<HerdAnimal> herd = simulation_->animals(plan, hour);
  if (member < 0 || std::size_t(member) >= herd.size()) return std::nullopt;
  AnimalAt at;
  place(maps, herd[std::size_t(member)], plan, member, surface, at);
  return at;
}

}  // namespace biotope
