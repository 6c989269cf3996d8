#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/climate/environment_state.hpp"
#include "core/document/document.hpp"
#include "core/pipeline/ground_stages.hpp"
#include "core/terrain/hydrology_state.hpp"

namespace biotope {

/// What the environment follows from, beside the climate.
struct EnvironmentInput {
  const LandStage& land;
  const SlopeStage& slopes;
  const HydrologyState& water;
  const Climate& climate;
  const GivenEnvironment& given;
};

/// The environment maps, brought up to date tile by tile.
struct EnvironmentStage {
  IlluminationState light;
  TemperatureState warmth;
  SoilState soil;
  std::optional<Climate> climate;
  std::uint64_t light_seen_land = 0;
  std::uint64_t light_seen_slopes = 0;
  std::uint64_t warmth_seen_land = 0;
  std::uint64_t soil_seen_land = 0;
  std::uint64_t soil_seen_slopes = 0;
  std::uint64_t soil_seen_water = 0;

  /// What `maps` were put together from.
  std::uint64_t maps_light = 0;
  std::uint64_t maps_warmth = 0;
  std::uint64_t maps_soil = 0;
  std::optional<Climate> maps_climate;
  GivenEnvironment given;
  std::shared_ptr<const EnvironmentMaps> maps;
  ChangeLog changes{small_side};
};

/// Whether a small change of the ground can be answered near it before the water is known again: the maps are those of the ground
/// before, and everything else is the same.
[[nodiscard]] bool can_answer_nearby(const EnvironmentStage& stage, const EnvironmentInput& input);

/// Light of the tiles whose slopes changed and the temperature, with water and soil as they were and shadows farther away to
/// come. Returns the tiles.
TileSet update_environment_nearby(EnvironmentStage& stage, const EnvironmentInput& input);

/// Whether shade that a changed ground throws far away may stay that of the ground before, if there is much of it.
enum class FarShade : std::uint8_t { exact, may_wait };

/// Everything; exactly, unless light is still stale then because its shade waits. Stopped, it keeps what was finished.
[[nodiscard]] Status update_environment(EnvironmentStage& stage, const EnvironmentInput& input, FarShade far_shade,
                                        const TaskContext& context);

}  // namespace biotope
