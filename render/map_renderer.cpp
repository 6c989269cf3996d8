#include "render/map_renderer.hpp"

#include <algorithm>
#include <cmath>

#include "render/map_colours.hpp"
#include "render/map_lines.hpp"
#include "render/map_textures.hpp"

namespace biotope {
namespace {

constexpr std::size_t shaded_cells_a_draw = std::size_t(3) << 20;

/// A contour interval of 1, 2 or 5 times a power of ten metres, about a quarter of the ground's width of 50 pixels.
float contour_interval(double metres_per_pixel) {
  const double wanted = std::max(metres_per_pixel * 12, 0.5);
  const double decade = std::pow(10, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= wanted) return float(step * decade);
  }
  return float(10 * decade);
}

/// How bands of strength 0 and 1 look.
struct RibbonLook {
  glm::vec2 width_range;  ///< pixels
  glm::vec2 fade;         ///< opacity
  float casing = 0;       ///< extra pixels on each side
  float emphasis = 1;     ///< exponent over strength
  glm::vec4 colour = glm::vec4(0);
};

/// Bands on the graphics card.
struct RibbonBatch {
  Buffer vertices = make_buffer();
  Buffer indices = make_buffer();
  VertexArray array = make_vertex_array();
  GLsizei count = 0;

  RibbonBatch() {
    glVertexArrayVertexBuffer(array.name(), 0, vertices.name(), 0, sizeof(RibbonVertex));
    glVertexArrayElementBuffer(array.name(), indices.name());
    float_attribute(array, 0, 0, 2, offsetof(RibbonVertex, x));
    float_attribute(array, 1, 0, 2, offsetof(RibbonVertex, normal_x));
    float_attribute(array, 2, 0, 1, offsetof(RibbonVertex, side));
    float_attribute(array, 3, 0, 1, offsetof(RibbonVertex, strength));
    float_attribute(array, 4, 0, 1, offsetof(RibbonVertex, metres));
    glEnableVertexArrayAttrib(array.name(), 5);
    glVertexArrayAttribFormat(array.name(), 5, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(RibbonVertex, tone));
    glVertexArrayAttribBinding(array.name(), 5, 0);
  }
  void upload(const RibbonMesh& mesh) {
    stream(vertices, std::span<const RibbonVertex>(mesh.vertices));
    stream(indices, std::span<const std::uint32_t>(mesh.indices));
    count = GLsizei(mesh.indices.size());
  }
  void draw() const {
    if (count == 0) return;
    glBindVertexArray(array.name());
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  }
};

/// Herds' marks, one instance each.
struct MarkerBatch {
  Buffer instances = make_buffer();
  VertexArray array = make_vertex_array();

  MarkerBatch() {
    glVertexArrayVertexBuffer(array.name(), 0, instances.name(), 0, sizeof(HerdMarker));
    glVertexArrayBindingDivisor(array.name(), 0, 1);
    float_attribute(array, 0, 0, 2, offsetof(HerdMarker, x));
    float_attribute(array, 1, 0, 1, offsetof(HerdMarker, heading));
    float_attribute(array, 2, 0, 1, offsetof(HerdMarker, pixels));
    glEnableVertexArrayAttrib(array.name(), 3);
    glVertexArrayAttribFormat(array.name(), 3, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(HerdMarker, tone));
    glVertexArrayAttribBinding(array.name(), 3, 0);
  }
  void draw(std::span<const HerdMarker> markers) const {
    if (markers.empty()) return;
    stream(instances, markers);
    glBindVertexArray(array.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(markers.size()));
  }
};

bool same_overlay(const std::optional<MapOverlay>& a, const std::optional<MapOverlay>& b) {
  if (a.has_value() != b.has_value()) return false;
  if (!a) return true;
  const bool same_clear = a->clear_below == b->clear_below || (std::isnan(a->clear_below) && std::isnan(b->clear_below));
  return a->cells == b->cells && a->low == b->low && a->high == b->high && a->colours == b->colours && a->opacity == b->opacity &&
         same_clear;
}

}  // namespace

