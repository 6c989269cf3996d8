#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/paint.hpp"
#include "core/ecosystem/confinement.hpp"

namespace biotope {

/// Losses are counted in steps of 1/32768, so that sums over cells are whole numbers and exact in any order.
inline constexpr std::uint16_t whole_loss = 32768;

/// Share of a cell's yearly growth that paint says is lost (0..1 x coverage), in steps of 1/whole_loss.
[[nodiscard]] inline std::uint16_t loss_steps(Paint paint) {
  return std::uint16_t(std::clamp(painted(0, paint), 0.0F, 1.0F) * float(whole_loss) + 0.5F);
}

/// What is left of growth; exactly 1 where nothing is lost and 0 where all is.
[[nodiscard]] inline float share_kept(std::uint16_t loss) { return 1 - float(loss) / float(whole_loss); }

/// Paint on a species' losses from a list by species number, or null.
[[nodiscard]] inline const PaintLayer* loss_of(std::span<const std::shared_ptr<const PaintLayer>> losses, int species) {
  return std::size_t(species) < losses.size() ? losses[std::size_t(species)].get() : nullptr;
}

/// Mean share lost over the cells of each region, 0..1; all 0 without paint. Only painted tiles are read.
[[nodiscard]] std::vector<double> mean_losses(const ConfinementRegions& regions, const PaintLayer* loss);

}  // namespace biotope
