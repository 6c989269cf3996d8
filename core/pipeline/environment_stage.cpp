#include "core/pipeline/environment_stage.hpp"

#include <algorithm>

namespace biotope {
namespace {

bool same_given(const GivenEnvironment& a, const GivenEnvironment& b) { return a.monthly == b.monthly && a.geology == b.geology; }

/// Puts the maps a person gave in the place of computed ones.
void lay_given(const GivenEnvironment& given, EnvironmentMaps& maps) {
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    if (given.monthly[r].empty()) continue;
    maps.monthly[r].layers = given.monthly[r];
    maps.monthly[r].offset = {};
  }
  if (given.geology) maps.geology = given.geology;
}

/// Puts the maps together, and notes where they changed.
void assemble(EnvironmentStage& stage, const EnvironmentInput& input) {
  const bool same_setting = stage.maps && stage.maps_climate == input.climate && same_given(stage.given, input.given);
  const bool same_maps = stage.maps_light == stage.light.changes().version() &&
                         stage.maps_warmth == stage.warmth.changes().version() &&
                         stage.maps_soil == stage.soil.changes().version();
  if (same_setting && same_maps) return;
  EnvironmentMaps maps;
  maps.monthly[std::size_t(Resource::illumination)] = stage.light.map();
  maps.monthly[std::size_t(Resource::temperature)] = stage.warmth.map(input.climate);
  maps.monthly[std::size_t(Resource::moisture)] = stage.soil.moisture(input.climate);
  maps.texture = stage.soil.texture();
  maps.geology = stage.soil.geology();
  lay_given(input.given, maps);
  if (same_setting) {
    stage.changes.note(stage.light.changes().since(stage.maps_light) | stage.warmth.changes().since(stage.maps_warmth) |
                       stage.soil.changes().since(stage.maps_soil));
  } else {
    stage.changes.note_all(maps.geology->width(), maps.geology->height());
  }
  stage.maps = std::make_shared<const EnvironmentMaps>(std::move(maps));
  stage.maps_light = stage.light.changes().version();
  stage.maps_warmth = stage.warmth.changes().version();
  stage.maps_soil = stage.soil.changes().version();
  stage.maps_climate = input.climate;
  stage.given = input.given;
}

/// Forgets what another climate made.
void follow_climate(EnvironmentStage& stage, const Climate& climate) {
  if (stage.climate == climate) return;
  stage.light_seen_land = 0;
  stage.light_seen_slopes = 0;
  stage.warmth_seen_land = 0;
  stage.soil_seen_land = 0;
  stage.climate = climate;
}

/// Shade may wait in more small tiles than these, a twentieth of a second's work, or in more than one in so many. Our choice.
constexpr std::size_t much_shade = 512;
constexpr std::size_t much_of_tiles = 8;

Status update_light(EnvironmentStage& stage, const EnvironmentInput& input, FarShade far_shade, const TaskContext& context) {
  const TileSet heights = input.land.changes.since(stage.light_seen_land);
  const TileSet slopes = input.slopes.changes.since(stage.light_seen_slopes);
  const Derivatives& derivatives = *input.slopes.derivatives.newest();
  if (!stage.light.started() || heights.every()) {
    stage.light_seen_land = 0;
    if (Status made = stage.light.restart(*input.land.land, derivatives, input.climate, context); !made) return made;
  } else {
    stage.light.follow(*input.land.land, heights, slopes);
    stage.light.update(derivatives, input.climate, slopes | heights);
    const TileSet far = stage.light.stale();
    const std::size_t little = std::min(much_shade, far.tile_count() / much_of_tiles);
    if (far_shade == FarShade::exact || far.count() <= little) stage.light.update(derivatives, input.climate, far);
  }
  stage.light_seen_land = input.land.changes.version();
  stage.light_seen_slopes = input.slopes.changes.version();
  return {};
}

void update_warmth(EnvironmentStage& stage, const EnvironmentInput& input) {
  const TileSet heights = input.land.changes.since(stage.warmth_seen_land);
  if (!stage.warmth.started() || heights.every()) {
    stage.warmth.restart(*input.land.land, input.climate);
  } else {
    stage.warmth.update(*input.land.land, input.climate, heights);
  }
  stage.warmth_seen_land = input.land.changes.version();
}

Status update_soil(EnvironmentStage& stage, const EnvironmentInput& input, const TaskContext& context) {
  const TileSet heights = input.land.changes.since(stage.soil_seen_land);
  const TileSet slopes = input.slopes.changes.since(stage.soil_seen_slopes);
  const TileSet water = input.water.changes().since(stage.soil_seen_water);
  const Terrain& terrain = *input.land.land;
  const Derivatives& derivatives = *input.slopes.derivatives.newest();
  const Hydrology& hydrology = *input.water.newest();
  if (!stage.soil.started() || heights.every()) {
    stage.soil_seen_land = 0;
    if (Status made = stage.soil.restart(terrain, derivatives, hydrology, input.climate, context); !made) return made;
  } else {
    stage.soil.update(terrain, derivatives, hydrology, input.climate, {heights, slopes, water});
  }
  stage.soil_seen_land = input.land.changes.version();
  stage.soil_seen_slopes = input.slopes.changes.version();
  stage.soil_seen_water = input.water.changes().version();
  return {};
}

}  // namespace

bool can_answer_nearby(const EnvironmentStage& stage, const EnvironmentInput& input) {
  if (!stage.maps || !stage.light.started() || !stage.soil.started()) return false;
  if (stage.climate != input.climate || stage.maps_climate != input.climate || !same_given(stage.given, input.given))
    return false;
  if (stage.light_seen_land == 0 || stage.warmth_seen_land == 0) return false;
  const TileSet changed = input.land.changes.since(stage.light_seen_land);
  // Where most of the map changed the exact answer is as near.
  return changed.any() && 2 * changed.count() < changed.tile_count();
}

TileSet update_environment_nearby(EnvironmentStage& stage, const EnvironmentInput& input) {
  const TileSet heights = input.land.changes.since(stage.light_seen_land);
  const TileSet near = input.slopes.changes.since(stage.light_seen_slopes) | heights;
  stage.light.follow(*input.land.land, heights, near);
  stage.light_seen_land = input.land.changes.version();
  stage.light_seen_slopes = input.slopes.changes.version();
  stage.light.update(*input.slopes.derivatives.newest(), input.climate, near);
  update_warmth(stage, input);
  assemble(stage, input);
  return near;
}

Status update_environment(EnvironmentStage& stage, const EnvironmentInput& input, FarShade far_shade,
                          const TaskContext& context) {
  follow_climate(stage, input.climate);
  if (Status done = update_light(stage, input, far_shade, context); !done) return done;
  if (context.stopped()) return fail("stopped");
  update_warmth(stage, input);
  if (Status done = update_soil(stage, input, context); !done) return done;
  assemble(stage, input);
  return {};
}

}  // namespace biotope
