#pragma once

#include <vector>

#include "core/terrain/drawn_water.hpp"
#include "core/terrain/terrain.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// Drawn lakes and rivers in ground that changes. Of each it is known which tiles it has to do with (see TouchedTiles), so that
/// after a change only those are dug and carved again that lie there, and those that these meet. The others are as they would
/// come out again: nothing that they read has changed.
class WaterShaping {
 public:
  /// Lays all water into ground without any.
  void lay(const DrawnWater& water, Terrain& land);

  /// Brings `land`, which holds what was laid last, up to date with `ground`, the same without drawn water: that differs in the
  /// tiles `changed` (of tile_side), and the water may be other water. Returns the small tiles in which `land` was written.
  TileSet follow(const Terrain& ground, const TileSet& changed, const DrawnWater& water, Terrain& land);

  /// How many lakes and rivers were laid by the last call.
  [[nodiscard]] std::size_t laid() const { return laid_; }

 private:
  /// Which lakes or rivers to lay.
  struct Choice {
    std::vector<char> lakes;
    std::vector<char> rivers;
  };
  Choice exchange(const DrawnWater& water, TileSet& changed);
  void lay_chosen(const Choice& choice, Terrain& land);
  bool choose_met(Choice& choice, const TileSet& tiles) const;
  [[nodiscard]] TileSet touched_by(const Choice& choice) const;

  DrawnWater water_;
  std::vector<TileSet> touched_by_lake_;
  std::vector<TileSet> touched_by_river_;
  std::size_t laid_ = 0;
};

}  // namespace biotope
