#include "render/plant_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/landscape_renderer.hpp"
#include "render/plant_mesh_order.hpp"
#include "render/season.hpp"

namespace biotope {

namespace {

/// Side of the shaded square for an eye near the ground, and for the highest, m.
constexpr double shade_side = 512;
constexpr double most_shade_side = 2048;
constexpr int shade_texels = 1024;
/// The square moves in steps of this part of its side.
constexpr float shade_steps = 16;

/// True when a snapshot under way does not know its plants yet.
bool lacks_plants(const MapsSnapshot& snapshot) {
  return !snapshot.web || snapshot.cover.empty() ||
         std::any_of(snapshot.cover.begin(), snapshot.cover.end(), [](const auto& cover) { return cover == nullptr; });
}

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

/// The same for plants of which each shows its triangles in the order in which the eye meets them.
void draw_ordered(const PlantMeshBuffers& mesh, const Buffer& instances, std::size_t first, std::span<const PlantInstance> plants,
                  const glm::vec3& eye, const Buffer& commands, DrawCount& drawn) {
  std::vector<MeshDraw> runs;
  for (std::size_t i = 0; i < plants.size(); ++i) {
    const auto from = std::uint32_t(mesh_order(plants[i], eye)) * std::uint32_t(mesh.index_count);
    if (runs.empty() || runs.back().first_index != from)
      runs.push_back({std::uint32_t(mesh.index_count), 0, from, 0, std::uint32_t(i)});
    ++runs.back().plants;
  }
  stream(commands, std::span<const MeshDraw>(runs));
  glVertexArrayVertexBuffer(mesh.array.name(), 1, instances.name(), GLintptr(first * sizeof(PlantInstance)),
                            sizeof(PlantInstance));
  glBindVertexArray(mesh.array.name());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands.name());
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr, GLsizei(runs.size()), 0);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  ++drawn.draw_calls;
  drawn.triangles += plants.size() * std::size_t(mesh.index_count / 3);
}

/// Draws a square for plants of the arena; returns how many.
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

}  // namespace

Result<std::unique_ptr<PlantRenderer>> PlantRenderer::create() {
  std::unique_ptr<PlantRenderer> renderer(new PlantRenderer);
  auto kinds = PlantKinds::create();
  if (!kinds) return tl::unexpected(kinds.error());
  renderer->kinds_ = std::move(*kinds);
  struct Wanted {
    ShaderProgram& program;
    const char* name;
  };
  for (const Wanted& wanted :
       {Wanted{renderer->mesh_program_, "landscape/plant_mesh"}, Wanted{renderer->far_program_, "landscape/plant_far"},
        Wanted{renderer->tuft_program_, "landscape/plant_tuft"}, Wanted{renderer->shade_program_, "landscape/plant_shade"}}) {
    auto program = load_shader_program(std::string(wanted.name) + ".vert", std::string(wanted.name) + ".frag");
    if (!program) return tl::unexpected(program.error());
    wanted.program = std::move(*program);
  }
  const std::array<std::string, 1> shadows{"WITH_SHADOWS"};
  for (const Wanted& wanted : {Wanted{renderer->shadowed_mesh_program_, "landscape/plant_mesh"},
                               Wanted{renderer->shadowed_tuft_program_, "landscape/plant_tuft"}}) {
    auto program = load_shader_program(std::string(wanted.name) + ".vert", std::string(wanted.name) + ".frag", shadows);
    if (!program) return tl::unexpected(program.error());
    wanted.program = std::move(*program);
  }
  renderer->instances_ = make_buffer();
  renderer->far_draws_ = make_buffer();
  renderer->mesh_draws_ = make_buffer();
  renderer->shade_draws_ = make_buffer();
  renderer->far_array_ = make_vertex_array();
  instance_attributes(renderer->far_array_);
  renderer->shade_array_ = make_vertex_array();
  instance_attributes(renderer->shade_array_);
  renderer->shade_ = make_texture_2d(GL_R8, shade_texels, shade_texels, 1, {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE});
  renderer->shade_framebuffer_ = make_framebuffer();
  glNamedFramebufferTexture(renderer->shade_framebuffer_.name(), GL_COLOR_ATTACHMENT0, renderer->shade_.name(), 0);
  return renderer;
}

