#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/paint.hpp"
#include "core/terrain/derivatives.hpp"
#include "core/terrain/drawn_water.hpp"
#include "core/terrain/generations.hpp"
#include "core/terrain/terrain.hpp"
#include "core/terrain/water_shaping.hpp"

namespace biotope {

struct TerrainCopy {
  static bool fork(const Terrain& from, Terrain& to);
  static Terrain value(const Terrain& from);
  static void tiles(const Terrain& from, Terrain& to, const TileSet& tiles) { copy_tiles(from.height, to.height, tiles); }
};
struct DerivativesCopy {
  static bool fork(const Derivatives& from, Derivatives& to);
  static Derivatives value(const Derivatives& from);
  static void tiles(const Derivatives& from, Derivatives& to, const TileSet& tiles);
};

/// The ground everything is computed on: the file's terrain with paint and drawn water.
struct LandStage {
  std::shared_ptr<const Terrain> file;
  std::shared_ptr<const PaintLayer> paint;
  DrawnWater water;
  /// Cells of the drawn lakes.
  std::vector<std::uint32_t> lake_cells;
  std::shared_ptr<const Terrain> land;
  ChangeLog changes;
  /// The file's terrain with nothing but paint, and the paint that its newest version has.
  Generations<Terrain, TerrainCopy> painted;
  std::shared_ptr<const Terrain> painted_file;
  std::shared_ptr<const PaintLayer> painted_with;
  /// The same with drawn water laid into it; empty where none is drawn. `shaped_paint` is what its newest version lies on.
  Generations<Terrain, TerrainCopy> shaped;
  std::shared_ptr<const PaintLayer> shaped_paint;
  WaterShaping shaping;
};

/// Brings the ground up to date: where paint changed, and around drawn rivers and lakes that have to do with that. The same
/// pointer while no height changes; the file's terrain itself where nothing is painted or drawn.
void update_land(LandStage& stage, const std::shared_ptr<const Terrain>& file, const std::shared_ptr<const PaintLayer>& paint,
                 const DrawnWater& water);

struct SlopeStage {
  Generations<Derivatives, DerivativesCopy> derivatives;
  ChangeLog changes;
  std::uint64_t seen_land = 0;
};

/// Differentiates the ground where it changed.
void update_slopes(SlopeStage& stage, const LandStage& land);

}  // namespace biotope
