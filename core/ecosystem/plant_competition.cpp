#include "core/ecosystem/plant_competition.hpp"

#include <cassert>
#include <cstdint>

#include "core/ecosystem/plant_competition_kernel.hpp"
#include "core/ecosystem/plant_tiles.hpp"

namespace biotope {

namespace {

void compete_in_tile(const CompetitionPlan& plan, const PlantEnvironment& environment, const Rect& tile_rect,
                     std::span<CoverMap::Tile* const> out) {
  CompetitionBatch batch(plan);
  compete_in_batches(tile_rect, batch, out,
                     [&](int x, int y, int count) { compete_batch(plan, environment, x, y, count, batch); });
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
  return compete_everywhere(
      environment.maps->geology->rect(), plan.plants, context,
      [&](const Rect& rect, std::span<CoverMap::Tile* const> out) { compete_in_tile(plan, environment, rect, out); });
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
