#include "core/ecosystem/eaten_zones.hpp"

#include <algorithm>

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
    Level own{level->partition.get(), {}};
    for (const int resource : resources) own.share.push_back(eaten_share(*level, resource));
    if (std::all_of(own.share.begin(), own.share.end(), [](const auto& share) { return share.empty(); })) continue;
    count_ *= std::int64_t(own.partition->pieces.size()) + 1;
    levels_.push_back(std::move(own));
  }
}

void EatenZones::refine_row(int y, std::span<std::int64_t> values) const {
  for (const Level& level : levels_) {
    const std::int64_t base = std::int64_t(level.partition->pieces.size()) + 1;
    const auto piece = level.partition->label.row(y);
    for (std::size_t x = 0; x < values.size(); ++x) values[x] = values[x] < 0 ? values[x] : values[x] * base + piece[x] + 1;
  }
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
