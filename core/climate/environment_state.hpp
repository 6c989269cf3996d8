#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/climate/climate.hpp"
#include "core/climate/environment.hpp"
#include "core/climate/followed_diffusion.hpp"
#include "core/terrain/generations.hpp"
#include "core/terrain/sunlight.hpp"

namespace biotope {

// Maps of the environment that follow their inputs tile by tile. Each is equal to what compute_environment makes of the same
// inputs, to the bit, once nothing is stale any more. They take tiles of any side and tell their own changes in small ones.

/// Monthly illumination. The horizon of a place far from a changed one may change too, so its shadow is told apart as stale
/// tiles, which can be brought up to date later than those near.
class IlluminationState {
 public:
  /// Everything anew. Forgets all when stopped.
  [[nodiscard]] Status restart(const Terrain& terrain, const Derivatives& derivatives, const Climate& climate,
                               const TaskContext& context);
  [[nodiscard]] bool started() const { return bool(layers_.front()); }
  /// The ground changed in some tiles, and its slopes in some.
  void follow(const Terrain& terrain, const TileSet& heights, const TileSet& slopes);
  [[nodiscard]] const TileSet& stale() const { return stale_; }
  /// Brings stale tiles up to date.
  void update(const Derivatives& derivatives, const Climate& climate, const TileSet& tiles);

  [[nodiscard]] MonthlyMap map() const;
  [[nodiscard]] const ChangeLog& changes() const { return changes_; }
  void release_unused();

 private:
  /// Makes the light of a stale tile again in the months in which it may be another; whether it is in any.
  bool remake(const Derivatives& derivatives, const Climate& climate, std::size_t tile,
              const std::array<std::shared_ptr<Grid<float>>, 12>& made) const;

  std::unique_ptr<HorizonField> horizons_;
  std::unique_ptr<Sunlight> sunlight_;
  std::array<GridGenerations<float>, 12> layers_;
  ChangeLog changes_{small_side};
  /// Tiles whose light has to be made again: because of their slopes, or only of horizons.
  TileSet stale_;
  TileSet stale_slopes_;
  MovedHorizons moved_;
};

/// Yearly mean temperature at every height.
class TemperatureState {
 public:
  void restart(const Terrain& terrain, const Climate& climate);
  [[nodiscard]] bool started() const { return bool(layer_); }
  void update(const Terrain& terrain, const Climate& climate, const TileSet& tiles);

  [[nodiscard]] MonthlyMap map(const Climate& climate) const;
  [[nodiscard]] const ChangeLog& changes() const { return changes_; }
  void release_unused() { layer_.release_unused(); }

 private:
  GridGenerations<float> layer_;
  ChangeLog changes_{small_side};
};

/// Where what soil follows from changed.
struct SoilChange {
  const TileSet& heights;
  const TileSet& slopes;
  const TileSet& water;
};

/// Moisture, and what soil follows from it. Water is followed as far as a change spreads.
class SoilState {
 public:
  SoilState();
  /// Everything anew. Forgets all when stopped.
  [[nodiscard]] Status restart(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology,
                               const Climate& climate, const TaskContext& context);
  [[nodiscard]] bool started() const { return bool(moisture_); }
  /// Follows changes in some tiles.
  void update(const Terrain& terrain, const Derivatives& derivatives, const Hydrology& hydrology, const Climate& climate,
              const SoilChange& change);

  /// Gives back what only changes are followed by; the next one is as much work as everything anew.
  void forget_passes();

  [[nodiscard]] MonthlyMap moisture(const Climate& climate) const;
  [[nodiscard]] std::shared_ptr<const Grid<float>> texture() const { return texture_.newest(); }
  [[nodiscard]] std::shared_ptr<const Grid<Geology>> geology() const { return geology_.newest(); }
  [[nodiscard]] const ChangeLog& changes() const { return changes_; }
  void release_unused();

 private:
  /// Water before it spreads, how easily it does, and how it has; and the mean height of each cell's surroundings.
  Grid<float> water_;
  Grid<float> conductance_;
  FollowedDiffusion spread_;
  FollowedDiffusion surroundings_{1};
  GridGenerations<float> moisture_;
  GridGenerations<float> texture_;
  GridGenerations<Geology> geology_;
  ChangeLog changes_{small_side};
};

}  // namespace biotope
