#include "core/pipeline/ground_stages.hpp"

#include "core/terrain/ground_tiles.hpp"
#include "core/terrain/shaping.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {

namespace {

/// Everything but the heights.
void copy_setting(const Terrain& from, Terrain& to) {
  to.voids = from.voids;
  to.cell_size = from.cell_size;
  to.latitude = from.latitude;
  to.georeference = from.georeference;
  to.name = from.name;
}

}  // namespace

bool TerrainCopy::fork(const Terrain& from, Terrain& to) {
  copy_setting(from, to);
  return fork_of(from.height, to.height);
}

Terrain TerrainCopy::value(const Terrain& from) {
  Terrain copy;
  copy.height = copy_of(from.height);
  copy_setting(from, copy);
  return copy;
}

bool DerivativesCopy::fork(const Derivatives& from, Derivatives& to) {
  return fork_of(from.east, to.east) && fork_of(from.north, to.north) && fork_of(from.slope, to.slope) &&
         fork_of(from.curvature, to.curvature);
}

Derivatives DerivativesCopy::value(const Derivatives& from) {
  return {copy_of(from.east), copy_of(from.north), copy_of(from.slope), copy_of(from.curvature)};
}

void DerivativesCopy::tiles(const Derivatives& from, Derivatives& to, const TileSet& tiles) {
  copy_tiles(from.east, to.east, tiles);
  copy_tiles(from.north, to.north, tiles);
  copy_tiles(from.slope, to.slope, tiles);
  copy_tiles(from.curvature, to.curvature, tiles);
}

namespace {

/// Tiles in which two layers of paint (null: none) on a raster of this size are not the same object.
TileSet repainted(const PaintLayer* a, const PaintLayer* b, int width, int height) {
  const auto covers = [](const PaintLayer* paint) { return paint != nullptr && paint->background().coverage > 0; };
  if (covers(a) || covers(b)) return TileSet::all(width, height);
  TileSet tiles(width, height);
  for (std::size_t i = 0; i < tiles.tile_count(); ++i) {
    const auto* before = a != nullptr ? a->tile(i).get() : nullptr;
    const auto* after = b != nullptr ? b->tile(i).get() : nullptr;
    if (before != after) tiles.insert(i);
  }
  return tiles;
}

/// The file's terrain with paint on it.
std::shared_ptr<const Terrain> painted_land(LandStage& stage, const std::shared_ptr<const Terrain>& file,
                                            const std::shared_ptr<const PaintLayer>& paint) {
  if (!stage.painted || stage.painted_file != file) {
    auto painted = std::make_shared<Terrain>(TerrainCopy::value(*file));
    const TileSet tiles = repainted(nullptr, paint.get(), file->height.width(), file->height.height());
    parallel_each(tiles.list().size(), [&, list = tiles.list()](std::size_t i) {
      paint_heights(file->height, paint.get(), tiles.rect(list[i]), painted->height);
    });
    stage.painted.restart(std::move(painted));
  } else {
    const int width = file->height.width();
    const TileSet tiles = repainted(stage.painted_with.get(), paint.get(), width, file->height.height());
    const auto before = stage.painted.newest();
    auto next = stage.painted.copy();
    const TileSet changed = changed_tiles(tiles, [&](const Rect& rect) {
      paint_heights(file->height, paint.get(), rect, next->height);
      return !same_cells(next->height, before->height, rect);
    });
    stage.painted.put(std::move(next), changed);
  }
  stage.painted_file = file;
  stage.painted_with = paint;
  return stage.painted.newest();
}

/// The ground with drawn water, and tiles in which it may be another than before.
std::shared_ptr<const Terrain> shaped_land(LandStage& stage, const std::shared_ptr<const Terrain>& file,
                                           const std::shared_ptr<const PaintLayer>& paint, const DrawnWater& water,
                                           TileSet& written) {
  const std::shared_ptr<const Terrain> ground = paint ? painted_land(stage, file, paint) : file;
  const int width = file->height.width();
  const int height = file->height.height();
  if (!stage.shaped || stage.file != file) {
    auto shaped = std::make_shared<Terrain>(TerrainCopy::value(*ground));
    stage.shaping.lay(water, *shaped);
    stage.shaped.restart(std::move(shaped));
    written = TileSet::all(width, height);
  } else {
    const TileSet changed = repainted(stage.shaped_paint.get(), paint.get(), width, height);
    const auto before = stage.shaped.newest();
    auto next = stage.shaped.copy();
    written = TileSet(width, height);
    const TileSet small = stage.shaping.follow(*ground, changed, water, *next);
    for (const std::size_t tile : small.list()) written.insert(small.rect(tile));
    const auto differs = [&](const Rect& rect) { return !same_cells(next->height, before->height, rect); };
    const TileSet others = changed_tiles(written, differs);
    stage.shaped.put(std::move(next), others);
  }
  stage.shaped_paint = paint;
  return stage.shaped.newest();
}

/// The ground, and tiles in which it may be another than that of before, if that was of the same file.
std::shared_ptr<const Terrain> land_of(LandStage& stage, const std::shared_ptr<const Terrain>& file,
                                       const std::shared_ptr<const PaintLayer>& paint, const DrawnWater& water,
                                       TileSet& written) {
  const bool water_before = stage.water != DrawnWater{};
  if (water != DrawnWater{}) return shaped_land(stage, file, paint, water, written);
  stage.shaped = {};
  stage.shaping = {};
  written = water_before ? TileSet::all(file->height.width(), file->height.height())
                         : repainted(stage.paint.get(), paint.get(), file->height.width(), file->height.height());
  return paint ? painted_land(stage, file, paint) : file;
}

}  // namespace

