#include "render/animal_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
#include "render/animal_season.hpp"
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
/// Animals whose half length is fewer texels of a ShadowMap's cascade throw no shadow into it.
constexpr float least_shadow_texels = 3;
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
  const auto load = [](ShaderProgram& program, const char* vertex, const char* fragment,
                       const std::vector<std::string>& definitions = {}) -> Status {
    auto loaded = load_shader_program(vertex, fragment, definitions);
    if (!loaded) return tl::unexpected(loaded.error());
    program = std::move(*loaded);
    return {};
  };
  for (const Status& status :
       {load(renderer->near_, "landscape/animal_near.vert", "landscape/animal_near.frag"),
        load(renderer->shadowed_, "landscape/animal_near.vert", "landscape/animal_near.frag", {"WITH_SHADOWS"}),
        load(renderer->caster_, "landscape/animal_near.vert", "landscape/shadow_animal.frag", {"SHADOW_CASTER"}),
        load(renderer->far_, "landscape/animal_far.vert", "landscape/animal_far.frag"),
        load(renderer->shade_, "landscape/animal_shade.vert", "landscape/animal_shade.frag")}) {
    if (!status) return tl::unexpected(status.error());
  }
  constexpr std::array<glm::vec2, 4> corners{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
  renderer->shade_corners_ = make_static_buffer(std::as_bytes(std::span(corners)));
  return renderer;
}

std::vector<HerdRequest> AnimalRenderer::herds_near(const HerdWorld& world, const Look& look) {
  const auto& [options, eye] = look;
  std::vector<HerdRequest> requests;
  const std::vector<DailyPlan>& plans = *world.plans;
  for (std::size_t p = 0; p < plans.size(); ++p) {
    const DailyPlan& plan = plans[p];
    const auto s = std::size_t(plan.species);
    if (s < options.visible_species.size() && !options.visible_species[s]) continue;
    const AnimalShape& shape = world.traits(plan).shape;
    const Place middle = world.place_of(world.state(plan, options.hour * 3600).at);
    const double reach = herd_reach(world, plan);
    const double distance = length(middle - Place{eye.x, eye.y});
    const double flat = std::max(0.0, distance - reach);
    const double height = eye.z - double(ground_height(world.terrain(), middle.x, middle.y));
    if (std::hypot(flat, height) > farthest * double(options.quality) * double(shape.shoulder_height)) continue;
    requests.push_back({int(p), float(1 - smooth_step(boids_near, boids_far, std::hypot(distance, height)))});
  }
  return requests;
}

void AnimalRenderer::place(const HerdAnimal& animal, int plan, int member, const Grid<float>& surface, AnimalAt& at) const {
  const DailyPlan& day = (*world_->plans)[std::size_t(plan)];
  const AnimalShape& shape = world_->traits(day).shape;
  at.plan = plan;
  at.member = member;
  at.species = day.species;
  const glm::dvec2 place(animal.place.x, animal.place.y);
  at.heading = animal.heading;
  at.speed = animal.speed;
  at.height = shape.shoulder_height * animal.size;
  at.place = glm::dvec3(place, feet_height(surface, place, double(at.height)));
  at.length = shape.body_length * animal.size;
  at.young = animal.young;
  at.male = animal.male;
}

/// Size of its headgear; 2 more in velvet; negative for the young.
float AnimalRenderer::headgear(const AnimalAt& at) const {
  if (at.young) return -1;
  const float size = at.male ? 1.0F : species_[std::size_t(at.species)].female_headgear;
  if (size <= 0) return 0;
  const auto early = float(random_unit({world_->seed, 0xca57, std::uint64_t(at.plan), std::uint64_t(at.member)}));
  const AntlerState state = antlers(web_->species[std::size_t(at.species)].scientific_name, at.male, month_, early);
  return size * state.grown + (state.velvet ? 2.0F : 0.0F);
}

