#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/terrain/water_marking.hpp"

namespace biotope {
namespace {

/// Half the length of a deer's leg, m: as deep as a typical animal wades without swimming. Our choice.
constexpr float deepest_ford = 0.45F;
/// Brooks that are nowhere deeper than this need no ford, m. Our choice.
constexpr float needs_ford = 0.25F;
/// Steepest bank an animal climbs, rise / run (the obstacle limit of the 2021 authors' public code).
constexpr float steepest_bank = 0.5F;
constexpr double ford_spacing = 200;

struct Candidate {
  float depth;
  std::uint32_t cell;
};

/// True when the ground rises gently on both sides of the channel, across its direction of flow.
bool passable_banks(const Terrain& terrain, const Hydrology& hydrology, const RiverReach& reach, std::size_t at) {
  const int width = terrain.height.width();
  const std::uint32_t up = reach.cells[at >= 3 ? at - 3 : 0];
  const std::uint32_t down = reach.cells[std::min(at + 3, reach.cells.size() - 1)];
  const double along_x = int(down % std::uint32_t(width)) - int(up % std::uint32_t(width));
  const double along_y = int(down / std::uint32_t(width)) - int(up / std::uint32_t(width));
  const double length = std::hypot(along_x, along_y);
  if (length == 0) return false;
  const std::uint32_t cell = reach.cells[at];
  const int x = int(cell % std::uint32_t(width));
  const int y = int(cell / std::uint32_t(width));
  const double half = double(river_width(hydrology.discharge[cell])) / 2 / terrain.cell_size;
  for (const double side : {-1.0, 1.0}) {
    for (const double beyond : {1.0, 2.5}) {
      const double distance = half + beyond;
      const int bx = x + int(std::lround(-side * along_y / length * distance));
      const int by = y + int(std::lround(side * along_x / length * distance));
      if (!terrain.height.contains(bx, by)) return false;
      const double rise = std::abs(double(terrain.height(bx, by)) - double(terrain.height[cell]));
      if (rise > steepest_bank * distance * terrain.cell_size) return false;
      if (hydrology.water(bx, by) == WaterKind::lake || hydrology.water(bx, by) == WaterKind::sea) return false;
    }
  }
  return true;
}

/// Shallowest cells within half the spacing up and down of their reach.
void add_candidates(const Terrain& terrain, const Hydrology& hydrology, const RiverReach& reach, std::vector<Candidate>& candidates) {
  const auto depth = [&](std::size_t i) { return hydrology.water_depth[reach.cells[i]]; };
  const auto window = std::size_t(std::clamp(ford_spacing / 2 / terrain.cell_size, 1.0, 1e6));
  // The ends of a reach lie at junctions, lakes and the border.
  for (std::size_t i = 1; i + 1 < reach.cells.size(); ++i) {
    if (hydrology.water[reach.cells[i]] != WaterKind::river || depth(i) > deepest_ford) continue;
    const std::size_t first = i >= window ? i - window : 0;
    const std::size_t last = std::min(i + window, reach.cells.size() - 1);
    bool shallowest = true;
    for (std::size_t j = first; j <= last && shallowest; ++j) shallowest = depth(j) >= depth(i) || hydrology.water[reach.cells[j]] != WaterKind::river;
    if (shallowest && passable_banks(terrain, hydrology, reach, i)) candidates.push_back({depth(i), reach.cells[i]});
  }
}

}  // namespace

void find_fords(const Terrain& terrain, Hydrology& hydrology) {
  std::vector<Candidate> candidates;
  for (const RiverReach& reach : hydrology.reaches) {
    if (reach.depth >= needs_ford) add_candidates(terrain, hydrology, reach, candidates);
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.cell < b.cell;
  });
  const auto width = std::uint32_t(terrain.height.width());
  for (const Candidate& candidate : candidates) {
    const int x = int(candidate.cell % width);
    const int y = int(candidate.cell / width);
    const bool apart = std::none_of(hydrology.fords.begin(), hydrology.fords.end(), [&](const Ford& ford) {
      return std::hypot(ford.x - x, ford.y - y) * terrain.cell_size < ford_spacing;
    });
    if (apart) hydrology.fords.push_back({x, y, candidate.depth});
  }
}

}  // namespace biotope