void update_land(LandStage& stage, const std::shared_ptr<const Terrain>& file, const std::shared_ptr<const PaintLayer>& paint,
                 const DrawnWater& water) {
  if (stage.land && stage.file == file && stage.paint == paint && stage.water == water) return;
  TileSet written;
  const std::shared_ptr<const Terrain> land = land_of(stage, file, paint, water, written);
  const auto differs = [&](const Rect& rect) { return !same_cells(land->height, stage.land->height, rect); };
  if (!stage.land || stage.file != file) {
    stage.changes.note_all(file->height.width(), file->height.height());
    stage.land = land;
  } else if (TileSet changed = changed_tiles(written, differs); changed.any()) {
    stage.changes.note(std::move(changed));
    stage.land = land;
  } else if (land == file) {
    stage.land = land;
  }
  if (stage.file != file || stage.water != water) stage.lake_cells = cells_of_lakes(water.lakes, file->height.rect());
  stage.file = file;
  stage.paint = paint;
  stage.water = water;
}

void update_slopes(SlopeStage& stage, const LandStage& land) {
  if (stage.derivatives && stage.seen_land == land.changes.version()) return;
  const Terrain& terrain = *land.land;
  const TileSet heights = stage.derivatives ? land.changes.since(stage.seen_land) : TileSet{};
  if (!stage.derivatives || heights.every()) {
    stage.derivatives.restart(std::make_shared<Derivatives>(compute_derivatives(terrain)));
    stage.changes.note_all(terrain.height.width(), terrain.height.height());
  } else {
    const auto before = stage.derivatives.newest();
    auto next = stage.derivatives.copy();
    TileSet changed = changed_tiles(heights.grown(1), [&](const Rect& rect) {
      differentiate(terrain, rect, *next);
      return !same_cells(next->east, before->east, rect) || !same_cells(next->north, before->north, rect) ||
             !same_cells(next->curvature, before->curvature, rect);
    });
    stage.derivatives.put(std::move(next), changed);
    if (changed.any()) stage.changes.note(std::move(changed));
  }
  stage.seen_land = land.changes.version();
}

}  // namespace biotope
