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

/// Tiles in which two grounds of one file differ.
TileSet reshaped(const LandStage& stage, const Terrain& land, const PaintLayer* paint, const DrawnWater& water) {
  const Grid<float>& before = stage.land->height;
  const bool paint_alone = stage.water == DrawnWater{} && water == DrawnWater{};
  const TileSet tiles = paint_alone ? repainted(stage.paint.get(), paint, before.width(), before.height())
                                    : TileSet::all(before.width(), before.height());
  return changed_tiles(tiles, [&](const Rect& rect) { return !same_cells(land.height, before, rect); });
}

}  // namespace

void update_land(LandStage& stage, const std::shared_ptr<const Terrain>& file, const std::shared_ptr<const PaintLayer>& paint,
                 const DrawnWater& water) {
  if (stage.land && stage.file == file && stage.paint == paint && stage.water == water) return;
  std::shared_ptr<const Terrain> land = file;
  if (water != DrawnWater{}) {
    land = std::make_shared<const Terrain>(shaped_terrain(*file, paint.get(), water));
  } else if (paint) {
    land = painted_land(stage, file, paint);
  }
  if (!stage.land || stage.file != file) {
    stage.changes.note_all(file->height.width(), file->height.height());
    stage.land = land;
  } else if (TileSet changed = reshaped(stage, *land, paint.get(), water); changed.any()) {
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