double AnimalRenderer::feet_height(const Grid<float>& surface, glm::dvec2 place, double shoulder) const {
  const Terrain& terrain = world_->terrain();
  return wading_.feet({place.x, place.y}, double(surface_height(surface, terrain, place)),
                      double(standing_height(surface, terrain, place)), shoulder);
}

AnimalRenderer::Instance AnimalRenderer::instance(const HerdAnimal& animal, const AnimalAt& at, const Grid<float>& surface,
                                                  const glm::dvec3& eye) const {
  const SpeciesModels& species = species_[std::size_t(at.species)];
  const glm::dvec2 place(at.place);
  const glm::dvec2 ahead{std::sin(double(at.heading)), std::cos(double(at.heading))};
  const glm::dvec2 left{-ahead.y, ahead.x};
  const double size = double(animal.size);
  // The ground under the feet: a plane through the places of fore and hind hooves.
  const double fore = double(species.skeleton.legs[1].foot.x) * size;
  const double hind = double(species.skeleton.legs[0].foot.x) * size;
  const auto height = [&](glm::dvec2 p) { return feet_height(surface, p, double(at.height)); };
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
  const double wades = AnimalWading::head_up(wading_.depth(animal.place), double(at.height));
  const auto head_down = float(double(animal.head_down) * (1 - wades));
  return {glm::vec4(glm::vec3(glm::dvec3(place, ground) - eye), animal.size),
          {float(ahead.x), float(ahead.y), animal.cycles, float(stride * begun / size)},
          {head_down, animal.lying, animal.alarm, gait_of(double(at.speed), hip)},
          {float(rise), float(rise_left), shade, headgear(at)}};
}

/// Into which cascades an animal throws its shadow.
std::array<bool, shadow_cascades> AnimalRenderer::casts_of(const glm::vec3& centre, float radius, const ShadowView* light) {
  std::array<bool, shadow_cascades> casts{};
  for (int c = 0; c < shadow_cascades && light != nullptr; ++c) {
    // What is some texels large is no shadow that one knows.
    const bool large = radius > least_shadow_texels * 2 * light->cascades[std::size_t(c)].half_side / shadow_texels;
    casts[std::size_t(c)] = large && casts_into(*light, c, centre, radius);
    if (!casts[std::size_t(c)]) continue;
    // Antlers and tails reach beyond the ball.
    const ShadowLight& of = light->cascades[std::size_t(c)].light;
    shadow_boxes_[std::size_t(c)].take_in({glm::dot(of.right, centre), glm::dot(of.up, centre)}, 1.5F * radius + 1);
  }
  return casts;
}

void AnimalRenderer::prepare(const MapsSnapshot& maps, const LandscapeOptions& options, const glm::dvec3& eye,
                             const Frustum& frustum, const Grid<float>& surface, const ShadowView* light) {
  drawn_.clear();
  seen_.clear();
  casting_.clear();
  shadow_boxes_ = {};
  looked_ = Look{options, eye};
  if (!options.animals || !simulation_) return;
  // What is placed may for a while be of an older snapshot.
  if (web_ != world_->web) {
    web_ = world_->web;
    make_models(*web_);
  }
  set_month(northern_month(options.month, maps.terrain().latitude));
  place_herds(*looked_);
  const std::vector<HerdRequest>& requests = placed_.requests;
  const std::vector<std::vector<HerdAnimal>>& herds = placed_.herds;
  seen_.resize(species_.size());
  casting_.resize(species_.size());
  for (std::size_t r = 0; r < requests.size(); ++r) {
    for (std::size_t m = 0; m < herds[r].size(); ++m) {
      const HerdAnimal& animal = herds[r][m];
      AnimalAt at;
      place(animal, requests[r].plan, int(m), surface, at);
      const glm::dvec3 offset = at.place - eye;
      const double seen_at = glm::length(offset) / (double(options.quality) * double(at.height));
      if (seen_at > farthest) continue;
      const glm::vec3 centre = glm::vec3(offset) + glm::vec3(0, 0, 0.6F * at.height);
      const float radius = std::max(1.3F * at.height, 0.8F * at.length);
      const std::array<bool, shadow_cascades> casts = casts_of(centre, radius, light);
      const bool seen = frustum.meets_sphere(centre, radius);
      if (!seen && std::none_of(casts.begin(), casts.end(), [](bool does) { return does; })) continue;
      const Instance one = instance(animal, at, surface, eye);
      for (std::size_t c = 0; c < casts.size(); ++c) {
        if (casts[c]) casting_[std::size_t(at.species)][c].push_back(one);
      }
      if (!seen) continue;
      const std::size_t level = seen_at < fine_distance ? 0 : seen_at < plain_distance ? 1 : 2;
      seen_[std::size_t(at.species)][level].push_back(one);
      drawn_.push_back(at);
    }
  }
}

