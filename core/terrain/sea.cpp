#include <vector>

#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"

namespace biotope {

Grid<std::uint8_t> find_sea(const Grid<float>& height, float sea_level) {
  const int width = height.width();
  const int rows = height.height();
  Grid<std::uint8_t> sea;
  std::vector<std::uint32_t> stack;
  const auto reach = [&](int x, int y) {
    if (height(x, y) >= sea_level) return;
    if (sea.empty()) sea = Grid<std::uint8_t>(width, rows);
    if (sea(x, y) != 0) return;
    sea(x, y) = 1;
    stack.push_back(std::uint32_t(height.index(x, y)));
  };
  for (int x = 0; x < width; ++x) {
    reach(x, 0);
    reach(x, rows - 1);
  }
  for (int y = 0; y < rows; ++y) {
    reach(0, y);
    reach(width - 1, y);
  }
  while (!stack.empty()) {
    const int x = int(stack.back() % std::uint32_t(width));
    const int y = int(stack.back() / std::uint32_t(width));
    stack.pop_back();
    for (std::size_t d = 0; d < 8; ++d) {
      const int nx = x + neighbour_dx[d];
      const int ny = y + neighbour_dy[d];
      if (height.contains(nx, ny)) reach(nx, ny);
    }
  }
  return sea;
}

}  // namespace biotope
