#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/pipeline/solve_stages.hpp"
#include "core/pipeline/tile_operator.hpp"

namespace biotope {

namespace {

/// A tile of the maps and the parts of it in which plants compete again.
struct TileParts {
  std::size_t tile = 0;
  std::vector<Rect> parts;
};

/// Small tiles by the tile of the maps they are in; whole where they are most of it, side by side ones as one.
std::vector<TileParts> parts_of(const CoverMap& map, const TileSet& small) {
  std::vector<TileParts> all;
  std::vector<std::size_t> place(map.tile_count(), map.tile_count());
  for (const std::size_t i : small.list()) {
    const Rect cells = small.rect(i);
    const std::size_t tile = map.tile_index(cells.x0, cells.y0);
    if (place[tile] == map.tile_count()) {
      place[tile] = all.size();
      all.push_back({tile, {}});
    }
    auto& parts = all[place[tile]].parts;
    if (!parts.empty() && parts.back().y0 == cells.y0 && parts.back().x1 == cells.x0) {
      parts.back().x1 = cells.x1;
    } else {
      parts.push_back(cells);
    }
  }
  for (TileParts& one : all) {
    const Rect whole = map.tile_rect(one.tile);
    int cells = 0;
    for (const Rect& part : one.parts) cells += part.width() * part.height();
    if (4 * cells > 3 * whole.width() * whole.height()) one.parts = {whole};
  }
  return all;
}

/// Competition again in some small tiles of maps that are otherwise up to date; by a schedule where there is one.
void compete_again(std::vector<CoverMap>& maps, const FoodWeb& web, const PlantEnvironment& environment,
                   const ShareSchedule* schedule, const TileSet& small) {
  const std::vector<TileParts> tiles = parts_of(maps.front(), small);
  std::vector<std::vector<std::shared_ptr<CoverMap::Tile>>> made(tiles.size());
  parallel_each(tiles.size(), [&](std::size_t i) {
    std::vector<CoverMap::Tile*> out;
    for (const CoverMap& map : maps) {
      const auto& before = map.tile(tiles[i].tile);
      made[i].push_back(before ? std::make_shared<CoverMap::Tile>(*before) : std::make_shared<CoverMap::Tile>());
      if (!before) made[i].back()->fill(0);
      out.push_back(made[i].back().get());
    }
    for (const Rect& part : tiles[i].parts) {
      schedule ? compete_in_tile(web, environment, *schedule, part, out) : compete_in_tile(web, environment, part, out);
    }
  });
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    for (std::size_t plant = 0; plant < maps.size(); ++plant) replace_tile(maps[plant], tiles[i].tile, made[i][plant]);
  }
}

TileSet repainted_tiles(const PlantStage& stage, const PlantEnvironment& environment) {
  TileSet tiles(stage.stale.width(), stage.stale.height());
  const auto add = [&](const auto& before, const auto& after) {
    for (const std::size_t tile : differing_tiles(before.get(), after.get(), tiles.tile_count())) tiles.insert(tile);
  };
  for (std::size_t r = 0; r < monthly_resources; ++r) add(stage.paint[r], environment.paint[r]);
  add(stage.soil.texture, environment.soil.texture);
  add(stage.soil.geology, environment.soil.geology);
  return tiles.in_tiles_of(small_side);
}

Status keep_covers(PlantStage& stage, Result<std::vector<CoverMap>> covers, const TaskContext& context) {
  if (!covers) return tl::unexpected<Error>(covers.error());
  if (context.stopped()) return fail(stopped_message);
  stage.covers.clear();
  for (auto& cover : *covers) stage.covers.push_back(std::make_shared<const CoverMap>(std::move(cover)));
  return {};
}

bool by_schedule(const EnvironmentMaps& maps, const std::vector<double>& desired) {
  return !desired.empty() && competes_by_schedule(maps.geology->width(), maps.geology->height());
}

/// All cells by a schedule found anew. Until both are there the stage keeps the old ones, so that a run that is stopped leaves
/// the next one little to do.
Status compute_by_new_schedule(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment, ShareSchedule schedule,
                               const TaskContext& context) {
  if (Status done = keep_covers(stage, compete_by_schedule(web, environment, schedule, context), context); !done) return done;
  stage.schedule = std::move(schedule);
  return {};
}

Status compute_all_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment,
                          const std::vector<double>& desired, const TaskContext& context) {
  if (desired.empty()) return keep_covers(stage, compete_without_proportions(web, environment, context), context);
  if (!by_schedule(*environment.maps, desired)) {
    return keep_covers(stage, compete_with_proportions(web, environment, desired, context), context);
  }
  auto schedule = share_schedule(web, environment, desired, context);
  if (!schedule) return tl::unexpected<Error>(schedule.error());
  return compute_by_new_schedule(stage, web, environment, std::move(*schedule), context);
}

