#include "render/plant_shadows.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// A near square wider than this (m, half a side) is for an eye high up, which sees no single leaves.
constexpr float widest_for_meshes = 60;
/// What throws its shadow into the near square from farther away than this (m, from its middle) is no mesh: low light brings the
/// shadows of a whole wood.
constexpr double mesh_reach = 70;
/// Plants are at most this much larger than the mesh of their kind.
constexpr float largest_scale = 1.2F * largest_plant_scale;
/// Shadows of leaves move in steps of this, s.
constexpr double wind_step = 0.125;

/// Plants by kind and model, and those that are drawn as pictures.
struct Casters {
  std::vector<std::vector<PlantInstance>> meshes;
  std::vector<PlantInstance> pictures;
};

/// A ball that holds a block's plants.
struct Ball {
  glm::dvec3 centre;
  float radius;
};

Ball ball_of(const WoodyBlock& block, float tallest) {
  const double side = woody_block_side;
  const double rise = 0.5 * double(block.high - block.low + tallest);
  return {{(block.column + 0.5) * side, (block.row + 0.5) * side, double(block.low) + rise},
          float(std::hypot(0.71 * side, rise)) + 4};
}

float tallest_of(const std::vector<PlantKind>& kinds, Stratum stratum) {
  float tallest = 1;
  for (const PlantKind& kind : kinds) {
    if (kind.stratum == stratum) tallest = std::max(tallest, largest_scale * kind.extent.height);
  }
  return tallest;
}

/// Plants that throw shadows into the nearest square.
Casters near_casters(const PlantRenderer& plants, const PlantShadowPicture& picture) {
  const std::vector<PlantKind>& kinds = plants.kinds().kinds();
  Casters out;
  out.meshes.resize(plant_models * kinds.size());
  for (const PlantShadowPicture::Block& place : picture.blocks) {
    const auto& blocks = plants.blocks().blocks(place.stratum);
    const auto block = blocks.find({place.row, place.column});
    if (block == blocks.end()) continue;
    for (const PlantInstance& plant : block->second.plants) {
      const auto k = std::size_t(plant.plant);
      if (k >= kinds.size()) continue;
      const auto species = std::size_t(kinds[k].species);
      if (species < picture.visible.size() && !picture.visible[species]) continue;
      const float half = 0.5F * kinds[k].extent.height * plant.scale;
      const glm::vec3 centre(glm::dvec3(plant.x, plant.y, plant.z + half) - glm::dvec3(picture.origin));
      const glm::vec2 at(glm::dot(picture.light.right, centre), glm::dot(picture.light.up, centre));
      const glm::vec2 away = glm::abs(at - glm::vec2(picture.from_origin));
      if (std::max(away.x, away.y) >= picture.half_side + half + kinds[k].extent.radius * plant.scale) continue;
      if (glm::length(glm::dvec2(centre)) > mesh_reach) {
        out.pictures.push_back(plant);
      } else {
        out.meshes[plant_models * k + std::size_t(model_of(plant))].push_back(plant);
      }
    }
  }
  return out;
}

void set_square(const ShaderProgram& program, const PlantShadowPicture& picture) {
  program.set("cascade", picture.cascade);
  program.set("origin", picture.origin);
  program.set("square", glm::vec4(glm::vec2(picture.from_origin), picture.half_side, picture.from_origin.z));
}

}  // namespace

