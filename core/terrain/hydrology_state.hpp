#pragma once

#include <memory>
#include <optional>

#include "core/terrain/depressions.hpp"
#include "core/terrain/flow_updates.hpp"
#include "core/terrain/generations.hpp"
#include "core/terrain/hydrology.hpp"

namespace biotope {

struct HydrologyCopy {
  static bool fork(const Hydrology& from, Hydrology& to);
  static Hydrology value(const Hydrology& from);
  static void tiles(const Hydrology& from, Hydrology& to, const TileSet& tiles);
};

/// The water of a ground that changes here and there: equal to compute_hydrology of the ground of now, to the bit. A change
/// floods its own tiles again, and is carried downstream to where it no longer counts.
class HydrologyState {
 public:
  /// Brings the water up to date with a ground that changed in some tiles since the last time (all: anew). Stopped, it begins
  /// anew the next time.
  [[nodiscard]] Status update(const std::shared_ptr<const Terrain>& land, const TileSet& changed, const HydrologyOptions& options,
                              const TaskContext& context);
  [[nodiscard]] std::shared_ptr<const Hydrology> newest() const { return hydrology_.newest(); }
  [[nodiscard]] const ChangeLog& changes() const { return changes_; }
  void release_unused() { hydrology_.release_unused(); }

  /// Everything anew; what is left in the state serves the next change.
  [[nodiscard]] Result<Hydrology> compute(const Terrain& terrain, const HydrologyOptions& options, const TaskContext& context);

 private:
  [[nodiscard]] bool can_follow(const Terrain& terrain, const TileSet& changed, const HydrologyOptions& options) const;
  void follow(const Terrain& terrain, const TileSet& heights, const HydrologyOptions& options);
  /// Brings the sea up to date; returns the tiles in which it is another.
  [[nodiscard]] TileSet update_sea(const Terrain& terrain, const TileSet& heights, float sea_level);

  DepressionField depressions_;
  CatchmentField catchments_;
  Grid<std::uint32_t> upstream_;
  Grid<std::uint8_t> inlets_;
  /// As find_sea makes it.
  Grid<std::uint8_t> sea_;
  /// What the newest was computed for; null while it is not to be followed.
  std::shared_ptr<const Terrain> land_;
  HydrologyOptions options_;
  Generations<Hydrology, HydrologyCopy> hydrology_;
  ChangeLog changes_;
};

}  // namespace biotope
