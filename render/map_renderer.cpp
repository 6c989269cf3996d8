#include "render/map_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/map_batches.hpp"
#include "render/map_colours.hpp"
#include "render/map_textures.hpp"
#include "render/shader_program.hpp"

namespace biotope {
namespace {

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

/// The pixels (counted from below) in which a change of the cells of `rect` may show: the shader looks a few cells and pixels
/// around.
Rect pixels_of(const Rect& rect, const MapView& view, int width, int height) {
  if (rect.empty()) return {};
  const double margin = 3 + 4 / view.pixels_per_cell;
  const auto across = [&](double cell) { return (cell - view.centre_x) * view.pixels_per_cell + 0.5 * width; };
  const auto down = [&](double cell) { return (cell - view.centre_y) * view.pixels_per_cell + 0.5 * height; };
  const auto pixel = [](double at, int most) { return int(std::clamp(std::floor(at), 0.0, double(most))); };
  return {pixel(across(rect.x0 - margin), width), height - pixel(down(rect.y1 + margin) + 1, height),
          pixel(across(rect.x1 + margin) + 1, width), height - pixel(down(rect.y0 - margin), height)};
}

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
  ShaderProgram ground_program;
  ShaderProgram ribbon_program;
  ShaderProgram marker_program;

  std::shared_ptr<const MapsSnapshot> snapshot;

  VertexArray nothing = make_vertex_array();
  Texture colours;
  MapGround ground;
  OverlayTexture overlay;
  PaintTexture paint;
  PaintTexture beyond;
  std::shared_ptr<const MapWater> rivers_of;
  std::shared_ptr<const RibbonMesh> trails_of;
  RibbonBatch rivers;
  RibbonBatch trail_lines;
  RibbonBatch tails;
  MarkerBatch markers;

  /// The picture without herds, kept while only they move.
  KeptPicture still;
  MapOptions still_options;
  bool still_valid = false;
  /// Cells in which it is out of date.
  Rect patched;

