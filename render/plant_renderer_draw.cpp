#include <algorithm>

#include "render/plant_mesh_order.hpp"
#include "render/plant_renderer.hpp"

// What of a PlantRenderer draws what was chosen.

namespace biotope {

namespace {

void set_levels(const ShaderProgram& program, const PlantLevels& levels) {
  program.set("lod", glm::vec4(levels.near_pixels, levels.mid_pixels, levels.far_from, levels.far_to));
}

/// Height on the screen from which no mesh is finer.
constexpr float no_finer = 1e9F;

/// Draws a mesh for instances [first, first + count) of a buffer.
void draw_instances(const PlantMeshBuffers& mesh, const Buffer& instances, std::size_t first, std::size_t count,
                    DrawCount& drawn) {
  glVertexArrayVertexBuffer(mesh.array.name(), 1, instances.name(), GLintptr(first * sizeof(PlantInstance)),
                            sizeof(PlantInstance));
  glBindVertexArray(mesh.array.name());
  glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_SHORT, nullptr, GLsizei(count));
  ++drawn.draw_calls;
  drawn.triangles += count * std::size_t(mesh.index_count / 3);
}

/// Adds what draws a mesh for plants of which each shows its triangles in the order in which the eye meets them; returns how
/// many.
std::size_t add_ordered(const PlantMeshBuffers& mesh, std::span<const PlantInstance> plants, const glm::vec3& eye,
                        std::vector<MeshDraw>& runs) {
  const std::size_t before = runs.size();
  for (std::size_t i = 0; i < plants.size(); ++i) {
    const auto from = std::uint32_t(mesh_order(plants[i], eye)) * std::uint32_t(mesh.index_count);
    if (runs.size() == before || runs.back().first_index != from)
      runs.push_back({std::uint32_t(mesh.index_count), 0, from, 0, std::uint32_t(i)});
    ++runs.back().plants;
  }
  return runs.size() - before;
}

}  // namespace

std::size_t draw_blocks(const VertexArray& array, const PlantArena& arena, const Buffer& commands,
                        std::span<const FarDraw> blocks) {
  if (blocks.empty()) return 0;
  stream(commands, blocks);
  glVertexArrayVertexBuffer(array.name(), 1, arena.buffer().name(), 0, sizeof(PlantInstance));
  glBindVertexArray(array.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.name());
  glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, GLsizei(blocks.size()), 0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  std::size_t sum = 0;
  for (const FarDraw& block : blocks) sum += block.plants;
  return sum;
}

DrawCount PlantRenderer::draw(bool shadows) const {
  kinds_.bind();
  DrawCount drawn;
  const auto add = [&](const DrawCount& part) {
    drawn.draw_calls += part.draw_calls;
    drawn.triangles += part.triangles;
    // Where processors draw, others fill these pixels while this one goes on to the next vertices.
    glFlush();
  };
  add(draw_meshes(shadows ? shadowed_mesh_program_ : mesh_program_));
  add(draw_tufts(shadows ? shadowed_tuft_program_ : tuft_program_));
  add(draw_far());
  return drawn;
}

std::vector<PlantRenderer::MeshList> PlantRenderer::mesh_lists() const {
  std::vector<MeshList> out;
  std::size_t first = 0;
  const auto add = [&](const std::vector<PlantInstance>& plants, const PlantMeshBuffers& mesh, const PlantKind& kind,
                       glm::vec2 level) {
    if (!plants.empty()) out.push_back({&mesh, &kind, plants, first, level, 0, 0});
    first += plants.size();
  };
  // Trees and shrubs change their meshes at the same heights.
  const PlantLevels& levels = selection_.levels.front();
  struct Level {
    const std::vector<std::vector<PlantInstance>>& lists;
    std::array<PlantMeshBuffers, plant_models> PlantKind::*meshes;
    glm::vec2 pixels;
  };
  for (const Level& level : {Level{selection_.close, &PlantKind::close, {no_finer, levels.close_pixels}},
                             Level{selection_.near, &PlantKind::near, {levels.close_pixels, levels.near_pixels}},
                             Level{selection_.mid, &PlantKind::mid, {levels.near_pixels, levels.mid_pixels}}}) {
    for (std::size_t i = 0; i < level.lists.size(); ++i) {
      const PlantKind& kind = kinds_.kinds()[i / plant_models];
      add(level.lists[i], (kind.*level.meshes)[i % plant_models], kind, level.pixels);
    }
  }
  for (std::size_t i = 0; i < selection_.undergrowth.size(); ++i) {
    const PlantKind& kind = kinds_.undergrowth()[i];
    add(selection_.undergrowth[i], kind.near.front(), kind, {no_finer, selection_.undergrowth_pixels});
  }
  return out;
}

DrawCount PlantRenderer::draw_meshes(const ShaderProgram& program) const {
  std::vector<MeshList> lists = mesh_lists();
  std::vector<MeshDraw> commands;
  for (MeshList& list : lists) {
    list.first_command = commands.size();
    list.commands = add_ordered(*list.mesh, list.plants, selection_.eye, commands);
  }
  stream(mesh_draws_, std::span<const MeshDraw>(commands));
  program.use();
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, mesh_draws_.name());
  DrawCount drawn;
  for (const MeshList& list : lists) {
    program.set("level", list.level);
    set_wood(program, *list.kind);
    glVertexArrayVertexBuffer(list.mesh->array.name(), 1, instances_.name(), GLintptr(list.first * sizeof(PlantInstance)),
                              sizeof(PlantInstance));
    glBindVertexArray(list.mesh->array.name());
    const std::size_t at = list.first_command * sizeof(MeshDraw);
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(at), GLsizei(list.commands), 0);
    ++drawn.draw_calls;
    drawn.triangles += list.plants.size() * std::size_t(list.mesh->index_count / 3);
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  return drawn;
}

DrawCount PlantRenderer::draw_tufts(const ShaderProgram& program) const {
  DrawCount drawn;
  std::size_t first = 0;
  for (const auto* lists : {&selection_.close, &selection_.near, &selection_.mid, &selection_.undergrowth}) {
    for (const auto& list : *lists) first += list.size();
  }
  program.use();
  program.set("fade", glm::vec2(0.08F, 0.75F) * selection_.herb_reach);
  for (const bool near : {true, false}) {
    const auto& lists = near ? selection_.near_tufts : selection_.far_tufts;
    program.set("given", glm::vec2(near ? 1 : -1, 1) * selection_.tuft_change);
    for (std::size_t i = 0; i < lists.size(); ++i) {
      if (lists[i].empty()) continue;
      const PlantKind& kind = kinds_.kinds()[i];
      set_flowers(program, kind);
      draw_instances((near ? kind.near : kind.mid).front(), instances_, first, lists[i].size(), drawn);
      first += lists[i].size();
    }
  }
  return drawn;
}

DrawCount PlantRenderer::draw_far() const {
  DrawCount drawn;
  far_program_.use();
  far_program_.set("picture_side", float(PlantKinds::picture_side()));
  for (std::size_t s = 0; s < selection_.far.size(); ++s) {
    if (selection_.far[s].empty()) continue;
    set_levels(far_program_, selection_.levels[s]);
    drawn.triangles += 2 * draw_blocks(far_array_, arena_, far_draws_, selection_.far[s]);
    ++drawn.draw_calls;
  }
  return drawn;
}

}  // namespace biotope
