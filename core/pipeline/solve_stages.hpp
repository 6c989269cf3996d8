#pragma once

#include <array>
#include <memory>
#include <tuple>
#include <vector>

#include "core/movement/movement_cache.hpp"
#include "core/pipeline/cover_totals.hpp"
#include "core/pipeline/memo.hpp"
#include "core/pipeline/solve.hpp"

namespace biotope {

/// Pointers that an operator read; two runs read the same when these are equal.
using InputPointers = std::vector<std::shared_ptr<const void>>;

/// State of the plants' competition: output tiles and the paint they were computed under.
struct PlantStage {
  std::shared_ptr<const EnvironmentMaps> environment;
  std::shared_ptr<const FoodWeb> biology;
  std::vector<double> desired;
  std::array<std::shared_ptr<const PaintLayer>, monthly_resources> paint;
  SoilPaint soil;
  std::vector<std::shared_ptr<const CoverMap>> covers;
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
  /// Ground with paint and drawn water, and its mean height.
  Memo<std::tuple<InputPointers, DrawnWater>, Terrain> land;
  Memo<InputPointers, double> mean_height;
  /// What a person placed for animals: the same pointers while the values are equal. `opened` leaves out what only leads their
  /// ways.
  std::shared_ptr<const Places> places;
  std::shared_ptr<const Places> opened;
  Memo<InputPointers, Derivatives> derivatives;
  Memo<std::tuple<InputPointers, std::vector<std::array<double, 3>>, double>, Hydrology> hydrology;
  Memo<std::tuple<InputPointers, Climate>, EnvironmentMaps> environment;
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

/// Brings a plant stage up to date: everything when its environment or species changed, else only the tiles whose paint did.
[[nodiscard]] Status update_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment,
                                   const std::vector<double>& desired, const TaskContext& context);

/// Lays a plant's paint over its computed cover, tile by tile where something changed.
void update_painted_cover(PaintedCover& stage, const std::shared_ptr<const CoverMap>& computed,
                          const std::shared_ptr<const PaintLayer>& paint);

/// Sums the covers of all trees, at most full_cover. Keeps the old grid when nothing changed.
void update_tree_cover(TreeCoverStage& stage, std::vector<std::shared_ptr<const CoverMap>> trees, int width, int height);

}  // namespace biotope
