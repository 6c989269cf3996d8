#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/rect.hpp"
#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/ecosystem/cover.hpp"
#include "core/ecosystem/plant_competition_kernel.hpp"

namespace biotope {

inline constexpr std::string_view plant_competition_stage = "plant competition";

/// Runs `compete(x, y, count)`, which leaves the covers of `count` cells of row y from x on in the batch, over a part of a tile.
template <class Compete>
void compete_in_batches(const Rect& part, CompetitionBatch& batch, std::span<CoverMap::Tile* const> out, const Compete& compete) {
  for (int y = part.y0; y < part.y1; ++y) {
    for (int x = part.x0; x < part.x1; x += batch_cells) {
      const int count = std::min(batch_cells, part.x1 - x);
      compete(x, y, count);
      const std::size_t first = CoverMap::offset(x, y);
      for (std::size_t plant = 0; plant < out.size(); ++plant) {
        for (int lane = 0; lane < count; ++lane) {
          (*out[plant])[first + std::size_t(lane)] = Cover(batch.cover[plant].v[lane]);
        }
      }
    }
  }
}

/// One tile of every map by `compete(rect, tiles)`; tiles in which a plant does not grow stay null.
template <class Compete>
void compete_for_tile(std::size_t index, std::vector<CoverMap>& covers, const Compete& compete) {
  std::vector<CoverMap::Tile> tiles(covers.size());
  std::vector<CoverMap::Tile*> out;
  for (CoverMap::Tile& tile : tiles) out.push_back(&tile);
  compete(covers.front().tile_rect(index), std::span<CoverMap::Tile* const>(out));
  for (std::size_t plant = 0; plant < covers.size(); ++plant) {
    if (std::ranges::all_of(tiles[plant], [](Cover cover) { return cover == 0; })) continue;
    covers[plant].set_tile(index, std::make_shared<const CoverMap::Tile>(tiles[plant]));
  }
}

/// All tiles of `plants` maps by `compete(rect, tiles)`, in parallel; an Error where it was stopped.
template <class Compete>
Result<std::vector<CoverMap>> compete_everywhere(const Rect& area, int plants, const TaskContext& context,
                                                 const Compete& compete) {
  // Tiles between two reports: enough to keep every core busy.
  constexpr std::size_t tiles_at_once = 64;
  std::vector<CoverMap> covers(std::size_t(plants), CoverMap(area.width(), area.height()));
  if (covers.empty()) return covers;
  const std::size_t tiles = covers.front().tile_count();
  for (std::size_t first = 0; first < tiles; first += tiles_at_once) {
    if (context.stopped()) return fail("Plant competition was stopped.");
    context.report(plant_competition_stage, double(first) / double(tiles));
    parallel_each(std::min(tiles_at_once, tiles - first), [&](std::size_t i) {
      if (!context.stopped()) compete_for_tile(first + i, covers, compete);
    });
  }
  if (context.stopped()) return fail("Plant competition was stopped.");
  context.report(plant_competition_stage, 1);
  return covers;
}

}  // namespace biotope
