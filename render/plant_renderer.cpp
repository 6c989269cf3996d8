#include "render/plant_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "render/landscape_renderer.hpp"

namespace biotope {

namespace {

/// Side of the shaded square for an eye near the ground, and for the highest, m.
constexpr double shade_side = 512;
constexpr double most_shade_side = 2048;
constexpr int shade_texels = 1024;

/// True when a snapshot under way does not know its plants yet.
bool lacks_plants(const MapsSnapshot& snapshot) {
  return !snapshot.web || snapshot.cover.empty() ||
         std::any_of(snapshot.cover.begin(), snapshot.cover.end(), [](const auto& cover) { return cover == nullptr; });
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
        Wanted{renderer->shade_program_, "landscape/plant_shade"}}) {
    auto program = load_shader_program(std::string(wanted.name) + ".vert", std::string(wanted.name) + ".frag");
    if (!program) return tl::unexpected(program.error());
    wanted.program = std::move(*program);
  }
  renderer->instances_ = make_buffer();
  renderer->shade_instances_ = make_buffer();
  renderer->far_array_ = make_vertex_array();
  instance_attributes(renderer->far_array_);
  renderer->shade_array_ = make_vertex_array();
  instance_attributes(renderer->shade_array_);
  renderer->shade_ = make_texture_2d(GL_R8, shade_texels, shade_texels, 1, {GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE});
  renderer->shade_framebuffer_ = make_framebuffer();
  glNamedFramebufferTexture(renderer->shade_framebuffer_.name(), GL_COLOR_ATTACHMENT0, renderer->shade_.name(), 0);
  return renderer;
}

void PlantRenderer::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines) {
  // Until the plants of an edit are known, those from before it stay in sight.
  const bool waits = snapshot_ && !snapshot->complete && lacks_plants(*snapshot) &&
                     snapshot_->document.species == snapshot->document.species &&
                     same_extent(snapshot_->terrain(), snapshot->terrain());
  if (waits) return;
  const bool new_web = snapshot->web && (!snapshot_ || snapshot_->web != snapshot->web);
  if (new_web) kinds_.set_web(*snapshot->web);
  snapshot_ = snapshot;
  blocks_.set_snapshot(std::move(snapshot), std::move(lines));
  shaded_area_ = glm::vec4(0);
}

bool PlantRenderer::sees(Stratum stratum, const PlantBudget& budget, const glm::dvec3& eye) const {
  return eye.z - ground_height(snapshot_->terrain(), eye.x, eye.y) <= budget.reach(stratum);
}

