#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/ecosystem/cover.hpp"

namespace biotope {

/// Summed cover of each plant (1/full_cover cells), kept up to date by the tiles that differ.
struct CoverTotals {
  std::vector<std::shared_ptr<const CoverMap>> covers;
  std::vector<std::int64_t> sums;
};

/// Brings the sums up to date with these covers.
void update_cover_totals(CoverTotals& totals, std::span<const std::shared_ptr<const CoverMap>> covers);

/// Shares of the level's cover, one per plant; zeros when all are empty.
[[nodiscard]] std::vector<double> shares_of(const CoverTotals& totals);

}  // namespace biotope
