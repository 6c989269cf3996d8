#include "render/terrain_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/detail_noise.hpp"

namespace biotope {

namespace {

constexpr int patch_cells = ground_patch_cells;
/// Side of the finest quads on coarse grids, m.
constexpr double coarsest_quad = 10;
/// Quality from which on small things are drawn: stones, rock seen from the side, sunken trails, glitter, small ripples.
constexpr float detailed_quality = 0.75F;
constexpr GLuint currents_unit = 11;

Texture upload_rgba(const Grid<Rgba>& texels, const Sampling& sampling) {
  Texture texture = make_texture_2d(GL_RGBA8, texels.width(), texels.height(), 0, sampling);
  glTextureSubImage2D(texture.name(), 0, 0, 0, texels.width(), texels.height(), GL_RGBA, GL_UNSIGNED_BYTE, texels.cells().data());
  glGenerateTextureMipmap(texture.name());
  return texture;
}

}  // namespace

Result<std::unique_ptr<TerrainRenderer>> TerrainRenderer::create() {
  std::unique_ptr<TerrainRenderer> renderer(new TerrainRenderer);
  constexpr std::array<const char*, 8> surfaces{"dry_near_low", "wet_near_low", "dry_far_low", "wet_far_low",
                                                "dry_near",     "wet_near",     "dry_far",     "wet_far"};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::string file = std::string("landscape/terrain_") + surfaces[i] + ".frag";
    const std::array<std::string, 1> less{"WITH_LESS"};
    auto program = load_shader_program("landscape/terrain.vert", file, std::span(less).first(i < 4 ? 1 : 0));
    if (!program) return tl::unexpected(program.error());
    renderer->programs_[i] = std::move(*program);
    if (i < 4) continue;
    const std::array<std::string, 1> shadows{"WITH_SHADOWS"};
    auto shadowed = load_shader_program("landscape/terrain.vert", file, shadows);
    if (!shadowed) return tl::unexpected(shadowed.error());
    renderer->programs_[i + 4] = std::move(*shadowed);
  }
  const std::array<std::string, 2> alone{"WITH_LESS", "WATER_ALONE"};
  auto water = load_shader_program("landscape/terrain.vert", "landscape/terrain_water_low.frag", alone);
  if (!water) return tl::unexpected(water.error());
  renderer->water_program_ = std::move(*water);
  renderer->detail_ = upload_rgba(detail_noise(), {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT});
  renderer->make_patch();
  return renderer;
}

void TerrainRenderer::make_patch() {
  std::vector<glm::vec2> corners;
  std::vector<std::uint16_t> indices;
  for (int y = 0; y <= patch_cells; ++y) {
    for (int x = 0; x <= patch_cells; ++x) corners.emplace_back(float(x) / patch_cells, float(y) / patch_cells);
  }
  const auto corner = [](int x, int y) { return std::uint16_t(y * (patch_cells + 1) + x); };
  for (int y = 0; y < patch_cells; ++y) {
    for (int x = 0; x < patch_cells; ++x) {
      for (const auto i :
           {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)}) {
        indices.push_back(i);
      }
    }
  }
  patch_index_count_ = GLsizei(indices.size());
  patch_vertices_ = make_static_buffer(std::as_bytes(std::span(corners)));
  patch_indices_ = make_static_buffer(std::as_bytes(std::span(indices)));
  patch_instances_ = make_buffer();
  patch_array_ = make_vertex_array();
  glVertexArrayElementBuffer(patch_array_.name(), patch_indices_.name());
  glVertexArrayVertexBuffer(patch_array_.name(), 0, patch_vertices_.name(), 0, sizeof(glm::vec2));
  glVertexArrayVertexBuffer(patch_array_.name(), 1, patch_instances_.name(), 0, sizeof(GroundPatch));
  glVertexArrayBindingDivisor(patch_array_.name(), 1, 1);
  float_attribute(patch_array_, 0, 0, 2, 0);
  float_attribute(patch_array_, 1, 1, 4, 0);
}

