#include "core/ecosystem/eaten_zones.hpp"

#include <algorithm>

#include "core/ecosystem/resource_nodes.hpp"

namespace biotope {

std::vector<double> eaten_share(const AnimalLevel& level, int resource) {
  const auto& eaten = level.eaten[std::size_t(resource)];
  const auto& available = level.available[std::size_t(resource)];
  if (std::all_of(eaten.begin(), eaten.end(), [](double kilograms) { return kilograms <= 0; })) return {};
  std::vector<double> share(eaten.size());
  for (std::size_t piece = 0; piece < share.size(); ++piece) {
    share[piece] = available[piece] > 0 ? std::min(1.0, eaten[piece] / available[piece]) : 0;
  }
  return share;
}

EatenZones::EatenZones(std::span<const std::shared_ptr<const AnimalLevel>> levels, std::span<const int> resources) {
  for (const auto& level : levels) {
    Level own{level->partition.get(), nullptr, {}};
    for (const int resource : resources) own.share.push_back(eaten_share(*level, resource));
    if (std::all_of(own.share.begin(), own.share.end(), [](const auto& share) { return share.empty(); })) continue;
    count_ *= std::int64_t(own.partition->pieces.size()) + 1;
    own.pieces = piece_runs(*level);
    levels_.push_back(std::move(own));
  }
}

RunTable EatenZones::refined(const RunTable& table) const {
  RunTable result = table;
  for (const Level& level : levels_) {
    const std::int64_t base = std::int64_t(level.partition->pieces.size()) + 1;
    result = biotope::refined(result, *level.pieces,
                              [base](std::int64_t value, std::int64_t piece) { return value * base + piece + 1; });
  }
  return result;
}

double EatenZones::left(std::int64_t zone, std::size_t resource) const {
  double left = 1;
  for (std::size_t i = levels_.size(); i-- > 0;) {
    const std::int64_t base = std::int64_t(levels_[i].partition->pieces.size()) + 1;
    const std::int64_t piece = zone % base - 1;
    zone /= base;
    const auto& share = levels_[i].share[resource];
    if (piece >= 0 && !share.empty()) left *= 1 - share[std::size_t(piece)];
  }
  return left;
}

}  // namespace biotope
