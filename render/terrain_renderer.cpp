#include "render/terrain_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/detail_noise.hpp"
#include "render/line_field.hpp"
#include "render/terrain_shadow.hpp"

namespace biotope {

namespace {

constexpr int patch_cells = 16;
/// Side of the finest quads on coarse grids, m.
constexpr double coarsest_quad = 10;
/// Longest side of a ground texture, texels.
constexpr int longest_texture = 2048;
/// Longest side of the texture of shores and trails where it is finer than the terrain: finer costs a software renderer too long.
constexpr int longest_lines = 2048;
/// Longest side of the grid on which shadows are swept, cells.
constexpr int longest_shadow = 1024;

constexpr Sampling mirrored_mipmapped{GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT};
constexpr Sampling mirrored{GL_LINEAR, GL_LINEAR, GL_MIRRORED_REPEAT};

Texture upload_rgba(const Grid<Rgba>& texels, const Sampling& sampling) {
  Texture texture = make_texture_2d(GL_RGBA8, texels.width(), texels.height(), 0, sampling);
  glTextureSubImage2D(texture.name(), 0, 0, 0, texels.width(), texels.height(), GL_RGBA, GL_UNSIGNED_BYTE, texels.cells().data());
  glGenerateTextureMipmap(texture.name());
  return texture;
}

}  // namespace

Result<std::unique_ptr<TerrainRenderer>> TerrainRenderer::create() {
  std::unique_ptr<TerrainRenderer> renderer(new TerrainRenderer);
  constexpr std::array<const char*, 4> surfaces{"dry_near", "wet_near", "dry_far", "wet_far"};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    auto program = load_shader_program("landscape/terrain.vert", std::string("landscape/terrain_") + surfaces[i] + ".frag");
    if (!program) return tl::unexpected(program.error());
    renderer->programs_[i] = std::move(*program);
  }
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

void TerrainRenderer::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot) {
  const MapsSnapshot* before = snapshot_.get();
  const bool first = before == nullptr;
  const bool ground = first || before->document.terrain != snapshot->document.terrain;
  const bool water = first || before->hydrology != snapshot->hydrology;
  const bool trails = first || before->trails != snapshot->trails;
  whole_ = whole_ || ground;
  surface_stale_ = surface_stale_ || ground || water || trails;
  lines_stale_ = lines_stale_ || ground || water || trails;
  colours_stale_ = colours_stale_ || ground || water || before->environment != snapshot->environment ||
                   before->derivatives != snapshot->derivatives || before->web != snapshot->web ||
                   before->cover.size() != snapshot->cover.size();
  snapshot_ = std::move(snapshot);
}

bool TerrainRenderer::prepare(const TerrainLook& look, const glm::vec3& light_direction) {
  const bool whole = std::exchange(whole_, false);
  if (surface_stale_) {
    make_surface();
    shade_stale_ = true;
    if (!whole) return false;
  }
  if (lines_stale_) {
    make_lines();
    if (!whole) return false;
  }
  colour(look);
  if (shade_stale_ || glm::dot(shaded_light_, light_direction) < 0.99998F) shade(light_direction);
  return true;
}

void TerrainRenderer::make_surface() {
  surface_stale_ = false;
  surface_ = visible_surface(*snapshot_);
  const double cell_size = snapshot_->terrain().cell_size;
  const int longest = std::max(surface_.width(), surface_.height());
  stride_ = (longest + longest_texture - 1) / longest_texture;
  bounds_ = HeightBounds(surface_, cell_size, patch_cells);
  const Grid<float> thin = stride_ > 1 ? thinned(surface_, stride_) : Grid<float>();
  const Grid<float>& shown = stride_ > 1 ? thin : surface_;
  heights_ = make_texture_2d(GL_R32F, shown.width(), shown.height(), 1, mirrored);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(heights_.name(), 0, 0, 0, shown.width(), shown.height(), GL_RED, GL_FLOAT, shown.cells().data());
  normals_ = upload_rgba(surface_normals(shown, cell_size * stride_), mirrored_mipmapped);
  const int shadow_stride = std::max(1, (longest + longest_shadow - 1) / longest_shadow);
  thin_surface_ = shadow_stride > 1 ? thinned(surface_, shadow_stride) : surface_;
}

void TerrainRenderer::make_shore() {
  const Terrain& terrain = snapshot_->terrain();
  shore_of_ = snapshot_->hydrology;
  shore_.scale = line_field_scale(terrain.height.width(), terrain.height.height(), longest_lines);
  shore_.codes = shore_of_ ? shore_field(terrain, *shore_of_, shore_.scale)
                           : Grid<std::uint8_t>(terrain.height.width() * shore_.scale, terrain.height.height() * shore_.scale, 0);
}