void PlantRenderer::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines,
                                 bool at_once) {
  // Until the plants of an edit are known, those from before it stay in sight.
  const bool waits = snapshot_ && !snapshot->complete && lacks_plants(*snapshot) &&
                     snapshot_->document.species == snapshot->document.species &&
                     same_extent(snapshot_->terrain(), snapshot->terrain());
  if (waits) return;
  const bool new_web = snapshot->web && (!snapshot_ || snapshot_->web != snapshot->web);
  if (new_web) kinds_.set_web(*snapshot->web);
  snapshot_ = snapshot;
  if (at_once) {
    blocks_.set_snapshot(std::move(snapshot), std::move(lines));
  } else {
    blocks_.follow(std::move(snapshot), std::move(lines));
  }
  complete_ = false;
  shaded_area_ = glm::vec4(0);
}

bool PlantRenderer::advance() {
  if (complete_ || !snapshot_) return true;
  return build(std::chrono::steady_clock::now());
}

bool PlantRenderer::build(std::chrono::steady_clock::time_point until) {
  bool complete = true;
  // All of them are begun before one is waited for.
  for (const auto time : {std::min(until, std::chrono::steady_clock::now()), until}) {
    complete = true;
    for (const Stratum stratum : {Stratum::herb, Stratum::tree, Stratum::shrub}) {
      const float reach = prepared_reach_[std::size_t(stratum)];
      if (reach > 0) complete = blocks_.build(stratum, prepared_eye_.x, prepared_eye_.y, reach, time) && complete;
    }
    if (complete) break;
  }
  return complete && !blocks_.following();
}

bool PlantRenderer::sees(Stratum stratum, const PlantBudget& budget, const glm::dvec3& eye) const {
  return eye.z - ground_height(snapshot_->terrain(), eye.x, eye.y) <= budget.reach(stratum);
}

void PlantRenderer::finish_loading(const PlantLook& look, const glm::dvec3& eye) {
  if (!snapshot_) return;
  const PlantBudget budget = PlantBudget::of(look.quality);
  blocks_.set_most_bytes(budget.block_bytes());
  for (const Stratum stratum : {Stratum::herb, Stratum::shrub, Stratum::tree}) {
    if (sees(stratum, budget, eye)) blocks_.build_all(stratum, eye.x, eye.y, budget.reach(stratum));
  }
  UploadBudget upload = UploadBudget::unlimited();
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    arena_.follow(blocks_, stratum, budget.resident, {eye.x, eye.y}, upload);
  }
  shaded_area_ = glm::vec4(0);
}

bool PlantRenderer::prepare(const PlantLook& look, const glm::dvec3& eye, const FrameUniforms& frame, const Frustum& frustum,
                            double budget_ms) {
  if (!snapshot_ || !snapshot_->web) {
    selection_ = {};
    upload_selection();
    return true;
  }
  kinds_.set_quality(look.quality);
  kinds_.set_month(*snapshot_->web, northern_month(look.month, snapshot_->terrain().latitude));
  PlantBudget budget = PlantBudget::of(look.quality);
  // From higher up than one sees trees, the ground shows all of them.
  if (!sees(Stratum::tree, budget, eye)) budget.tree_reach = 0;
  blocks_.set_most_bytes(budget.block_bytes());
  const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(std::int64_t(1000 * budget_ms));
  std::array<float, strata> shading{};
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    if (sees(stratum, budget, eye)) shading[std::size_t(stratum)] = budget.reach(stratum);
  }
  if (std::exchange(shading_reach_, shading) != shading) shaded_area_ = glm::vec4(0);
  prepared_eye_ = eye;
  for (const Stratum stratum : {Stratum::herb, Stratum::tree, Stratum::shrub}) {
    prepared_reach_[std::size_t(stratum)] = sees(stratum, budget, eye) ? budget.reach(stratum) : 0;
  }
  bool complete = build(until);
  UploadBudget upload;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    complete = arena_.follow(blocks_, stratum, budget.resident, {eye.x, eye.y}, upload) && complete;
  }
  // What was built since the last frame casts shade too.
  if (kinds_.set_visible(look.visible) || !complete || !complete_) shaded_area_ = glm::vec4(0);
  complete_ = complete;
  selection_ = select_plants(blocks_, arena_, kinds_, look.visible, budget, frame, frustum);
  upload_selection();
  return complete;
}

