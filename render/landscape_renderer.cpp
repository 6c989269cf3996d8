#include "render/landscape_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/climate/snow_cover.hpp"
#include "render/animal_renderer.hpp"
#include "render/fall_renderer.hpp"
#include "render/frame.hpp"
#include "render/landscape_shadows.hpp"
#include "render/plant_renderer.hpp"
#include "render/screen_effects.hpp"
#include "render/sky_renderer.hpp"
#include "render/terrain_renderer.hpp"
#include "render/whole_mirror.hpp"

namespace biotope {

namespace {

/// Quality from which on single trees and animals throw shadows.
constexpr float shadow_quality = 2;
/// Qualities from which on edges are smoothed (and water mirrors) and corners shaded.
constexpr float smooth_quality = 2;
constexpr float occlusion_quality = 4;

/// What is done to a picture.
struct Effects {
  bool smooth = false;
  bool occlusion = false;
  bool reflections = false;
  [[nodiscard]] bool any() const { return smooth || occlusion || reflections; }
};
Effects effects_of(const LandscapeOptions& options) {
  return {options.smooth_edges && options.quality >= smooth_quality, options.occlusion && options.quality >= occlusion_quality,
          options.reflections && options.water && options.shadows && options.quality >= smooth_quality};
}

PlantLook plant_look(const LandscapeOptions& options) { return {options.month, options.visible_species, options.quality}; }

TerrainLook terrain_look(const LandscapeOptions& options, const Terrain& ground) {
  TerrainLook look;
  look.month = options.month;
  look.visible = options.visible_species;
  look.water = options.water;
  look.trails = options.trails;
  look.quality = options.quality;
  look.canopy_strength = options.plants ? 1.0F : 0.0F;
  if (options.brush) {
    const float cell = float(ground.cell_size);
    look.brush = glm::vec3((options.brush->x + 0.5F) * cell, (float(ground.height.height()) - 0.5F - options.brush->y) * cell,
                           options.brush->z * cell);
  }
  return look;
}

}  // namespace

struct LandscapeRenderer::State {
  std::shared_ptr<const MapsSnapshot> snapshot;
  std::unique_ptr<TerrainRenderer> terrain;
  std::unique_ptr<AnimalRenderer> animals;
  std::unique_ptr<PlantRenderer> plants;
  /// The ground the plants stand on, and the maps they were last placed by.
  std::shared_ptr<const GroundPicture> planted;
  std::shared_ptr<const MapsSnapshot> planted_maps;
  LandscapeShadows shadows;
  ScreenEffects effects;
  WholeMirror whole_mirror;
  /// Of the picture that is being drawn, and whether that is a part of one.
  Effects shown_effects;
  bool in_parts = false;
  SkyRenderer sky;
  FallRenderer fall;
  Buffer frame_buffer = make_buffer();
  LandscapeStatistics statistics;
  /// Snow lines of a climate.
  std::array<SnowLine, months> snow;
  std::optional<Climate> snow_climate;
  bool ground_complete = false;
  bool plants_complete = true;
  bool shadows_complete = true;
  /// Whether there are all plants that the last picture asked for.
  bool plants_made = true;
  /// bring_in() was called since the last draw.
  bool brought_in = false;
  /// Whether the picture is one of a window that must keep its pace.
  bool in_window = false;
  /// The ground that was drawn last.
  std::shared_ptr<const GroundPicture> drawn_ground;
  glm::vec2 drawn_planes{1, 1000};

