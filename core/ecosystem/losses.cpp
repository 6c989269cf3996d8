#include "core/ecosystem/losses.hpp"

#include <array>
#include <span>

namespace biotope {

std::vector<double> mean_losses(const ConfinementRegions& regions, const PaintLayer* loss) {
  std::vector<double> mean(regions.regions.size());
  if (loss == nullptr) return mean;
  std::vector<std::uint64_t> sum(mean.size());
  for (std::size_t tile = 0; tile < loss->tile_count(); ++tile) {
    if (!loss->tile(tile) && loss_steps(loss->background()) == 0) continue;
    const Rect cells = loss->tile_rect(tile);
    for (int y = cells.y0; y < cells.y1; ++y) {
      std::array<std::int32_t, tile_side> label{};
      regions.label.read_row(y, cells.x0, std::span(label).first(std::size_t(cells.width())));
      for (int x = cells.x0; x < cells.x1; ++x) {
        const std::int32_t region = label[std::size_t(x - cells.x0)];
        if (region >= 0) sum[std::size_t(region)] += loss_steps((*loss)(x, y));
      }
    }
  }
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i] = double(sum[i]) / (double(regions.regions[i].cells) * whole_loss);
  }
  return mean;
}

}  // namespace biotope