/// Competition again in the tiles `asked`, without shares or by the schedule that the stage has.
void compute_in_tiles(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment, const TileSet& asked) {
  const ShareSchedule* const schedule = by_schedule(*environment.maps, stage.desired) ? &stage.schedule : nullptr;
  std::vector<CoverMap> maps;
  for (const auto& cover : stage.covers) maps.push_back(*cover);
  compete_again(maps, web, environment, schedule, asked);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (differing_tiles(stage.covers[i].get(), &maps[i], maps[i].tile_count()).empty()) continue;
    stage.covers[i] = std::make_shared<const CoverMap>(std::move(maps[i]));
  }
}

/// Brings all stale tiles up to date, and every tile where the schedule of shares comes out as another one.
Status compute_stale_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment,
                            const TaskContext& context) {
  if (stage.schedule_stale) {
    auto schedule = share_schedule(web, environment, stage.desired, context);
    if (!schedule) return tl::unexpected<Error>(schedule.error());
    if (*schedule != stage.schedule) return compute_by_new_schedule(stage, web, environment, std::move(*schedule), context);
  }
  compute_in_tiles(stage, web, environment, stage.stale);
  return {};
}

}  // namespace

bool can_answer_plants_near(const PlantStage& stage, const FoodWeb& web, const EnvironmentMaps& maps,
                            const std::vector<double>& desired) {
  const bool has_plants = !stage.covers.empty() && stage.covers.size() == web.levels.front().size() && stage.desired == desired;
  return has_plants && (desired.empty() || by_schedule(maps, desired));
}

Status update_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment, const ChangeLog& changes,
                     const std::vector<double>& desired, const TileSet* near, const TaskContext& context) {
  const TileSet moved = changes.since(stage.seen_environment);
  const bool same_world = !stage.covers.empty() && stage.desired == desired && stage.covers.size() == web.levels.front().size() &&
                          stage.stale.fits(moved.width(), moved.height());
  const bool untouched = same_world && !moved.any() && stage.paint == environment.paint && stage.soil == environment.soil;
  if (untouched && !stage.stale.any() && !stage.schedule_stale) return {};
  const bool scheduled = by_schedule(*environment.maps, desired);
  const bool whole = !same_world || (!desired.empty() && !scheduled) || moved.every();
  if (whole) {
    stage.seen_environment = 0;
    stage.stale = TileSet(moved.width(), moved.height(), small_side);
    if (Status done = compute_all_plants(stage, web, environment, desired, context); !done) return done;
    stage.schedule_stale = false;
    stage.stale = TileSet(moved.width(), moved.height(), small_side);
  } else {
    stage.stale |= moved | repainted_tiles(stage, environment);
    stage.schedule_stale |= scheduled && !untouched;
    if (near != nullptr) {
      const TileSet asked = stage.stale & near->in_tiles_of(small_side);
      compute_in_tiles(stage, web, environment, asked);
      stage.stale -= asked;
    } else {
      if (Status done = compute_stale_plants(stage, web, environment, context); !done) return done;
      stage.schedule_stale = false;
      stage.stale = TileSet(moved.width(), moved.height(), small_side);
    }
  }
  stage.seen_environment = changes.version();
  stage.desired = desired;
  stage.paint = environment.paint;
  stage.soil = environment.soil;
  return {};
}

namespace {

std::shared_ptr<const CoverMap::Tile> painted_tile(const CoverMap& computed, const PaintLayer& paint, std::size_t index) {
  auto tile = std::make_shared<CoverMap::Tile>();
  const auto& below = computed.tile(index);
  const auto& over = paint.tile(index);
  for (std::size_t i = 0; i < tile->size(); ++i) {
    const Cover cover = below ? (*below)[i] : Cover(0);
    (*tile)[i] = (*over)[i].coverage > 0 ? to_cover(painted(cover_fraction(cover), (*over)[i])) : cover;
  }
  return tile;
}

}  // namespace