  FrameUniforms frame(const Camera& camera, const LandscapeOptions& options, const Daylight& light, int width, int height);
  void follow_ground(bool at_once);
  void follow_animals(bool at_once);
  /// Prepares the animals, and draws what the light sees where shadows are shown. True where they are.
  bool draw_shadows(const Camera& camera, const LandscapeOptions& options, const Daylight& light, const FrameUniforms& frame,
                    bool with_plants);
  void draw_world(const Camera& camera, const LandscapeOptions& options, const Daylight& light, FrameUniforms& frame,
                  glm::ivec2 size);
  /// Draws what water mirrors in all parts of a picture, where that is not there yet.
  void mirror_whole(const Camera& camera, const LandscapeOptions& options, const FrameUniforms& frame, glm::ivec2 size,
                    bool with_plants, bool with_shadows);
  void set_frame(const FrameUniforms& frame) const;
  void draw_picture(const Camera& camera, const LandscapeOptions& options, int width, int height);
  void count(const DrawCount& drawn);
};

LandscapeRenderer::LandscapeRenderer() : state_(std::make_unique<State>()) {}
LandscapeRenderer::~LandscapeRenderer() = default;

Result<std::unique_ptr<LandscapeRenderer>> LandscapeRenderer::create() {
  std::unique_ptr<LandscapeRenderer> renderer(new LandscapeRenderer);
  State& state = *renderer->state_;
  auto terrain = TerrainRenderer::create();
  if (!terrain) return tl::unexpected(terrain.error());
  state.terrain = std::move(*terrain);
  auto animals = AnimalRenderer::create();
  if (!animals) return tl::unexpected(animals.error());
  state.animals = std::move(*animals);
  auto plants = PlantRenderer::create();
  if (!plants) return tl::unexpected(plants.error());
  state.plants = std::move(*plants);
  auto shadows = LandscapeShadows::create();
  if (!shadows) return tl::unexpected(shadows.error());
  state.shadows = std::move(*shadows);
  auto effects = ScreenEffects::create();
  if (!effects) return tl::unexpected(effects.error());
  state.effects = std::move(*effects);
  auto sky = SkyRenderer::create();
  if (!sky) return tl::unexpected(sky.error());
  state.sky = std::move(*sky);
  auto fall = FallRenderer::create();
  if (!fall) return tl::unexpected(fall.error());
  state.fall = std::move(*fall);
  return renderer;
}

void LandscapeRenderer::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot) {
  if (!snapshot || !snapshot->surface() || snapshot->terrain().height.empty()) return;
  state_->snapshot = snapshot;
  if (!state_->snow_climate || *state_->snow_climate != snapshot->document.climate) {
    state_->snow_climate = snapshot->document.climate;
    state_->snow = snow_lines(snapshot->document.climate);
  }
  state_->terrain->set_snapshot(std::move(snapshot));
}

/// Plants stand on the ground that is in sight: they follow a change of it when its picture is whole.
void LandscapeRenderer::State::follow_ground(bool at_once) {
  const std::shared_ptr<const GroundPicture>& ground = terrain->shown();
  if (!terrain->ready() || ground->coarse) return;
  // On a ground of the same form they need not wait for its picture.
  const MapsSnapshot& of = *ground->of.snapshot;
  const bool same_form =
      of.surface() == snapshot->surface() && of.hydrology == snapshot->hydrology && of.trails == snapshot->trails;
  const bool same_lines = planted && planted->lines == ground->lines;
  // Nor do they go back to older ones while the picture of a newer form is being made.
  const bool newer = same_lines && planted->shape == ground->shape && planted_maps->revision > of.revision;
  const std::shared_ptr<const MapsSnapshot> maps = same_form ? snapshot : newer ? planted_maps : ground->of.snapshot;
  if (planted_maps != maps || !same_lines) {
    plants->set_snapshot(maps, std::shared_ptr<const GroundLines>(ground, ground->lines.get()), at_once);
  }
  planted = ground;
  planted_maps = maps;
}

/// Animals drink where water is drawn, and walk around the trunks that are drawn.
void LandscapeRenderer::State::follow_animals(bool at_once) {
  const bool drawn = planted && planted->lines && planted->of.snapshot->hydrology == snapshot->hydrology &&
                     same_extent(planted->terrain(), snapshot->terrain());
  const bool grown = planted && same_extent(planted->terrain(), snapshot->terrain());
  animals->set_world(*snapshot, drawn ? planted->lines->shore : nullptr, grown ? plants->placement() : PlantPlacement(), at_once);
}

FrameUniforms LandscapeRenderer::State::frame(const Camera& camera, const LandscapeOptions& options, const Daylight& light,
                                              int width, int height) {
  const Terrain& ground = snapshot->terrain();
  const glm::vec2 heights = terrain->ready() ? terrain->height_range() : glm::vec2(0, 1);
  const double above = height_above_surface(*snapshot, camera.position);
  const float near_plane = std::clamp(float(above) * 0.2F, 0.3F, 25.0F);
  const AirLayer air{heights.x, heights.y, float(std::max(ground.width_metres(), ground.height_metres())), float(above)};
  const float far_plane = 4.5F * air.extent + float(std::abs(above)) + (heights.y - heights.x);
  FrameUniforms out;
  drawn_planes = {near_plane, far_plane};
  set_view(out, camera, width, height, near_plane, far_plane);
  set_light(out, light, ground.latitude, options.month);
  set_weather(out, options.weather, options.seconds);
  set_air(out, options.weather, air);
  const Climate& climate = snapshot->document.climate;
  set_snow(out, snow[std::size_t(options.month)], snowfall_height(climate, options.month), ground.latitude, options.weather);
  out.fog.w = options.quality;
  out.horizon.w = float(options.corner.x);
  out.zenith.w = float(options.corner.y);
  out.terrain = {float(ground.width_metres()), float(ground.height_metres()), float(ground.cell_size), heights.x};
  return out;
}