DrawCount AnimalRenderer::draw_shadows(int cascade) const {
  DrawCount count;
  caster_.set("cascade", cascade);
  caster_.use();
  for (std::size_t s = 0; s < casting_.size(); ++s) {
    const auto& list = casting_[s][std::size_t(cascade)];
    if (list.empty()) continue;
    // Far from the eye a silhouette is enough.
    const Model& model = species_[s].models[cascade == 0 ? 1 : 2];
    glBindBufferBase(GL_UNIFORM_BUFFER, skeleton_binding, species_[s].skeleton_buffer.name());
    stream(model.instances, std::span<const Instance>(list));
    glBindVertexArray(model.array.name());
    glDrawElementsInstanced(GL_TRIANGLES, model.index_count, GL_UNSIGNED_INT, nullptr, GLsizei(list.size()));
    ++count.draw_calls;
    count.triangles += std::size_t(model.index_count) / 3 * list.size();
  }
  return count;
}

DrawCount AnimalRenderer::draw(const LandscapeOptions& options, bool shadows) const {
  DrawCount count;
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    for (std::size_t level = 0; level < levels_of_detail; ++level) {
      const auto& list = seen_[s][level];
      if (list.empty()) continue;
      (level < 2 ? (shadows ? shadowed_ : near_) : far_).use();
      const Model& model = species_[s].models[level];
      glBindBufferBase(GL_UNIFORM_BUFFER, skeleton_binding, species_[s].skeleton_buffer.name());
      stream(model.instances, std::span<const Instance>(list));
      glBindVertexArray(model.array.name());
      glDrawElementsInstanced(GL_TRIANGLES, model.index_count, GL_UNSIGNED_INT, nullptr, GLsizei(list.size()));
      ++count.draw_calls;
      count.triangles += std::size_t(model.index_count) / 3 * list.size();
    }
  }
  const DrawCount shades = draw_shades(double(options.quality), shadows ? 0.4F : 1.0F);
  count.draw_calls += shades.draw_calls;
  count.triangles += shades.triangles;
  return count;
}

/// Shade on the ground under animals, darker where they stand together. Where shadows are drawn, it is only what hides the sky.
DrawCount AnimalRenderer::draw_shades(double quality, float strength) const {
  DrawCount count;
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2, -2);
  shade_.set("strength", strength);
  shade_.use();
  std::vector<Instance> list;
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    list.clear();
    for (const auto& level : seen_[s]) {
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

std::optional<AnimalAt> AnimalRenderer::animal(int plan, int member, double hour, const Grid<float>& surface) {
  if (!simulation_ || plan < 0 || std::size_t(plan) >= world_->plans->size()) return std::nullopt;
  std::vector<HerdAnimal> herd;
  if (!change_) {
    herd = simulation_->animals(plan, hour);
  } else if (const auto found = std::ranges::find(placed_.requests, plan, &HerdRequest::plan); found != placed_.requests.end()) {
    herd = placed_.herds[std::size_t(found - placed_.requests.begin())];
  }
  if (member < 0 || std::size_t(member) >= herd.size()) return std::nullopt;
  AnimalAt at;
  place(herd[std::size_t(member)], plan, member, surface, at);
  return at;
}

}  // namespace biotope