void PlantRenderer::upload_selection() {
  std::vector<PlantInstance> all;
  for (const auto* lists : {&selection_.close, &selection_.near, &selection_.mid, &selection_.undergrowth, &selection_.near_tufts,
                            &selection_.far_tufts}) {
    for (const auto& list : *lists) all.insert(all.end(), list.begin(), list.end());
  }
  stream(instances_, std::span<const PlantInstance>(all));
  streamed_bytes_ = all.size() * sizeof(PlantInstance);
}

glm::vec4 PlantRenderer::shade_area(const glm::dvec3& eye, double above) {
  // From higher up one sees more ground, less sharply.
  double side = shade_side;
  while (side < most_shade_side && above > side / 8) side *= 2;
  const double step = side / shade_steps;
  const auto edge = [&](double v) { return float(std::floor((v - 0.5 * side) / step + 0.5) * step); };
  return {edge(eye.x), edge(eye.y), float(side), 1};
}

std::vector<FarDraw> PlantRenderer::shading_blocks(const glm::vec4& area) const {
  std::vector<FarDraw> out;
  constexpr float longest_shadow = 120;
  constexpr float margin = woody_block_side + longest_shadow;
  const glm::vec2 middle = glm::vec2(area) + 0.5F * area.z;
  // Blocks that are there from wherever in the area one looks, and not those that are left from an earlier view.
  const float snapped = 0.7072F * area.z / shade_steps;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    for (const auto& [place, resident] : arena_.places(stratum)) {
      const glm::vec2 corner(float(place.second) * woody_block_side, float(place.first) * woody_block_side);
      if (glm::length(corner + 0.5F * woody_block_side - middle) > shading_reach_[std::size_t(stratum)] - snapped) continue;
      if (corner.x < area.x - margin || corner.y < area.y - margin) continue;
      if (corner.x > area.x + area.z + longest_shadow || corner.y > area.y + area.z + longest_shadow) continue;
      if (resident.run.count > 0) out.push_back({4, resident.run.count, 0, resident.run.first});
    }
  }
  return out;
}

DrawCount PlantRenderer::draw_shade(const glm::vec4& area, const glm::vec3& light_direction) {
  glBindTextureUnit(TerrainRenderer::canopy_shade_unit, shade_.name());
  if (shaded_area_ == area && glm::dot(shaded_light_, light_direction) > 0.99998F) return {};
  shaded_area_ = area;
  shaded_light_ = light_direction;
  const std::vector<FarDraw> blocks = shading_blocks(area);
  const DrawnElsewhere elsewhere(shade_texels, shade_texels);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shade_framebuffer_.name());
  constexpr std::array<float, 4> clear{0, 0, 0, 0};
  glClearNamedFramebufferfv(shade_framebuffer_.name(), GL_COLOR, 0, clear.data());
  kinds_.bind();
  shade_program_.use();
  shade_program_.set("area", area);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  // Light that comes through one crown may meet another.
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  glBindVertexArray(shade_array_.name());
  const std::size_t plants = draw_blocks(shade_array_, arena_, shade_draws_, blocks);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  return {1, 2 * plants};
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

DrawCount PlantRenderer::draw_meshes(const ShaderProgram& program) const {
  DrawCount drawn;
  program.use();
  std::size_t first = 0;
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
    program.set("level", level.pixels);
    for (std::size_t i = 0; i < level.lists.size(); ++i) {
      if (level.lists[i].empty()) continue;
      const PlantKind& kind = kinds_.kinds()[i / plant_models];
      set_wood(program, kind);
      draw_ordered((kind.*level.meshes)[i % plant_models], instances_, first, level.lists[i], selection_.eye, mesh_draws_, drawn);
      first += level.lists[i].size();
    }
  }
  program.set("level", glm::vec2(no_finer, selection_.undergrowth_pixels));
  for (std::size_t i = 0; i < selection_.undergrowth.size(); ++i) {
    const auto& list = selection_.undergrowth[i];
    if (list.empty()) continue;
    set_wood(program, kinds_.undergrowth()[i]);
    draw_instances(kinds_.undergrowth()[i].near.front(), instances_, first, list.size(), drawn);
    first += list.size();
  }
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
