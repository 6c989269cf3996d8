#include "core/ecosystem/plant_competition.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "core/base/parallel.hpp"
#include "core/ecosystem/plant_competition_kernel.hpp"

namespace biotope {

namespace {

constexpr std::string_view stage = "plant competition";

/// Tiles between two looks at the stop token: enough to keep every core busy, few enough to stop at once.
constexpr std::size_t tiles_at_once = 64;

void compete_in_tile(const CompetitionPlan& plan, const PlantEnvironment& environment, const Rect& tile_rect,
                     std::span<CoverMap::Tile* const> out) {
  CompetitionBatch batch(plan);
  for (int y = tile_rect.y0; y < tile_rect.y1; ++y) {
    for (int x = tile_rect.x0; x < tile_rect.x1; x += batch_cells) {
      const int count = std::min(batch_cells, tile_rect.x1 - x);
      compete_batch(plan, environment, x, y, count, batch);
      const std::size_t first = CoverMap::offset(x, y);
      for (std::size_t plant = 0; plant < out.size(); ++plant) {
        for (int lane = 0; lane < count; ++lane) {
          (*out[plant])[first + std::size_t(lane)] = Cover(batch.cover[plant].v[lane]);
        }
      }
    }
  }
}

bool is_bare(const CoverMap::Tile& tile) {
  return std::all_of(tile.begin(), tile.end(), [](Cover cover) { return cover == 0; });
}

/// Competes in one tile and keeps the plants that grow there; the others' tiles stay null.
void fill_tile(const CompetitionPlan& plan, const PlantEnvironment& environment, std::size_t index,
               std::vector<CoverMap>& covers) {
  std::vector<CoverMap::Tile> tiles(covers.size());
  std::vector<CoverMap::Tile*> out;
  out.reserve(tiles.size());
  for (CoverMap::Tile& tile : tiles) out.push_back(&tile);
  compete_in_tile(plan, environment, covers.front().tile_rect(index), out);
  for (std::size_t plant = 0; plant < covers.size(); ++plant) {
    if (is_bare(tiles[plant])) continue;
    covers[plant].set_tile(index, std::make_shared<const CoverMap::Tile>(tiles[plant]));
  }
}

}  // namespace

void compete_in_tile(const FoodWeb& web, const PlantEnvironment& environment, const Rect& tile_rect,
                     std::span<CoverMap::Tile* const> out) {
  assert(out.size() == web.levels[0].size());
  assert(tile_rect.empty() || tile_rect.x0 / tile_side == (tile_rect.x1 - 1) / tile_side);
  assert(tile_rect.empty() || tile_rect.y0 / tile_side == (tile_rect.y1 - 1) / tile_side);
  compete_in_tile(competition_plan(web), environment, tile_rect, out);
}

Result<std::vector<CoverMap>> compete_without_proportions(const FoodWeb& web, const PlantEnvironment& environment,
                                                          const TaskContext& context) {
  const CompetitionPlan plan = competition_plan(web);
  const Rect area = environment.maps->geology->rect();
  std::vector<CoverMap> covers(std::size_t(plan.plants), CoverMap(area.width(), area.height()));
  if (covers.empty()) return covers;
  const std::size_t tiles = covers.front().tile_count();
  for (std::size_t first = 0; first < tiles; first += tiles_at_once) {
    if (context.stopped()) return fail("Plant competition was stopped.");
    context.report(stage, double(first) / double(tiles));
    parallel_each(std::min(tiles_at_once, tiles - first),
                  [&](std::size_t i) { fill_tile(plan, environment, first + i, covers); });
  }
  context.report(stage, 1);
  return covers;
}

std::vector<double> achieved_shares(std::span<const CoverMap> covers) {
  std::vector<double> sums;
  double total = 0;
  for (const CoverMap& cover : covers) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < cover.tile_count(); ++i) {
      const CoverMap::TilePointer& tile = cover.tile(i);
      if (!tile) continue;
      const Rect rect = cover.tile_rect(i);
      for (int y = rect.y0; y < rect.y1; ++y) {
        for (int x = rect.x0; x < rect.x1; ++x) sum += (*tile)[CoverMap::offset(x, y)];
      }
    }
    sums.push_back(double(sum));
    total += double(sum);
  }
  if (total > 0) {
    for (double& sum : sums) sum /= total;
  }
  return sums;
}

}  // namespace biotope