void PlantRenderer::finish_loading(const PlantLook& look, const glm::dvec3& eye) {
  if (!snapshot_) return;
  const PlantBudget budget = PlantBudget::of(look.quality);
  for (const Stratum stratum : {Stratum::herb, Stratum::shrub, Stratum::tree}) {
    if (sees(stratum, budget, eye)) blocks_.build_all(stratum, eye.x, eye.y, budget.reach(stratum));
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
  kinds_.set_month(*snapshot_->web, look.month);
  const PlantBudget budget = PlantBudget::of(look.quality);
  const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(std::int64_t(1000 * budget_ms));
  bool complete = true;
  for (const Stratum stratum : {Stratum::herb, Stratum::tree, Stratum::shrub}) {
    if (sees(stratum, budget, eye)) complete = blocks_.build(stratum, eye.x, eye.y, budget.reach(stratum), until) && complete;
  }
  // What was built since the last frame casts shade too.
  if (!complete || !complete_ || visible_ != look.visible) shaded_area_ = glm::vec4(0);
  complete_ = complete;
  visible_ = look.visible;
  selection_ = select_plants(blocks_, kinds_.kinds(), look.visible, budget, frame, frustum);
  upload_selection();
  return complete;
}

void PlantRenderer::upload_selection() {
  std::vector<PlantInstance> all;
  all.reserve(selection_.count);
  for (const auto* lists : {&selection_.near, &selection_.mid}) {
    for (const auto& list : *lists) all.insert(all.end(), list.begin(), list.end());
  }
  all.insert(all.end(), selection_.far.begin(), selection_.far.end());
  stream(instances_, std::span<const PlantInstance>(all));
  instance_bytes_ = all.size() * sizeof(PlantInstance);
}

glm::vec4 PlantRenderer::shade_area(const glm::dvec3& eye, double above) {
  // From higher up one sees more ground, less sharply.
  double side = shade_side;
  while (side < most_shade_side && above > side / 8) side *= 2;
  const double step = side / 16;
  const auto edge = [&](double v) { return float(std::floor((v - 0.5 * side) / step + 0.5) * step); };
  return {edge(eye.x), edge(eye.y), float(side), 0.72F};
}

std::vector<PlantInstance> PlantRenderer::shading_plants(const glm::vec4& area) const {
  std::vector<PlantInstance> out;
  constexpr float longest_shadow = 60;
  constexpr float margin = woody_block_side + longest_shadow;
  for (const Stratum stratum : {Stratum::tree, Stratum::shrub}) {
    for (const auto& [place, block] : blocks_.blocks(stratum)) {
      const glm::vec2 corner(float(place.second) * woody_block_side, float(place.first) * woody_block_side);
      if (corner.x < area.x - margin || corner.y < area.y - margin) continue;
      if (corner.x > area.x + area.z + longest_shadow || corner.y > area.y + area.z + longest_shadow) continue;
      for (const PlantInstance& plant : block.plants) {
        const auto kind = std::size_t(plant.plant);
        if (kind >= kinds_.kinds().size()) continue;
        const auto species = std::size_t(kinds_.kinds()[kind].species);
        if (species >= visible_.size() || visible_[species]) out.push_back(plant);
      }
    }
  }
  return out;
}

DrawCount PlantRenderer::draw_shade(const glm::vec4& area, const glm::vec3& light_direction) {
  glBindTextureUnit(TerrainRenderer::canopy_shade_unit, shade_.name());
  if (shaded_area_ == area && glm::dot(shaded_light_, light_direction) > 0.99998F) return {};
  shaded_area_ = area;
  shaded_light_ = light_direction;
  const std::vector<PlantInstance> plants = shading_plants(area);
  stream(shade_instances_, std::span<const PlantInstance>(plants));
  const DrawnElsewhere elsewhere(shade_texels, shade_texels);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shade_framebuffer_.name());
  constexpr std::array<float, 4> clear{0, 0, 0, 0};
  glClearNamedFramebufferfv(shade_framebuffer_.name(), GL_COLOR, 0, clear.data());
  kinds_.bind();
  shade_program_.use();
  shade_program_.set("area", area);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  glBindVertexArray(shade_array_.name());
  glVertexArrayVertexBuffer(shade_array_.name(), 1, shade_instances_.name(), 0, sizeof(PlantInstance));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(plants.size()));
  glBlendEquation(GL_FUNC_ADD);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  return {1, 2 * plants.size()};
}

DrawCount PlantRenderer::draw() const {
  kinds_.bind();
  const DrawCount meshes = draw_meshes();
  const DrawCount far = draw_far();
  return {meshes.draw_calls + far.draw_calls, meshes.triangles + far.triangles};
}

DrawCount PlantRenderer::draw_meshes() const {
  DrawCount drawn;
  mesh_program_.use();
  std::size_t first = 0;
  for (const bool near : {true, false}) {
    const auto& lists = near ? selection_.near : selection_.mid;
    for (std::size_t i = 0; i < lists.size(); ++i) {
      if (lists[i].empty()) continue;
      const PlantKind& kind = kinds_.kinds()[i];
      const PlantMeshBuffers& mesh = near ? kind.near : kind.mid;
      set_colours(mesh_program_, kind);
      mesh_program_.set("under_crowns", kind.stratum == Stratum::herb ? 1.0F : 0.0F);
      glVertexArrayVertexBuffer(mesh.array.name(), 1, instances_.name(), GLintptr(first * sizeof(PlantInstance)),
                                sizeof(PlantInstance));
      glBindVertexArray(mesh.array.name());
      glDrawElementsInstanced(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_SHORT, nullptr, GLsizei(lists[i].size()));
      ++drawn.draw_calls;
      drawn.triangles += lists[i].size() * std::size_t(mesh.index_count / 3);
      first += lists[i].size();
    }
  }
  return drawn;
}

DrawCount PlantRenderer::draw_far() const {
  if (selection_.far.empty()) return {};
  const std::size_t first = instance_bytes_ / sizeof(PlantInstance) - selection_.far.size();
  far_program_.use();
  far_program_.set("picture_side", float(PlantKinds::picture_side()));
  glVertexArrayVertexBuffer(far_array_.name(), 1, instances_.name(), GLintptr(first * sizeof(PlantInstance)),
                            sizeof(PlantInstance));
  glBindVertexArray(far_array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(selection_.far.size()));
  return {1, 2 * selection_.far.size()};
}

}  // namespace biotope