void TerrainRenderer::make_lines() {
  lines_stale_ = false;
  const Terrain& terrain = snapshot_->terrain();
  const bool fits = shore_.codes.width() == terrain.height.width() * shore_.scale && shore_.codes.height() == terrain.height.height() * shore_.scale;
  if (!fits || shore_.codes.empty() || shore_of_ != snapshot_->hydrology) make_shore();
  const int scale = shore_.scale;
  const Grid<std::uint8_t>& shore = shore_.codes;
  const int width = shore.width();
  const int height = shore.height();
  const Grid<std::uint8_t> wear =
      snapshot_->trails ? wear_field(terrain, *snapshot_->trails, scale) : Grid<std::uint8_t>(width, height, 0);
  near_water_ = Grid<std::uint8_t>((terrain.height.width() + patch_cells - 1) / patch_cells,
                                   (terrain.height.height() + patch_cells - 1) / patch_cells, 0);
  std::vector<std::uint8_t> both(shore.size() * 2);
  for (std::size_t i = 0; i < shore.size(); ++i) {
    both[2 * i] = shore[i];
    both[2 * i + 1] = wear[i];
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (shore(x, y) > 0) near_water_(x / scale / patch_cells, (terrain.height.height() - 1 - y / scale) / patch_cells) = 1;
    }
  }
  lines_ = make_texture_2d(GL_RG8, width, height, 0, mirrored_mipmapped);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(lines_.name(), 0, 0, 0, width, height, GL_RG, GL_UNSIGNED_BYTE, both.data());
  glGenerateTextureMipmap(lines_.name());
}

std::vector<Rect> TerrainRenderer::changed_texels() const {
  std::vector<Rect> changed;
  if (snapshot_->cover.empty() || coloured_ == snapshot_) return changed;
  // All covers have the terrain's size, so a tile's number means the same place in each.
  const auto sized =
      std::find_if(snapshot_->cover.begin(), snapshot_->cover.end(), [](const auto& map) { return map != nullptr; });
  if (sized == snapshot_->cover.end()) return changed;
  for (std::size_t tile = 0; tile < (*sized)->tile_count(); ++tile) {
    bool differs = false;
    for (std::size_t i = 0; i < snapshot_->cover.size() && !differs; ++i) {
      const auto& now = snapshot_->cover[i];
      const auto& then = coloured_->cover[i];
      if (now == then) continue;
      differs = !now || !then || now->tile_count() != then->tile_count() || now->tile(tile) != then->tile(tile);
    }
    if (!differs) continue;
    const Rect cells = (*sized)->tile_rect(tile);
    changed.push_back(intersection(
        {cells.x0 / stride_, cells.y0 / stride_, (cells.x1 + stride_ - 1) / stride_, (cells.y1 + stride_ - 1) / stride_},
        colours_.ground.rect()));
  }
  return changed;
}

void TerrainRenderer::colour(const TerrainLook& look) {
  const bool all = colours_stale_ || !coloured_ || coloured_month_ != look.month || coloured_visible_ != look.visible;
  const Grid<float>& height = snapshot_->terrain().height;
  const int width = height.width() / stride_;
  const int rows = height.height() / stride_;
  if (all && (!ground_ || colours_.ground.width() != width || colours_.ground.height() != rows)) {
    colours_ = {stride_, Grid<Rgba>(width, rows), Grid<Rgba>(width, rows)};
    ground_ = make_texture_2d(GL_RGBA8, width, rows, 0, mirrored_mipmapped);
    canopy_ = make_texture_2d(GL_RGBA8, width, rows, 0, mirrored_mipmapped);
  }
  const std::vector<Rect> stale = all ? std::vector<Rect>{Rect{0, 0, width, rows}} : changed_texels();
  for (const Rect& texels : stale) {
    colour_ground(*snapshot_, look.month, look.visible, texels, colours_);
    upload_colours(texels);
  }
  if (!stale.empty()) {
    glGenerateTextureMipmap(ground_.name());
    glGenerateTextureMipmap(canopy_.name());
  }
  coloured_ = snapshot_;
  coloured_month_ = look.month;
  coloured_visible_ = look.visible;
  colours_stale_ = false;
}