void LandscapeRenderer::State::count(const DrawCount& drawn) {
  statistics.draw_calls += drawn.draw_calls;
  statistics.triangles += drawn.triangles;
}

bool LandscapeRenderer::State::draw_shadows(const Camera& camera, const LandscapeOptions& options, const Daylight& light,
                                            const FrameUniforms& frame, bool with_plants) {
  const bool drawn = options.shadows && options.quality >= shadow_quality;
  const double above = std::max(0.5, height_above_surface(*snapshot, camera.position));
  const PlantRenderer* casting = with_plants ? plants.get() : nullptr;
  ShadowView view;
  if (drawn) {
    const PlantShadowLook look{snapshot->web, options.visible_species, options.month, camera.position,
                               glm::dvec3(frame.wind.x, frame.wind.y, options.seconds)};
    view = shadows.choose(shadow_view(camera, above, light.light_direction, light.shadows), casting, look,
                          in_window ? LandscapeShadows::most_in_window : LandscapeShadows::all);
  }
  shadows_complete = !drawn || !shadows.pending();
  follow_animals(!in_window);
  animals->prepare(*snapshot, options, camera.position, Frustum(frame.view_projection), terrain->surface(),
                   drawn ? &view : nullptr);
  if (drawn) count(shadows.draw(casting, *animals));
  return drawn;
}

void LandscapeRenderer::State::set_frame(const FrameUniforms& frame) const {
  stream(frame_buffer, std::span<const FrameUniforms>(&frame, 1));
  glBindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_buffer.name());
}

void LandscapeRenderer::State::mirror_whole(const Camera& camera, const LandscapeOptions& options, const FrameUniforms& frame,
                                            glm::ivec2 size, bool with_plants, bool with_shadows) {
  WholeMirror::Of of{camera, options, size, planted_maps, planted};
  of.options.corner = glm::ivec2(0);
  if (!whole_mirror.holds(of)) {
    const DrawnElsewhere elsewhere(size.x, size.y);
    FrameUniforms whole = frame;
    whole.horizon.w = whole.zenith.w = 0;
    set_frame(whole);
    whole_mirror.begin(std::move(of));
    if (with_plants) count(plants->draw(with_shadows));
    // What is not all there is not kept.
    if (!plants_complete) whole_mirror.forget();
    set_frame(frame);
  }
  whole_mirror.bind();
}

void LandscapeRenderer::State::draw_world(const Camera& camera, const LandscapeOptions& options, const Daylight& light,
                                          FrameUniforms& frame, glm::ivec2 size) {
  const Terrain& ground = snapshot->terrain();
  const Frustum frustum(frame.view_projection);
  TerrainLook look = terrain_look(options, ground);
  const bool with_plants = options.plants && planted && same_extent(planted->terrain(), ground);
  if (with_plants) {
    plants_complete = plants->prepare(plant_look(options), camera.position, frame, frustum, 1000 * options.patience);
    frame.shade_area = PlantRenderer::shade_area(camera.position, height_above_surface(*snapshot, camera.position));
    // Under clouds light comes from all sides.
    frame.shade_area.w = glm::mix(0.55F, 1.0F, light.shadows);
    look.canopy_from = plants->canopy_range().x;
    look.canopy_whole = plants->canopy_range().y;
  }
  set_frame(frame);
  terrain->bind_shared();
  if (with_plants) count(plants->draw_shade(frame.shade_area, light.light_direction));
  look.shadows = draw_shadows(camera, options, light, frame, with_plants);
  // Plants before the ground: what they hide need not be shaded.
  if (with_plants) {
    count(plants->draw(look.shadows));
    statistics.plants = plants->plants_drawn();
    statistics.instance_bytes = plants->bytes();
    statistics.most_instance_bytes = plants->most_bytes();
  }
  if (shown_effects.reflections) {
    if (in_parts) {
      mirror_whole(camera, options, frame, size, with_plants, look.shadows);
    } else {
      effects.keep_for_water();
    }
    look.mirrored = drawn_planes;
  }
  count(terrain->draw(look, camera.position, frustum));
  count(animals->draw(options, look.shadows));
  statistics.animals = animals->drawn().size();
  statistics.instance_bytes += animals->bytes();
  statistics.most_instance_bytes += AnimalRenderer::most_bytes();
}