  Status load();
  void make_colours();
  void bring_in(const MapOptions& options, UploadBudget budget);
  [[nodiscard]] const Terrain& terrain() const { return *ground.shown()->of.terrain; }
  void draw_ground(const MapOptions& options, glm::vec2 viewport);
  void set_view(const ShaderProgram& program, const MapOptions& options, glm::vec2 viewport) const;
  void set_overlay(const MapOptions& options) const;
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
  for (const Wanted& wanted : {Wanted{&ground_program, "map/fullscreen.vert", "map/map.frag"},
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

void MapRenderer::State::set_overlay(const MapOptions& options) const {
  const std::optional<MapOverlay>& shown = overlay.shown();
  const bool show = options.overlay && shown;
  ground_program.set("show_overlay", int(show));
  ground_program.set("line_step", show ? options.line_step : 0.0F);
  if (!show) return;
  ground_program.set("overlay_range", glm::vec2(shown->low, shown->high));
  ground_program.set("overlay_clear", shown->clear_below);
  ground_program.set("overlay_opacity", shown->opacity);
  ground_program.set("overlay_colours", int(shown->colours));
  ground_program.set("overlay_categorical", int(shown->colours == ColourMap::categorical));
}

void MapRenderer::State::draw_ground(const MapOptions& options, glm::vec2 viewport) {
  ground_program.use();
  set_view(ground_program, options, viewport);
  ground_program.set("map_size", glm::vec2(terrain().height.width(), terrain().height.height()));
  ground_program.set("cells_per_texel", float(ground.shown()->relief->stride));
  ground_program.set("background", options.dark ? glm::vec3(0.094F, 0.102F, 0.114F) : glm::vec3(0.80F, 0.81F, 0.81F));
  ground_program.set("brightness", options.dark ? 0.93F : 1.03F);
  ground_program.set("pixel_scale", options.pixel_scale);
  ground_program.set("show_water", int(options.water && ground.water() != 0));
  const double metres_per_pixel = terrain().cell_size / options.view.pixels_per_cell;
  ground_program.set("contour_step", options.contours ? contour_interval(metres_per_pixel * options.pixel_scale) : 0.0F);
  set_overlay(options);
  ground_program.set("show_hatch", int(options.hatched && paint.texture()));
  ground_program.set("show_beyond", int(options.beyond && beyond.texture()));
  const std::array<const char*, 7> names{"relief_map",   "height_map", "water_map", "overlay_map",
                                         "colour_table", "hatch_map",  "beyond_map"};
  const std::array<GLuint, 7> textures{ground.relief(), ground.heights(),       ground.water(),         overlay.texture().name(),
                                       colours.name(),  paint.texture().name(), beyond.texture().name()};
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
  const double metres_per_pixel = terrain().cell_size / options.view.pixels_per_cell * double(scale);
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
  ribbon_program.set("cell_size", float(terrain().cell_size));
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
  ribbon_program.set("cell_size", float(terrain().cell_size));
  // Marks shrink as the whole landscape comes into view, so that many herds do not hide it: full size at 2 m a pixel.
  const double metres_per_pixel = terrain().cell_size / options.view.pixels_per_cell * double(scale);
  const float mark = float(std::clamp(std::pow(2 / metres_per_pixel, 0.35), 0.45, 1.4));
  const HerdPicture herds =
      herds_at(*snapshot, options.hour, options.visible_species, scale * mark, options.view.pixels_per_cell);
  tails.upload(herds.tails);
  draw_ribbon(tails,
              {glm::vec2(0.3F, 2.2F) * scale * mark, glm::vec2(0.0F, 0.45F), 0.6F * scale, 1, glm::vec4(0.05F, 0.05F, 0.06F, 1)});
  draw_ribbon(tails, {glm::vec2(0.3F, 2.2F) * scale * mark, glm::vec2(0.0F, 0.95F)});
  marker_program.use();
  set_view(marker_program, options, viewport);
  markers.draw(herds.markers);
}

void MapRenderer::State::bring_in(const MapOptions& options, UploadBudget budget) {
  if (ground.bring_in(budget)) {
    still_valid = false;
    const MapPicture& shown = *ground.shown();
    if (shown.water != rivers_of) {
      rivers_of = shown.water;
      rivers.upload(rivers_of ? rivers_of->rivers : RibbonMesh{});
    }
    if (shown.trails != trails_of) {
      trails_of = shown.trails;
      trail_lines.upload(trails_of ? *trails_of : RibbonMesh{});
    }
  }
  if (options.overlay && overlay.bring_in(*options.overlay, budget)) still_valid = false;
}

void MapRenderer::State::draw_still(const MapOptions& options, int width, int height) {
  const bool resized = still.resize(width, height);
  MapOptions other_paint = options;
  other_paint.hatched = still_options.hatched;
  const bool both_hatched = bool(options.hatched) == bool(still_options.hatched);
  const bool whole = !still_valid || resized || !both_hatched || !same_ground(other_paint, still_options);
  if (!whole && patched.empty() && options.hatched == still_options.hatched) return;
  if (options.hatched) patched = bounding(patched, paint.set(*options.hatched));
  if (options.beyond) (void)beyond.set(*options.beyond);
  still_options = options;
  still_valid = true;
  const Rect dirty = std::exchange(patched, Rect{});
  const Rect part = whole ? Rect{0, 0, width, height} : pixels_of(dirty, options.view, width, height);
  if (part.empty()) return;
  still.bind();
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.x0, part.y0, part.width(), part.height());
  const glm::vec2 viewport(width, height);
  glDisable(GL_BLEND);
  draw_ground(options, viewport);
  draw_lines(options, viewport);
  glDisable(GL_SCISSOR_TEST);
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
  if (snapshot == state_->snapshot) return;
  state_->snapshot = std::move(snapshot);
  if (state_->snapshot && state_->snapshot->surface() && !state_->snapshot->terrain().height.empty()) {
    state_->ground.ask({state_->snapshot->surface(), state_->snapshot->hydrology, state_->snapshot->trails});
  }
}

void MapRenderer::patch_overlay(const Grid<float>& cells, const Rect& rect) {
  state_->overlay.patch(cells, rect);
  state_->patched = bounding(state_->patched, rect);
}

void MapRenderer::finish_loading(const MapOptions& options) {
  state_->ground.wait();
  state_->bring_in(options, UploadBudget::unlimited());
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
  state.bring_in(options, {});
  if (!state.ground.shown()) {
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

bool MapRenderer::complete() const { return state_->ground.complete() && !state_->overlay.coming(); }

}  // namespace biotope
