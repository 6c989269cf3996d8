#include <algorithm>
#include <queue>
#include <utility>

#include "core/terrain/neighbours.hpp"
#include "core/terrain/shaping_parts.hpp"

namespace biotope {
namespace {

/// Rise of a bank over a metre of way from cell to cell. Ways over eight neighbours are at most 1 / 0.9239 times longer than the
/// straight line, so that no bank is steeper than 1 : 1.
constexpr double bank_rise = 0.9239;

}  // namespace

void cut_with_banks(Grid<float>& height, double cell_size, std::span<const CutCell> cells, std::span<const LakeBasin> lakes,
                    TouchedTiles& touched) {
  using Entry = std::pair<float, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const auto cut = [&](std::size_t cell, float level) {
    touched.insert_cell(cell);
    if (!(level < height[cell])) return;
    height[cell] = level;
    front.emplace(level, cell);
  };
  for (const CutCell& cell : cells) cut(cell.cell, cell.level);
  const auto width = std::size_t(height.width());
  while (!front.empty()) {
    const auto [level, cell] = front.top();
    front.pop();
    if (height[cell] < level) continue;
    const int x = int(cell % width);
    const int y = int(cell / width);
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (!height.contains(nx, ny)) continue;
      const bool straight = neighbour_dx[d] == 0 || neighbour_dy[d] == 0;
      const auto bank = float(double(level) + cell_size * bank_rise * (straight ? 1.0 : 1.41421356));
      const bool drains = std::any_of(lakes.begin(), lakes.end(), [&](const LakeBasin& lake) {
        return lake.part(nx, ny) != LakeBasin::outside && bank < lake.surface;
      });
      if (drains) {
        touched.insert_cell(height.index(nx, ny));
      } else {
        cut(height.index(nx, ny), bank);
      }
    }
  }
}

}  // namespace biotope