bool same_ground(const MapOptions& a, const MapOptions& b) {
  return a.view.centre_x == b.view.centre_x && a.view.centre_y == b.view.centre_y &&
         a.view.pixels_per_cell == b.view.pixels_per_cell && same_overlay(a.overlay, b.overlay) && a.water == b.water &&
         a.contours == b.contours && a.trails == b.trails && a.hatched == b.hatched && a.beyond == b.beyond &&
         a.pixel_scale == b.pixel_scale && a.dark == b.dark && a.line_step == b.line_step;
}

struct MapRenderer::State {
  ShaderProgram relief_program;
  ShaderProgram ground_program;
  ShaderProgram ribbon_program;
  ShaderProgram marker_program;

  std::shared_ptr<const MapsSnapshot> snapshot;
  std::shared_ptr<const Hydrology> hydrology;
  std::shared_ptr<const TrailNetwork> trails;

  VertexArray nothing = make_vertex_array();
  Texture colours;
  ReliefTexture relief;
  Texture water;
  OverlayTexture overlay;
  PaintTexture paint;
  PaintTexture beyond;
  RibbonBatch rivers;
  RibbonBatch trail_lines;
  RibbonBatch tails;
  MarkerBatch markers;

  /// The picture without herds, kept while only they move.
  KeptPicture still;
  MapOptions still_options;
  bool still_valid = false;

  Status load();
  void make_colours();
  void draw_ground(const MapOptions& options, glm::vec2 viewport);
  void set_view(const ShaderProgram& program, const MapOptions& options, glm::vec2 viewport) const;
  void draw_ribbon(const RibbonBatch& batch, const RibbonLook& look) const;
  void draw_trails(const MapOptions& options) const;
  void draw_still(const MapOptions& options, int width, int height);
  void draw_lines(const MapOptions& options, glm::vec2 viewport);
  void draw_herds(const MapOptions& options, glm::vec2 viewport);
};

Status MapRenderer::State::load() {
  struct Wanted {
    ShaderProgram* program;
    const char* vertex;
    const char* fragment;
  };
  for (const Wanted& wanted : {Wanted{&relief_program, "map/fullscreen.vert", "map/relief.frag"},
                               Wanted{&ground_program, "map/fullscreen.vert", "map/map.frag"},
                               Wanted{&ribbon_program, "map/ribbon.vert", "map/ribbon.frag"},
                               Wanted{&marker_program, "map/marker.vert", "map/marker.frag"}}) {
    auto program = load_shader_program(wanted.vertex, wanted.fragment);
    if (!program) return tl::unexpected(program.error());
    *wanted.program = std::move(*program);
  }
  make_colours();
  return {};
}

void MapRenderer::State::make_colours() {
  const std::vector<std::uint8_t> table = colour_table();
  colours = make_texture_2d(GL_RGBA8, colour_table_width, colour_maps, 1, {});
  glTextureSubImage2D(colours.name(), 0, 0, 0, colour_table_width, colour_maps, GL_RGBA, GL_UNSIGNED_BYTE, table.data());
}

void MapRenderer::State::set_view(const ShaderProgram& program, const MapOptions& options, glm::vec2 viewport) const {
  program.set("viewport", viewport);
  program.set("centre", glm::vec2(options.view.centre_x, options.view.centre_y));
  program.set("cells_per_pixel", float(1 / options.view.pixels_per_cell));
}

