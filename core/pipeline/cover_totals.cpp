#include "core/pipeline/cover_totals.hpp"

#include <numeric>

#include "core/base/parallel.hpp"

namespace biotope {
namespace {

std::int64_t sum_of_tile(const CoverMap& cover, std::size_t index) {
  const CoverMap::TilePointer& tile = cover.tile(index);
  if (!tile) return 0;
  const Rect rect = cover.tile_rect(index);
  std::int64_t sum = 0;
  for (int y = rect.y0; y < rect.y1; ++y) {
    const Cover* row = tile->data() + CoverMap::offset(rect.x0, y);
    sum += std::accumulate(row, row + rect.width(), std::int64_t{0});
  }
  return sum;
}

}  // namespace

void update_cover_totals(CoverTotals& totals, std::span<const std::shared_ptr<const CoverMap>> covers) {
  totals.covers.resize(covers.size());
  totals.sums.resize(covers.size());
  parallel_each(covers.size(), [&](std::size_t i) {
    const CoverMap& after = *covers[i];
    const CoverMap* before = totals.covers[i].get();
    const bool known = before != nullptr && before->rect() == after.rect();
    if (!known) totals.sums[i] = 0;
    for (std::size_t tile = 0; tile < after.tile_count(); ++tile) {
      if (known && before->tile(tile) == after.tile(tile)) continue;
      totals.sums[i] += sum_of_tile(after, tile) - (known ? sum_of_tile(*before, tile) : 0);
    }
    totals.covers[i] = covers[i];
  });
}

std::vector<double> shares_of(const CoverTotals& totals) {
  std::vector<double> shares(totals.sums.begin(), totals.sums.end());
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share = total > 0 ? share / total : 0;
  return shares;
}

}  // namespace biotope