PlantShadowPicture shadow_picture(const PlantRenderer& plants, const PlantShadowLook& look, const ShadowView& view, int cascade) {
  const ShadowCascade& square = view.cascades[std::size_t(cascade)];
  PlantShadowPicture out;
  out.cascade = cascade;
  out.light = square.light;
  out.half_side = square.half_side;
  out.origin = square.origin;
  out.from_origin = square.from_origin;
  out.web = look.web;
  out.visible = look.visible;
  out.month = look.month;
  out.meshes = cascade == 0 && square.half_side <= widest_for_meshes;
  if (out.meshes && glm::length(glm::dvec2(look.wind)) > 0) {
    out.wind = glm::vec3(look.wind.x, look.wind.y, std::floor(look.wind.z / wind_step) * wind_step);
  }
  const double side = woody_block_side;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    // Blocks that are there from wherever the eye has this square, and not those that are left from an earlier view.
    const double known = double(plants.shading_reach(stratum));
    const double settled = std::max(known - 0.9 * double(square.half_side) - side, 0.4 * known);
    const float tallest = tallest_of(plants.kinds().kinds(), stratum);
    for (const WoodyBlock& block : plants.woody().of(stratum)) {
      if (block.plants == 0 || (!out.meshes && !block.resident)) continue;
      const glm::dvec2 middle((block.column + 0.5) * side, (block.row + 0.5) * side);
      if (glm::distance(middle, glm::dvec2(look.eye)) > known || glm::distance(middle, glm::dvec2(square.origin)) > settled)
        continue;
      const Ball ball = ball_of(block, tallest);
      if (!throws_into(view, cascade, ball.centre, ball.radius)) continue;
      out.blocks.push_back({stratum, block.row, block.column, out.meshes ? block.version : block.there.version});
    }
  }
  return out;
}

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

DrawCount PlantShadows::draw(const PlantRenderer& plants, const PlantShadowPicture& picture) const {
  plants.kinds().bind();
  return picture.meshes ? draw_meshes(plants, picture) : draw_pictures(plants, picture);
}

DrawCount PlantShadows::draw_meshes(const PlantRenderer& plants, const PlantShadowPicture& picture) const {
  const Casters casters = near_casters(plants, picture);
  std::vector<PlantInstance> all;
  for (const auto& list : casters.meshes) all.insert(all.end(), list.begin(), list.end());
  std::size_t first = all.size();
  all.insert(all.end(), casters.pictures.begin(), casters.pictures.end());
  stream(instances_, std::span<const PlantInstance>(all));
  const auto from = [](std::size_t instance) { return GLintptr(instance * sizeof(PlantInstance)); };
  DrawCount drawn;
  if (!casters.pictures.empty()) {
    set_square(picture_, picture);
    picture_.use();
    glVertexArrayVertexBuffer(array_.name(), 1, instances_.name(), from(first), sizeof(PlantInstance));
    glBindVertexArray(array_.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(casters.pictures.size()));
    drawn = {1, 2 * casters.pictures.size()};
  }
  set_square(mesh_, picture);
  mesh_.set("moment", picture.wind.z);
  mesh_.use();
  first = 0;
  for (std::size_t i = 0; i < casters.meshes.size(); ++i) {
    const std::size_t count = casters.meshes[i].size();
    if (count == 0) continue;
    const PlantMeshBuffers& mesh = plants.kinds().kinds()[i / plant_models].near[i % plant_models];
    glVertexArrayVertexBuffer(mesh.array.name(), 1, instances_.name(), from(first), sizeof(PlantInstance));
    glBindVertexArray(mesh.array.name());
    glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_SHORT, nullptr, GLsizei(count));
    first += count;
    ++drawn.draw_calls;
    drawn.triangles += count * std::size_t(mesh.index_count / 3);
  }
  return drawn;
}

DrawCount PlantShadows::draw_pictures(const PlantRenderer& plants, const PlantShadowPicture& picture) const {
  std::vector<FarDraw> draws;
  std::size_t count = 0;
  for (const PlantShadowPicture::Block& place : picture.blocks) {
    const PlantArena::Places& places = plants.arena().places(place.stratum);
    const auto resident = places.find({place.row, place.column});
    if (resident == places.end() || resident->second.run.count == 0) continue;
    draws.push_back({4, resident->second.run.count, 0, resident->second.run.first});
    count += resident->second.run.count;
  }
  if (draws.empty()) return {};
  stream(draws_, std::span<const FarDraw>(draws));
  set_square(picture_, picture);
  picture_.use();
  glVertexArrayVertexBuffer(array_.name(), 1, plants.arena().buffer().name(), 0, sizeof(PlantInstance));
  glBindVertexArray(array_.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draws_.name());
  glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, GLsizei(draws.size()), 0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  return {1, 2 * count};
}

}  // namespace biotope
