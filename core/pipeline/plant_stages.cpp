#include <algorithm>

#include "core/base/parallel.hpp"
#include "core/pipeline/solve_stages.hpp"
#include "core/pipeline/tile_operator.hpp"

namespace biotope {

namespace {

/// Competition again in some tiles of maps that are otherwise up to date.
void compete_again(std::vector<CoverMap>& maps, const FoodWeb& web, const PlantEnvironment& environment,
                   const std::vector<std::size_t>& tiles) {
  std::vector<std::vector<std::shared_ptr<CoverMap::Tile>>> made(tiles.size());
  parallel_each(tiles.size(), [&](std::size_t i) {
    std::vector<CoverMap::Tile*> out;
    for (std::size_t plant = 0; plant < maps.size(); ++plant) {
      made[i].push_back(std::make_shared<CoverMap::Tile>());
      made[i].back()->fill(0);
      out.push_back(made[i].back().get());
    }
    compete_in_tile(web, environment, maps.front().tile_rect(tiles[i]), out);
  });
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    for (std::size_t plant = 0; plant < maps.size(); ++plant) replace_tile(maps[plant], tiles[i], made[i][plant]);
  }
}

std::vector<std::size_t> repainted_tiles(const PlantStage& stage, const PlantEnvironment& environment, std::size_t tile_count) {
  std::vector<std::size_t> tiles;
  for (std::size_t r = 0; r < monthly_resources; ++r) {
    merge_tiles(tiles, differing_tiles(stage.paint[r].get(), environment.paint[r].get(), tile_count));
  }
  merge_tiles(tiles, differing_tiles(stage.soil.texture.get(), environment.soil.texture.get(), tile_count));
  merge_tiles(tiles, differing_tiles(stage.soil.geology.get(), environment.soil.geology.get(), tile_count));
  return tiles;
}

Status compute_all_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment,
                          const std::vector<double>& desired, const TaskContext& context) {
  auto covers = desired.empty() ? compete_without_proportions(web, environment, context)
                                : compete_with_proportions(web, environment, desired, context);
  if (!covers) return tl::unexpected<Error>(covers.error());
  if (context.stopped()) return fail(stopped_message);
  stage.covers.clear();
  for (auto& cover : *covers) stage.covers.push_back(std::make_shared<const CoverMap>(std::move(cover)));
  return {};
}

}  // namespace

Status update_plants(PlantStage& stage, const FoodWeb& web, const PlantEnvironment& environment,
                     const std::vector<double>& desired, const TaskContext& context) {
  const bool same_world = !stage.covers.empty() && stage.environment == environment.maps && stage.desired == desired &&
                          stage.covers.size() == web.levels.front().size();
  if (same_world && stage.paint == environment.paint && stage.soil == environment.soil) return {};
  if (!same_world || !desired.empty()) {
    stage.environment = nullptr;
    if (Status done = compute_all_plants(stage, web, environment, desired, context); !done) return done;
  } else {
    const auto tiles = repainted_tiles(stage, environment, stage.covers.front()->tile_count());
    std::vector<CoverMap> maps;
    for (const auto& cover : stage.covers) maps.push_back(*cover);
    compete_again(maps, web, environment, tiles);
    for (std::size_t i = 0; i < maps.size(); ++i) {
      if (differing_tiles(stage.covers[i].get(), &maps[i], maps[i].tile_count()).empty()) continue;
      stage.covers[i] = std::make_shared<const CoverMap>(std::move(maps[i]));
    }
  }
  stage.environment = environment.maps;
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

}  // namespace biotope
