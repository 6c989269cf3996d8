#include "core/ecosystem/cell_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ecosystem/disjoint_sets.hpp"

namespace biotope {

void Area::add_run(int y, const CellRun& run) {
  const std::int64_t length = run.x1 - run.x0;
  cells += std::size_t(length);
  sum_x += length * (std::int64_t(run.x0) + run.x1 - 1) / 2;
  sum_y += length * y;
  bounds = bounding(bounds, {run.x0, y, run.x1, y + 1});
}

RunTable runs_of(const Grid<std::int32_t>& numbers) {
  return collect_rows(numbers.width(), numbers.height(),
                      [&](int y, std::vector<CellRun>& out) { append_runs(numbers.row(y), out); });
}

Grid<std::int32_t> numbers_of(const RunTable& table) {
  Grid<std::int32_t> numbers(table.width, table.height, -1);
  parallel_rows(0, table.height, [&](int y) {
    const auto row = numbers.row(y);
    for (const CellRun& run : table.row(y)) std::fill(row.begin() + run.x0, row.begin() + run.x1, std::int32_t(run.value));
  });
  return numbers;
}

Areas numbered_areas(const RunTable& table, DisjointSets& sets) {
  Areas result;
  result.area_of_run.resize(table.runs.size());
  for (int y = 0; y < table.height; ++y) {
    for (std::size_t i = table.row_start[std::size_t(y)]; i < table.row_start[std::size_t(y) + 1]; ++i) {
      const std::size_t root = sets.find(i);
      if (root == i) {
        result.area_of_run[i] = std::int32_t(result.areas.size());
        result.areas.emplace_back().value = table.runs[i].value;
      } else {
        result.area_of_run[i] = result.area_of_run[root];
      }
      result.areas[std::size_t(result.area_of_run[i])].add_run(y, table.runs[i]);
    }
  }
  return result;
}

Areas connected_areas(const RunTable& table) {
  DisjointSets sets(table.runs.size());
  for (int y = 1; y < table.height; ++y) {
    for_each_overlap(table, y, [&](std::size_t above, std::size_t below, int) {
      if (table.runs[above].value == table.runs[below].value) sets.unite(above, below);
    });
  }
  return numbered_areas(table, sets);
}

std::vector<NearestCell> nearest_to_centroid(const RunTable& table, std::span<const std::int32_t> area_of_run,
                                             std::span<const Area> areas) {
  std::vector<NearestCell> nearest(areas.size());
  std::vector<double> best(areas.size(), std::numeric_limits<double>::infinity());
  for (int y = 0; y < table.height; ++y) {
    for (std::size_t i = table.row_start[std::size_t(y)]; i < table.row_start[std::size_t(y) + 1]; ++i) {
      if (area_of_run[i] < 0) continue;
      const std::size_t area = std::size_t(area_of_run[i]);
      const double centre_x = areas[area].centroid_x();
      const int x = std::clamp(int(std::lround(centre_x)), table.runs[i].x0, table.runs[i].x1 - 1);
      const double dx = x - centre_x;
      const double dy = y - double(areas[area].centroid_y());
      const double distance = dx * dx + dy * dy;
      if (distance < best[area]) {
        best[area] = distance;
        nearest[area] = {x, y};
      }
    }
  }
  return nearest;
}

}  // namespace biotope
