#include "render/plant_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/landscape_renderer.hpp"
#include "render/season.hpp"

namespace biotope {

namespace {

/// Side of the shaded square for an eye near the ground, and for the highest, m.
constexpr double shade_side = 512;
constexpr double most_shade_side = 2048;
constexpr int shade_texels = 1024;
constexpr auto ever = std::chrono::steady_clock::time_point::max();
/// The square moves in steps of this part of its side.
constexpr float shade_steps = 16;

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
  const MapsSnapshot* last = coming_ ? coming_->snapshot.get() : snapshot_.get();
  const bool waits = last != nullptr && !snapshot->complete && lacks_plants(*snapshot) &&
                     last->document.species == snapshot->document.species && same_extent(last->terrain(), snapshot->terrain());
  if (waits) return;
  const bool same_models = !snapshot->web || (snapshot_ && same_plants(*snapshot_, *snapshot));
  if (!same_models) {
    if (!coming_ || !same_plants(*coming_->snapshot, *snapshot)) {
      made_ = nullptr;
      models_.start(snapshot->web);
    }
    coming_ = Coming{std::move(snapshot), std::move(lines)};
    // Plants of other kinds mean nothing any more; until the new ones are there the ground shows where they grow.
    snapshot_ = nullptr;
    blocks_.leave();
    if (at_once) static_cast<void>(follow_models(ever, UploadBudget::unlimited()));
    return;
  }
  coming_.reset();
  show(std::move(snapshot), std::move(lines), at_once);
}

void PlantRenderer::show(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines, bool at_once) {
  snapshot_ = snapshot;
  if (at_once) {
    blocks_.set_snapshot(std::move(snapshot), std::move(lines));
  } else {
    blocks_.follow(std::move(snapshot), std::move(lines));
  }
  complete_ = false;
  shaded_area_ = glm::vec4(0);
}

bool PlantRenderer::follow_models(std::chrono::steady_clock::time_point until, UploadBudget upload) {
  if (!coming_) return true;
  if (!made_) {
    made_ = models_.take(until);
    if (!made_) return false;
    kinds_.take(made_);
  }
  if (!kinds_.upload(upload)) return false;
  models_.retire(std::exchange(made_, nullptr));
  const Coming shown = *std::exchange(coming_, std::nullopt);
  show(shown.snapshot, shown.lines, until == ever);
  return true;
}

bool PlantRenderer::advance() {
  const bool models = follow_models(std::chrono::steady_clock::now(), UploadBudget());
  if (complete_ || !snapshot_) return models;
  return build(std::chrono::steady_clock::now()) && models;
}

bool PlantRenderer::build(std::chrono::steady_clock::time_point until) {
  bool complete = !coming_;
  if (!snapshot_) return complete;
  // All of them are begun before one is waited for.
  for (const auto time : {std::min(until, std::chrono::steady_clock::now()), until}) {
    complete = !coming_;
    for (const Stratum stratum : {Stratum::herb, Stratum::tree, Stratum::shrub}) {
      const float reach = prepared_reach_[std::size_t(stratum)];
      if (reach > 0) complete = blocks_.build(stratum, prepared_eye_.x, prepared_eye_.y, reach, time, true) && complete;
    }
    if (complete) break;
  }
  return complete && !blocks_.following();
}

bool PlantRenderer::sees(Stratum stratum, const PlantBudget& budget, const glm::dvec3& eye) const {
  return eye.z - ground_height(snapshot_->terrain(), eye.x, eye.y) <= budget.reach(stratum);
}

void PlantRenderer::finish_loading(const PlantLook& look, const glm::dvec3& eye) {
  static_cast<void>(follow_models(ever, UploadBudget::unlimited()));
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
    shading_reach_ = {};
    shaded_area_ = glm::vec4(0);
    woody_.follow(blocks_, arena_);
    upload_selection();
    return !coming_;
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
  woody_.follow(blocks_, arena_);
  selection_ = select_plants(blocks_, woody_, kinds_, look.visible, budget, frame, frustum);
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

}  // namespace biotope