void update_painted_cover(PaintedCover& stage, const std::shared_ptr<const CoverMap>& computed,
                          const std::shared_ptr<const PaintLayer>& paint) {
  if (stage.cover && stage.computed == computed && stage.paint == paint) return;
  if (!paint) {
    stage = {computed, paint, computed};
    return;
  }
  const bool fresh = !stage.cover || stage.cover->tile_count() != computed->tile_count();
  CoverMap cover = fresh ? *computed : *stage.cover;
  std::vector<std::size_t> tiles =
      differing_tiles(fresh ? nullptr : stage.computed.get(), computed.get(), computed->tile_count());
  merge_tiles(tiles, differing_tiles(fresh ? nullptr : stage.paint.get(), paint.get(), computed->tile_count()));
  bool changed = fresh;
  for (const std::size_t i : tiles) {
    if (paint->tile(i)) {
      changed |= replace_tile(cover, i, painted_tile(*computed, *paint, i));
    } else if (cover.tile(i) != computed->tile(i)) {
      cover.set_tile(i, computed->tile(i));
      changed = true;
    }
  }
  stage = {computed, paint, changed ? std::make_shared<const CoverMap>(std::move(cover)) : stage.cover};
}

namespace {

/// Sums the trees of a tile into `out`, row by row of the tile.
void sum_tile(const std::vector<std::shared_ptr<const CoverMap>>& trees, const Rect& rect, std::size_t index,
              CoverMap::Tile& out) {
  out.fill(0);
  for (const auto& tree : trees) {
    const auto& tile = tree->tile(index);
    if (!tile) continue;
    for (int y = rect.y0; y < rect.y1; ++y) {
      const std::size_t first = CoverMap::offset(rect.x0, y);
      for (std::size_t i = first; i < first + std::size_t(rect.width()); ++i) {
        out[i] = Cover(std::min(full_cover, int(out[i]) + int((*tile)[i])));
      }
    }
  }
}

/// Whether a tile holds other values than the grid below it.
bool differs(const CoverMap::Tile& tile, const Rect& rect, const Grid<Cover>& grid) {
  for (int y = rect.y0; y < rect.y1; ++y) {
    const Cover* row = tile.data() + CoverMap::offset(rect.x0, y);
    if (!std::equal(row, row + rect.width(), grid.row(y).begin() + rect.x0)) return true;
  }
  return false;
}

}  // namespace

void update_tree_cover(TreeCoverStage& stage, std::vector<std::shared_ptr<const CoverMap>> trees, int width, int height) {
  const bool fits =
      stage.cover && stage.cover->width() == width && stage.cover->height() == height && stage.trees.size() == trees.size();
  if (fits && stage.trees == trees) return;
  const TiledMap<Cover> layout(width, height);
  std::vector<std::size_t> tiles;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    merge_tiles(tiles, differing_tiles(fits ? stage.trees[i].get() : nullptr, trees[i].get(), layout.tile_count()));
  }
  const Grid<Cover> blank = fits ? Grid<Cover>() : Grid<Cover>(width, height);
  const Grid<Cover>& before = fits ? *stage.cover : blank;
  std::vector<CoverMap::Tile> sums(tiles.size());
  std::vector<char> changed(tiles.size());
  parallel_each(tiles.size(), [&](std::size_t i) {
    const Rect rect = layout.tile_rect(tiles[i]);
    sum_tile(trees, rect, tiles[i], sums[i]);
    changed[i] = differs(sums[i], rect, before);
  });
  stage.trees = std::move(trees);
  if (fits && std::find(changed.begin(), changed.end(), 1) == changed.end()) return;
  auto cover = std::make_shared<Grid<Cover>>(before);
  parallel_each(tiles.size(), [&](std::size_t i) {
    if (!changed[i]) return;
    const Rect rect = layout.tile_rect(tiles[i]);
    for (int y = rect.y0; y < rect.y1; ++y) {
      std::copy_n(sums[i].data() + CoverMap::offset(rect.x0, y), rect.width(), cover->row(y).begin() + rect.x0);
    }
  });
  stage.cover = std::move(cover);
}

void painted_plants(SolveCache::Stages& stages, MapsSnapshot& maps) {
  const FoodWeb& web = *maps.web;
  const auto& level = web.levels.front();
  stages.covers.resize(level.size());
  std::vector<std::shared_ptr<const CoverMap>> trees;
  for (std::size_t i = 0; i < level.size(); ++i) {
    const Species& plant = web.species[std::size_t(level[i])];
    update_painted_cover(stages.covers[i], stages.plants.covers[i], maps.paint({LayerKind::plant_density, plant.name}));
    maps.computed_cover.push_back(stages.plants.covers[i]);
    maps.cover.push_back(stages.covers[i].cover);
    if (plant.plant().stratum == Stratum::tree) trees.push_back(stages.covers[i].cover);
  }
  const auto& height = maps.document.terrain->height;
  update_tree_cover(stages.tree_cover, std::move(trees), height.width(), height.height());
  maps.tree_cover = stages.tree_cover.cover;
  update_cover_totals(stages.cover_totals, maps.cover);
  maps.plant_achieved = shares_of(stages.cover_totals);
}

}  // namespace biotope