bool LandscapeRenderer::bring_in(const LandscapeOptions& options) {
  State& state = *state_;
  if (!state.snapshot) return false;
  const Terrain& ground = state.snapshot->terrain();
  state.ground_complete = state.terrain->prepare(terrain_look(options, ground),
                                                 daylight(ground.latitude, options.month, options.hour).light_direction);
  state.follow_ground(!state.in_window);
  state.plants_made = !options.plants || state.plants->advance();
  state.brought_in = true;
  return state.drawn_ground != state.terrain->shown() || !state.plants_complete || !state.shadows_complete ||
         !state.animals->settled();
}

void LandscapeRenderer::draw(const Camera& camera, const LandscapeOptions& options, int width, int height) {
  State& state = *state_;
  state.statistics = {};
  const Effects effects = state.shown_effects = state.snapshot && width > 0 && height > 0 ? effects_of(options) : Effects{};
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  state.in_parts = options.corner != glm::ivec2(0) || viewport[2] != width || viewport[3] != height;
  if (effects.any()) state.effects.begin({options.corner, {width, height}});
  glViewport(-options.corner.x, -options.corner.y, width, height);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glClearColor(0.45F, 0.5F, 0.55F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (!state.snapshot || width <= 0 || height <= 0) return;
  state.in_window = state.brought_in;
  if (!state.brought_in) bring_in(options);
  state.brought_in = false;
  state.draw_picture(camera, options, width, height);
  if (effects.any()) state.effects.end(state.drawn_planes, effects.smooth, effects.occlusion);
  glBindVertexArray(0);
}

void LandscapeRenderer::State::draw_picture(const Camera& camera, const LandscapeOptions& options, int width, int height) {
  const Terrain& ground = snapshot->terrain();
  const Daylight light = under(daylight(ground.latitude, options.month, options.hour), options.weather);
  drawn_ground = terrain->shown();
  plants_complete = true;
  shadows_complete = true;
  FrameUniforms uniforms = frame(camera, options, light, width, height);
  if (terrain->ready()) {
    draw_world(camera, options, light, uniforms, {width, height});
  } else {
    set_frame(uniforms);
  }
  sky.draw(light.night, options.quality);
  count({1, 1});
  if (const int quads = fall.draw(options.weather, options.quality); quads > 0) count({2, std::size_t(2 * quads)});
}

int tile_margin(const LandscapeOptions& options, int whole_height) {
  const Effects effects = effects_of(options);
  return effect_margin(effects.smooth, effects.occlusion, whole_height);
}

void LandscapeRenderer::finish_loading(const Camera& camera, const LandscapeOptions& options) {
  if (!state_->snapshot) return;
  const Terrain& ground = state_->snapshot->terrain();
  state_->terrain->finish(terrain_look(options, ground), daylight(ground.latitude, options.month, options.hour).light_direction);
  state_->follow_ground(true);
  if (options.plants) state_->plants->finish_loading(plant_look(options), camera.position);
  // Who waits for all of it wants no picture that keeps a window's pace.
  state_->brought_in = false;
}

bool LandscapeRenderer::all_made() const { return state_->ground_complete && state_->plants_made; }

bool LandscapeRenderer::complete() const {
  return state_->ground_complete && state_->plants_complete && state_->shadows_complete && state_->animals->settled();
}

const LandscapeStatistics& LandscapeRenderer::statistics() const { return state_->statistics; }

glm::vec2 LandscapeRenderer::depth_planes() const { return state_->drawn_planes; }

std::span<const AnimalAt> LandscapeRenderer::animals() const { return state_->animals->drawn(); }

const PlantPlacement& LandscapeRenderer::plants() const { return state_->plants->placement(); }

std::optional<AnimalAt> LandscapeRenderer::animal(int plan, int member, double hour) {
  if (!state_->snapshot || !state_->terrain->ready()) return std::nullopt;
  state_->follow_animals(!state_->in_window);
  return state_->animals->animal(plan, member, hour, state_->terrain->surface());
}

}  // namespace biotope