void TerrainRenderer::upload_colours(const Rect& texels) {
  glPixelStorei(GL_UNPACK_ROW_LENGTH, colours_.ground.width());
  glTextureSubImage2D(ground_.name(), 0, texels.x0, texels.y0, texels.width(), texels.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                      &colours_.ground(texels.x0, texels.y0));
  glTextureSubImage2D(canopy_.name(), 0, texels.x0, texels.y0, texels.width(), texels.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                      &colours_.canopy(texels.x0, texels.y0));
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void TerrainRenderer::shade(const glm::vec3& light_direction) {
  shade_stale_ = false;
  shaded_light_ = light_direction;
  const double cell = snapshot_->terrain().width_metres() / thin_surface_.width();
  const Grid<std::uint8_t> lit = sweep_shadows(thin_surface_, cell, light_direction, 1.0F + 0.35F * float(cell));
  sunlit_ = make_texture_2d(GL_R8, lit.width(), lit.height(), 1, mirrored);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(sunlit_.name(), 0, 0, 0, lit.width(), lit.height(), GL_RED, GL_UNSIGNED_BYTE, lit.cells().data());
}

void TerrainRenderer::bind_shared() const {
  glBindTextureUnit(0, heights_.name());
  glBindTextureUnit(3, detail_.name());
  glBindTextureUnit(6, sunlit_.name());
}

DrawCount TerrainRenderer::draw(const TerrainLook& look, const glm::dvec3& eye, const Frustum& frustum) const {
  const Terrain& terrain = snapshot_->terrain();
  PatchSettings settings;
  settings.patch_cells = patch_cells;
  settings.range_factor = std::clamp(4.2F * look.quality, 3.0F, 9.0F);
  settings.width = terrain.width_metres();
  settings.height = terrain.height_metres();
  // Coarse grids are drawn with finer quads than their cells, so that the ground is where ground_height says it is.
  settings.finest_side = patch_cells * std::min(terrain.cell_size, coarsest_quad);
  std::array<std::vector<GroundPatch>, 4> by_variant;
  for (const GroundPatch& patch : select_patches(settings, bounds_, eye, frustum)) {
    by_variant[std::size_t(variant(patch, look, eye))].push_back(patch);
  }
  std::vector<GroundPatch> patches;
  for (const auto& list : by_variant) patches.insert(patches.end(), list.begin(), list.end());
  stream(patch_instances_, std::span<const GroundPatch>(patches));

  bind_shared();
  glBindTextureUnit(1, normals_.name());
  glBindTextureUnit(2, ground_.name());
  glBindTextureUnit(4, canopy_.name());
  glBindTextureUnit(5, lines_.name());
  glBindVertexArray(patch_array_.name());
  int draw_calls = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < by_variant.size(); ++i) {
    if (by_variant[i].empty()) continue;
    set_look(programs_[i], look);
    programs_[i].use();
    glDrawElementsInstancedBaseInstance(GL_TRIANGLES, patch_index_count_, GL_UNSIGNED_SHORT, nullptr,
                                        GLsizei(by_variant[i].size()), GLuint(first));
    first += by_variant[i].size();
    ++draw_calls;
  }
  return {draw_calls, patches.size() * std::size_t(patch_index_count_ / 3)};
}

int TerrainRenderer::variant(const GroundPatch& patch, const TerrainLook& look, const glm::dvec3& eye) const {
  const glm::vec2 middle(patch.west + 0.5F * patch.side, patch.south + 0.5F * patch.side);
  const glm::vec2 heights = bounds_.of(patch.west, patch.south, patch.side);
  const glm::vec3 offset = glm::vec3(middle, 0.5F * (heights.x + heights.y)) - glm::vec3(eye);
  const float farthest = glm::length(offset) + glm::length(glm::vec3(patch.side, patch.side, heights.y - heights.x)) * 0.5F;
  const bool canopy = look.canopy_strength > 0 && farthest > look.canopy_from;
  bool water = false;
  if (look.water) {
    const float square = patch_cells * float(snapshot_->terrain().cell_size);
    const int x0 = int(std::floor(patch.west / square + 0.5F));
    const int y0 = int(std::floor(patch.south / square + 0.5F));
    const int count = std::max(1, int(std::lround(patch.side / square)));
    // Beyond the border the ground is mirrored: there every patch counts as wet.
    water = x0 < 0 || y0 < 0 || x0 + count > near_water_.width() || y0 + count > near_water_.height();
    for (int y = y0; y < y0 + count && !water; ++y) {
      for (int x = x0; x < x0 + count && !water; ++x) water = near_water_(x, y) != 0;
    }
  }
  return (water ? 1 : 0) + (canopy ? 2 : 0);
}

void TerrainRenderer::set_look(const ShaderProgram& program, const TerrainLook& look) const {
  program.set("patch_cells", float(patch_cells));
  program.set("canopy_range", glm::vec4(look.canopy_from, look.canopy_whole, look.canopy_strength, 0));
  program.set("show", glm::vec4(look.water ? 1 : 0, look.trails ? 1 : 0, 0, 0));
  program.set("brush", look.brush ? glm::vec4(*look.brush, 1) : glm::vec4(0));
}

}  // namespace biotope
