#pragma once

#include <array>
#include <memory>
#include <tuple>
#include <vector>

#include "core/ecosystem/plant_share_schedule.hpp"
#include "core/movement/movement_cache.hpp"
#include "core/pipeline/cover_totals.hpp"
#include "core/pipeline/environment_stage.hpp"
#include "core/pipeline/ground_stages.hpp"
#include "core/pipeline/memo.hpp"
#include "core/pipeline/solve.hpp"
#include "core/terrain/hydrology_state.hpp"

namespace biotope {

/// Pointers that an operator read; two runs read the same when these are equal.
using InputPointers = std::vector<std::shared_ptr<const void>>;

/// State of the plants' competition: output tiles and what they were computed from.
struct PlantStage {
  /// Version of the environment; what changed since is stale.
  std::uint64_t seen_environment = 0;
  std::vector<double> desired;
  std::array<std::shared_ptr<const PaintLayer>, monthly_resources> paint;
  SoilPaint soil;
  std::vector<std::shared_ptr<const CoverMap>> covers;
  /// Small tiles whose plants have to compete again.
  TileSet stale;
  /// Where the plants have desired shares on a large map: by what they compete, and whether that is older than the environment.
  ShareSchedule schedule;
  bool schedule_stale = false;
};

/// One plant's cover with its own paint over it.
struct PaintedCover {
  std::shared_ptr<const CoverMap> computed;
  std::shared_ptr<const PaintLayer> paint;
  std::shared_ptr<const CoverMap> cover;
};

struct TreeCoverStage {
  std::vector<std::shared_ptr<const CoverMap>> trees;
  std::shared_ptr<const Grid<Cover>> cover;
};

/// Everything a SolveCache keeps, one member an operator.
struct SolveCache::Stages {
  LandStage land;
  /// Mean height of the file's terrain.
  Memo<InputPointers, double> mean_height;
  /// What a person placed for animals: the same pointers while the values are equal. `opened` leaves out what only leads their
  /// ways.
  std::shared_ptr<const Places> places;
  std::shared_ptr<const Places> opened;
  SlopeStage slopes;
  HydrologyState water;
  std::uint64_t water_seen_land = 0;
  EnvironmentStage environment;
  /// The food web, and the species it was built of.
  std::shared_ptr<const FoodWeb> web;
  std::shared_ptr<const std::vector<Species>> web_of;
  /// The food web without desired shares: a change of shares alone must not run what does not read them.
  std::shared_ptr<const FoodWeb> biology;
  PlantStage plants;
  std::vector<PaintedCover> covers;
  CoverTotals cover_totals;
  TreeCoverStage tree_cover;
  using LevelKey = std::tuple<InputPointers, std::vector<double>, std::uint64_t>;
  std::vector<Memo<LevelKey, AnimalLevel>> levels;
  std::vector<Memo<InputPointers, LevelMovement>> movement;
  Memo<InputPointers, ResourceAccessGraph> graph;
  Memo<InputPointers, TrailNetwork> trails;
  Memo<std::tuple<InputPointers, std::uint64_t, std::vector<PlanEdit>>, std::vector<DailyPlan>> plans;
  Memo<InputPointers, std::vector<PlantShortage>> plant_shortages;
  /// What travel and trails found before and may need again.
  MovementCache travelled;
};

/// Brings a plant stage up to date: everything when its species changed, else only the tiles whose environment or paint did, and
/// of those only the ones in `near` unless it is null; the others stay stale. `changes` are those of the environment's maps.
/// Plants with desired shares compete by the schedule of before where `near` is given; the next exact call tells whether it still
/// holds.
[[nodiscard]] Status update_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment,
                                   const ChangeLog& changes, const std::vector<double>& desired, const TileSet* near,
                                   const TaskContext& context);
/// Whether update_plants can answer in parts of the map: the plants and shares are those of before, and cells compete by
/// themselves.
[[nodiscard]] bool can_answer_plants_near(const PlantStage& stage, const FoodWeb& web, const EnvironmentMaps& maps,
                                          const std::vector<double>& desired);

/// Lays a plant's paint over its computed cover, tile by tile where something changed.
void update_painted_cover(PaintedCover& stage, const std::shared_ptr<const CoverMap>& computed,
                          const std::shared_ptr<const PaintLayer>& paint);

/// Sums the covers of all trees, at most full_cover. Keeps the old grid when nothing changed.
void update_tree_cover(TreeCoverStage& stage, std::vector<std::shared_ptr<const CoverMap>> trees, int width, int height);

/// Lays paint on the plants that competed and sums them: what a snapshot tells of plants.
void painted_plants(SolveCache::Stages& stages, MapsSnapshot& maps);

}  // namespace biotope