void TerrainRenderer::ask(const TerrainLook& look, const glm::vec3& light_direction) {
  GroundRequest wanted{snapshot_, look.month, look.visible, light_direction};
  if (asked_ && same_request(*asked_, wanted)) return;
  asked_ = wanted;
  maker_.request(std::move(wanted));
}

void TerrainRenderer::take(std::shared_ptr<const GroundPicture> picture) {
  coming_ = std::move(picture);
  if (!coming_) return;
  // Whoever holds a part holds the picture: it is then freed as a whole, by the thread that made it.
  const auto part = [&](const auto& texels) { return std::shared_ptr<const std::decay_t<decltype(texels)>>(coming_, &texels); };
  heights_.want(part(coming_->shape->heights));
  normals_.want(part(coming_->shape->normals));
  ground_.want(part(coming_->tints->ground));
  canopy_.want(part(coming_->tints->canopy));
  lines_.want(part(coming_->lines->lines));
  currents_.want(part(coming_->lines->currents));
  sunlit_.want(part(coming_->light->sunlit));
}

bool TerrainRenderer::upload(UploadBudget& budget) {
  const bool there = heights_.upload(budget) && normals_.upload(budget) && ground_.upload(budget) && canopy_.upload(budget) &&
                     lines_.upload(budget) && currents_.upload(budget) && sunlit_.upload(budget);
  if (!there) return false;
  heights_.show();
  normals_.show();
  ground_.show();
  canopy_.show();
  lines_.show();
  currents_.show();
  sunlit_.show();
  maker_.retire(std::exchange(shown_, std::exchange(coming_, nullptr)));
  return true;
}

bool TerrainRenderer::prepare(const TerrainLook& look, const glm::vec3& light_direction) {
  ask(look, light_direction);
  const bool busy = maker_.busy();
  UploadBudget budget;
  heights_.tidy(budget);
  normals_.tidy(budget);
  ground_.tidy(budget);
  canopy_.tidy(budget);
  lines_.tidy(budget);
  currents_.tidy(budget);
  sunlit_.tidy(budget);
  while (true) {
    if (!coming_) take(maker_.take());
    if (!coming_) return !busy;
    if (!upload(budget)) return false;
  }
}

void TerrainRenderer::finish(const TerrainLook& look, const glm::vec3& light_direction) {
  ask(look, light_direction);
  maker_.wait_idle();
  UploadBudget budget = UploadBudget::unlimited();
  do {
    if (coming_) upload(budget);
    take(maker_.take());
  } while (coming_);
}

void TerrainRenderer::bind_shared() const {
  glBindTextureUnit(0, heights_.name());
  glBindTextureUnit(2, ground_.name());
  glBindTextureUnit(3, detail_.name());
  glBindTextureUnit(6, sunlit_.name());
}

void TerrainRenderer::bind_ground(const TerrainLook& look) const {
  bind_shared();
  glBindTextureUnit(1, normals_.name());
  glBindTextureUnit(4, canopy_.name());
  glBindTextureUnit(5, lines_.name());
  glBindTextureUnit(currents_unit, currents_.name());
  for (const GLuint texture : {normals_.name(), ground_.name(), canopy_.name(), lines_.name(), detail_.name()}) {
    mix_mipmaps(texture, look.quality >= detailed_quality);
  }
}

