#include "core/movement/travel_blocks.hpp"

#include "core/base/parallel.hpp"
#include "core/terrain/tile_changes.hpp"

namespace biotope {

std::vector<char> blocks_of_same_ground(const Ground& a, const Ground& b, int block) {
  const Grid<float>& height = a.terrain->height;
  const int columns = (height.width() + block - 1) / block;
  const int rows = (height.height() + block - 1) / block;
  std::vector<char> same(std::size_t(columns) * std::size_t(rows), 1);
  parallel_rows(0, rows, [&](int row) {
    for (int column = 0; column < columns; ++column) {
      const Rect rect = intersection(height.rect(), {column * block, row * block, (column + 1) * block, (row + 1) * block});
      const bool alike = (a.terrain == b.terrain || same_cells(height, b.terrain->height, rect)) &&
                         (a.hydrology == b.hydrology ||
                          (a.hydrology && b.hydrology && same_cells(a.hydrology->water_depth, b.hydrology->water_depth, rect)));
      same[std::size_t(row) * std::size_t(columns) + std::size_t(column)] = alike ? 1 : 0;
    }
  });
  return same;
}

}  // namespace biotope
