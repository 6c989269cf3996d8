#include "render/plant_shadows.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// A near square wider than this (m, half a side) is for an eye high up, which sees no single leaves.
constexpr float widest_for_meshes = 60;
/// Plants are at most this much larger than the mesh of their kind.
constexpr float largest_scale = 1.2F * largest_plant_scale;

using InstanceLists = std::vector<std::vector<PlantInstance>>;

/// A ball that holds a block's plants, relative to the eye.
struct Ball {
  glm::vec3 centre;
  float radius;
};

Ball ball_of(std::pair<int, int> place, const PlantBlock& block, float tallest, const glm::dvec3& eye) {
  const double side = woody_block_side;
  const double rise = 0.5 * double(block.high - block.low + tallest);
  const glm::dvec3 centre((place.second + 0.5) * side, (place.first + 0.5) * side, double(block.low) + rise);
  return {glm::vec3(centre - eye), float(std::hypot(0.71 * side, rise)) + 4};
}

float tallest_of(const std::vector<PlantKind>& kinds, Stratum stratum) {
  float tallest = 1;
  for (const PlantKind& kind : kinds) {
    if (kind.stratum == stratum) tallest = std::max(tallest, largest_scale * kind.extent.height);
  }
  return tallest;
}

/// Plants that throw shadows into the nearest square, by kind and model.
InstanceLists near_casters(const PlantRenderer& plants, const SpeciesVisibility& visible, const glm::dvec3& eye,
                           const ShadowView& view) {
  const std::vector<PlantKind>& kinds = plants.kinds().kinds();
  InstanceLists lists(plant_models * kinds.size());
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    const float tallest = tallest_of(kinds, stratum);
    for (const auto& [place, block] : plants.blocks().blocks(stratum)) {
      const Ball ball = ball_of(place, block, tallest, eye);
      if (!casts_into(view, 0, ball.centre, ball.radius)) continue;
      for (const PlantInstance& plant : block.plants) {
        const auto k = std::size_t(plant.plant);
        if (k >= kinds.size()) continue;
        const auto species = std::size_t(kinds[k].species);
        if (species < visible.size() && !visible[species]) continue;
        const float half = 0.5F * kinds[k].extent.height * plant.scale;
        const glm::vec3 centre(glm::dvec3(plant.x, plant.y, plant.z + half) - eye);
        if (!casts_into(view, 0, centre, half + kinds[k].extent.radius * plant.scale)) continue;
        lists[plant_models * k + std::size_t(model_of(plant))].push_back(plant);
      }
    }
  }
  return lists;
}

}  // namespace

Result<PlantShadows> PlantShadows::create() {
  PlantShadows out;
  auto mesh = load_shader_program("landscape/shadow_plant.vert", "landscape/shadow_plant.frag");
  if (!mesh) return tl::unexpected(mesh.error());
  out.mesh_ = std::move(*mesh);
  auto picture = load_shader_program("landscape/shadow_plant_far.vert", "landscape/shadow_plant_far.frag");
  if (!picture) return tl::unexpected(picture.error());
  out.picture_ = std::move(*picture);
  out.instances_ = make_buffer();
  out.draws_ = make_buffer();
  out.array_ = make_vertex_array();
  instance_attributes(out.array_);
  return out;
}

DrawCount PlantShadows::draw(const PlantRenderer& plants, const SpeciesVisibility& visible, const glm::dvec3& eye,
                             const ShadowView& view, int cascade) const {
  plants.kinds().bind();
  const bool meshes = cascade == 0 && view.cascades[0].half_side <= widest_for_meshes;
  return meshes ? draw_meshes(plants, visible, eye, view) : draw_pictures(plants, eye, view, cascade);
}

DrawCount PlantShadows::draw_meshes(const PlantRenderer& plants, const SpeciesVisibility& visible, const glm::dvec3& eye,
                                    const ShadowView& view) const {
  const InstanceLists lists = near_casters(plants, visible, eye, view);
  std::vector<PlantInstance> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  stream(instances_, std::span<const PlantInstance>(all));
  mesh_.set("cascade", 0);
  mesh_.use();
  DrawCount drawn;
  std::size_t first = 0;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (lists[i].empty()) continue;
    const PlantMeshBuffers& mesh = plants.kinds().kinds()[i / plant_models].near[i % plant_models];
    glVertexArrayVertexBuffer(mesh.array.name(), 1, instances_.name(), GLintptr(first * sizeof(PlantInstance)),
                              sizeof(PlantInstance));
    glBindVertexArray(mesh.array.name());
    glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_SHORT, nullptr, GLsizei(lists[i].size()));
    first += lists[i].size();
    ++drawn.draw_calls;
    drawn.triangles += lists[i].size() * std::size_t(mesh.index_count / 3);
  }
  return drawn;
}

DrawCount PlantShadows::draw_pictures(const PlantRenderer& plants, const glm::dvec3& eye, const ShadowView& view,
                                      int cascade) const {
  std::vector<FarDraw> draws;
  std::size_t count = 0;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    const float tallest = tallest_of(plants.kinds().kinds(), stratum);
    const PlantArena::Places& places = plants.arena().places(stratum);
    for (const auto& [place, block] : plants.blocks().blocks(stratum)) {
      const auto resident = places.find(place);
      if (resident == places.end() || resident->second.run.count == 0) continue;
      const Ball ball = ball_of(place, block, tallest, eye);
      if (!casts_into(view, cascade, ball.centre, ball.radius)) continue;
      draws.push_back({4, resident->second.run.count, 0, resident->second.run.first});
      count += resident->second.run.count;
    }
  }
  if (draws.empty()) return {};
  stream(draws_, std::span<const FarDraw>(draws));
  picture_.set("cascade", cascade);
  picture_.use();
  glVertexArrayVertexBuffer(array_.name(), 1, plants.arena().buffer().name(), 0, sizeof(PlantInstance));
  glBindVertexArray(array_.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draws_.name());
  glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, GLsizei(draws.size()), 0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  return {1, 2 * count};
}

}  // namespace biotope