DrawCount TerrainRenderer::draw(const TerrainLook& look, const glm::dvec3& eye, const Frustum& frustum) const {
  const Terrain& terrain = shown_->terrain();
  PatchSettings settings;
  settings.patch_cells = patch_cells;
  settings.range_factor = std::clamp(4.2F * look.quality, 3.0F, 9.0F);
  settings.width = terrain.width_metres();
  settings.height = terrain.height_metres();
  // Coarse grids are drawn with finer quads than their cells, so that the ground is where ground_height says it is.
  settings.finest_side = patch_cells * std::min(terrain.cell_size, coarsest_quad);
  std::array<std::vector<GroundPatch>, 4> by_variant;
  for (const GroundPatch& patch : select_patches(settings, shown_->shape->bounds, eye, frustum)) {
    by_variant[std::size_t(variant(patch, look, eye))].push_back(patch);
  }
  std::vector<GroundPatch> patches;
  for (const auto& list : by_variant) patches.insert(patches.end(), list.begin(), list.end());
  stream(patch_instances_, std::span<const GroundPatch>(patches));

  bind_ground(look);
  glBindVertexArray(patch_array_.name());
  DrawCount drawn;
  std::size_t first = 0;
  const std::size_t detailed = look.shadows ? 8 : look.quality >= detailed_quality ? 4 : 0;
  std::array<std::size_t, 4> firsts{};
  const auto draw_variant = [&](std::size_t i, const ShaderProgram& program) {
    const std::size_t count = by_variant[i].size();
    if (count == 0) return;
    draw_patches(program, look, firsts[i], count);
    ++drawn.draw_calls;
    drawn.triangles += count * std::size_t(patch_index_count_ / 3);
  };
  for (std::size_t i = 0; i < by_variant.size(); ++i) {
    firsts[i] = first;
    first += by_variant[i].size();
    draw_variant(i, programs_[i + detailed]);
  }
  if (detailed == 0 && look.water) {
    // Over the ground as it lies: depths that are equal.
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthFunc(GL_LEQUAL);
    for (const std::size_t i : {1U, 3U}) draw_variant(i, water_program_);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
  }
  return drawn;
}

void TerrainRenderer::draw_patches(const ShaderProgram& program, const TerrainLook& look, std::size_t first,
                                   std::size_t count) const {
  set_look(program, look);
  program.use();
  glDrawElementsInstancedBaseInstance(GL_TRIANGLES, patch_index_count_, GL_UNSIGNED_SHORT, nullptr, GLsizei(count),
                                      GLuint(first));
}

int TerrainRenderer::variant(const GroundPatch& patch, const TerrainLook& look, const glm::dvec3& eye) const {
  const glm::vec2 middle(patch.west + 0.5F * patch.side, patch.south + 0.5F * patch.side);
  const glm::vec2 heights = shown_->shape->bounds.of(patch.west, patch.south, patch.side);
  const glm::vec3 offset = glm::vec3(middle, 0.5F * (heights.x + heights.y)) - glm::vec3(eye);
  const float farthest = glm::length(offset) + glm::length(glm::vec3(patch.side, patch.side, heights.y - heights.x)) * 0.5F;
  // Beyond the border no plants are drawn: there crowns are painted from near on.
  const Terrain& terrain = shown_->terrain();
  const bool beyond = patch.west < 0 || patch.south < 0 || patch.west + patch.side > float(terrain.width_metres()) ||
                      patch.south + patch.side > float(terrain.height_metres());
  const bool canopy = look.canopy_strength > 0 && (beyond || farthest > look.canopy_from);
  bool water = false;
  if (look.water) {
    const Grid<std::uint8_t>& near_water = shown_->lines->near_water;
    const float square = patch_cells * float(shown_->terrain().cell_size);
    const int x0 = int(std::floor(patch.west / square + 0.5F));
    const int y0 = int(std::floor(patch.south / square + 0.5F));
    const int count = std::max(1, int(std::lround(patch.side / square)));
    // Beyond the border the ground is mirrored: there every patch counts as wet.
    water = x0 < 0 || y0 < 0 || x0 + count > near_water.width() || y0 + count > near_water.height();
    for (int y = y0; y < y0 + count && !water; ++y) {
      for (int x = x0; x < x0 + count && !water; ++x) water = near_water(x, y) != 0;
    }
  }
  return (water ? 1 : 0) + (canopy ? 2 : 0);
}

void TerrainRenderer::set_look(const ShaderProgram& program, const TerrainLook& look) const {
  program.set("patch_cells", float(patch_cells));
  program.set("canopy_range", glm::vec4(look.canopy_from, look.canopy_whole, look.canopy_strength, 0));
  program.set("show", glm::vec4(look.water ? 1 : 0, look.trails ? 1 : 0, 0, 0));
  program.set("mirror", look.mirrored ? glm::vec3(*look.mirrored, 1) : glm::vec3(1, 2, 0));
  program.set("brush", look.brush ? glm::vec4(*look.brush, 1) : glm::vec4(0));
}

}  // namespace biotope