void MapRenderer::State::draw_ground(const MapOptions& options, glm::vec2 viewport) {
  const Terrain& terrain = *relief.terrain();
  ground_program.use();
  set_view(ground_program, options, viewport);
  ground_program.set("map_size", glm::vec2(terrain.height.width(), terrain.height.height()));
  ground_program.set("background", options.dark ? glm::vec3(0.094F, 0.102F, 0.114F) : glm::vec3(0.80F, 0.81F, 0.81F));
  ground_program.set("brightness", options.dark ? 0.93F : 1.03F);
  ground_program.set("pixel_scale", options.pixel_scale);
  ground_program.set("show_water", int(options.water && water));
  const double metres_per_pixel = terrain.cell_size / options.view.pixels_per_cell;
  ground_program.set("contour_step", options.contours ? contour_interval(metres_per_pixel * options.pixel_scale) : 0.0F);
  const bool show_overlay = options.overlay && overlay.texture();
  ground_program.set("show_overlay", int(show_overlay));
  if (show_overlay) {
    ground_program.set("overlay_range", glm::vec2(options.overlay->low, options.overlay->high));
    ground_program.set("overlay_clear", options.overlay->clear_below);
    ground_program.set("overlay_opacity", options.overlay->opacity);
    ground_program.set("overlay_colours", int(options.overlay->colours));
    ground_program.set("overlay_categorical", int(options.overlay->colours == ColourMap::categorical));
  }
  ground_program.set("line_step", show_overlay ? options.line_step : 0.0F);
  ground_program.set("show_hatch", int(options.hatched && paint.texture()));
  ground_program.set("show_beyond", int(options.beyond && beyond.texture()));
  const std::array<const char*, 7> names{"relief_map",   "height_map", "water_map", "overlay_map",
                                         "colour_table", "hatch_map",  "beyond_map"};
  const std::array<GLuint, 7> textures{relief.relief().name(),   relief.heights().name(), water.name(),
                                       overlay.texture().name(), colours.name(),          paint.texture().name(),
                                       beyond.texture().name()};
  for (std::size_t unit = 0; unit < names.size(); ++unit) {
    ground_program.set(names[unit], int(unit));
    // A unit that nothing is drawn from still needs a texture.
    glBindTextureUnit(GLuint(unit), textures[unit] != 0 ? textures[unit] : colours.name());
  }
  glBindVertexArray(nothing.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void MapRenderer::State::draw_ribbon(const RibbonBatch& batch, const RibbonLook& look) const {
  ribbon_program.set("width_range", look.width_range);
  ribbon_program.set("fade_range", look.fade);
  ribbon_program.set("casing", look.casing);
  ribbon_program.set("emphasis", look.emphasis);
  ribbon_program.set("override_colour", look.colour);
  batch.draw();
}

void MapRenderer::State::draw_trails(const MapOptions& options) const {
  const float scale = options.pixel_scale;
  // Hairlines while the whole landscape is in view (8 m a pixel), cased tracks from close by (0.5 m a pixel).
  const double metres_per_pixel = relief.terrain()->cell_size / options.view.pixels_per_cell * double(scale);
  const float closeness = float(std::clamp(std::log2(8 / metres_per_pixel) / 4, 0.0, 1.0));
  const glm::vec2 width = glm::mix(glm::vec2(0.35F, 2.2F), glm::vec2(1.0F, 4.5F), closeness) * scale;
  const glm::vec2 fade = glm::mix(glm::vec2(0.16F, 0.92F), glm::vec2(0.60F, 1.0F), closeness) * (options.overlay ? 0.8F : 1.0F);
  const float casing = closeness - 0.3F;
  if (casing > 0) {
    draw_ribbon(trail_lines, {width, fade * 0.75F * std::min(casing * 2, 1.0F), (0.5F + 0.7F * casing) * scale, 2.2F,
                              glm::vec4(0.98F, 0.94F, 0.82F, 1)});
  }
  draw_ribbon(trail_lines, {width, fade, 0, 2.2F});
}

void MapRenderer::State::draw_lines(const MapOptions& options, glm::vec2 viewport) {
  const float scale = options.pixel_scale;
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  ribbon_program.use();
  set_view(ribbon_program, options, viewport);
  ribbon_program.set("cell_size", float(relief.terrain()->cell_size));
  if (options.water) {
    const float fade = options.overlay ? 0.85F : 1.0F;
    draw_ribbon(rivers, {glm::vec2(0.8F, 2.4F) * scale, glm::vec2(0.55F, 0.95F) * fade});
  }
  if (options.trails) draw_trails(options);
}

void MapRenderer::State::draw_herds(const MapOptions& options, glm::vec2 viewport) {
  if (!options.herds || !snapshot) return;
  const float scale = options.pixel_scale;
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  ribbon_program.use();
  set_view(ribbon_program, options, viewport);
  ribbon_program.set("cell_size", float(relief.terrain()->cell_size));
  // Marks shrink as the whole landscape comes into view, so that many herds do not hide it: full size at 2 m a pixel.
  const double metres_per_pixel = relief.terrain()->cell_size / options.view.pixels_per_cell * double(scale);
  const float mark = float(std::clamp(std::pow(2 / metres_per_pixel, 0.35), 0.45, 1.4));
  const HerdPicture herds = herds_at(*snapshot, options.hour, options.visible_species, scale * mark, options.view.pixels_per_cell);
  tails.upload(herds.tails);
  draw_ribbon(tails, {glm::vec2(0.3F, 2.2F) * scale * mark, glm::vec2(0.0F, 0.45F), 0.6F * scale, 1,
                      glm::vec4(0.05F, 0.05F, 0.06F, 1)});
  draw_ribbon(tails, {glm::vec2(0.3F, 2.2F) * scale * mark, glm::vec2(0.0F, 0.95F)});
  marker_program.use();
  set_view(marker_program, options, viewport);
  markers.draw(herds.markers);
}

void MapRenderer::State::draw_still(const MapOptions& options, int width, int height) {
  const bool resized = still.resize(width, height);
  if (still_valid && !resized && same_ground(options, still_options)) return;
  still.bind();
  if (options.overlay) overlay.set(options.overlay->cells, options.overlay->colours != ColourMap::categorical);
  if (options.hatched) paint.set(*options.hatched);
  if (options.beyond) beyond.set(*options.beyond);
  const glm::vec2 viewport(width, height);
  glDisable(GL_BLEND);
  draw_ground(options, viewport);
  draw_lines(options, viewport);
  still_options = options;
  still_valid = relief.complete();
}

MapRenderer::MapRenderer() : state_(std::make_unique<State>()) {}
MapRenderer::~MapRenderer() = default;

Result<std::unique_ptr<MapRenderer>> MapRenderer::create() {
  std::unique_ptr<MapRenderer> renderer(new MapRenderer());
  const Status loaded = renderer->state_->load();
  if (!loaded) return tl::unexpected(loaded.error());
  return renderer;
}

void MapRenderer::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot) {
  State& state = *state_;
  if (snapshot == state.snapshot) return;
  state.snapshot = std::move(snapshot);
  if (!state.snapshot) return;
  if (state.snapshot->document.terrain != state.relief.terrain()) {
    state.still_valid = false;
    state.water.reset();
    state.hydrology.reset();
  }
  state.relief.set_terrain(state.snapshot->document.terrain);
  if (state.snapshot->hydrology && state.snapshot->hydrology != state.hydrology) {
    state.still_valid = false;
    state.hydrology = state.snapshot->hydrology;
    state.water = water_texture(*state.hydrology);
    state.rivers.upload(river_ribbons(*state.hydrology, state.hydrology->water.width()));
  }
  if (!state.hydrology) state.rivers.upload({});
  if (state.snapshot->trails != state.trails) {
    state.still_valid = false;
    state.trails = state.snapshot->trails;
    state.trail_lines.upload(state.trails ? trail_ribbons(*state.trails) : RibbonMesh{});
  }
}

void MapRenderer::patch_overlay(const Grid<float>& cells, const Rect& rect) {
  state_->overlay.patch(cells, rect);
  state_->still_valid = false;
}

void MapRenderer::draw(const MapOptions& options, int width, int height) {
  State& state = *state_;
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(state.nothing.name());
  state.relief.shade_some(state.relief_program, shaded_cells_a_draw);
  if (!state.relief.terrain()) {
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer));
    const float tone = options.dark ? 0.1F : 0.8F;
    glClearColor(tone, tone, tone, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  state.draw_still(options, width, height);
  state.still.copy_to(GLuint(framebuffer));
  glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer));
  glViewport(0, 0, width, height);
  state.draw_herds(options, glm::vec2(width, height));
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

bool MapRenderer::complete() const { return state_->relief.complete(); }

}  // namespace biotope
