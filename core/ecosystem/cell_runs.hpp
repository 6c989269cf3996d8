#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/rect.hpp"

namespace biotope {

/// Cells [x0, x1) of one row that hold the same value.
struct CellRun {
  int x0 = 0;
  int x1 = 0;
  std::int64_t value = 0;
};

/// A map as runs, row by row; cells with a negative value belong to no run. Runs of one row are maximal when they come from
/// `collect_runs`.
struct RunTable {
  int width = 0;
  int height = 0;
  std::vector<CellRun> runs;
  /// Runs of row y are [row_start[y], row_start[y + 1]).
  std::vector<std::size_t> row_start;

  [[nodiscard]] std::span<const CellRun> row(int y) const {
    return std::span(runs).subspan(row_start[std::size_t(y)], row_start[std::size_t(y) + 1] - row_start[std::size_t(y)]);
  }
};

/// The first cell from `x` on that does not hold `value`.
template <class Value>
[[nodiscard]] std::size_t end_of_run(std::span<const Value> values, std::size_t x, Value value) {
  constexpr std::size_t block = 32 / sizeof(Value);
  while (x + block <= values.size()) {
    Value difference = 0;
    for (std::size_t i = 0; i < block; ++i) difference = Value(difference | (values[x + i] ^ value));
    if (difference != 0) break;
    x += block;
  }
  while (x < values.size() && values[x] == value) ++x;
  return x;
}

/// Appends the runs of one row of values.
template <class Value>
void append_runs(std::span<const Value> values, std::vector<CellRun>& out) {
  for (std::size_t x = 0; x < values.size();) {
    const Value value = values[x];
    const std::size_t first = x;
    x = end_of_run(values, x, value);
    if (value >= 0) out.push_back({int(first), int(x), std::int64_t(value)});
  }
}

/// Runs of a map given row by row: `fill_row(y, values)` writes the value of every cell of row y, negative where none. Rows are
/// asked in parallel.
template <class Value = std::int64_t, class FillRow>
[[nodiscard]] RunTable collect_runs(int width, int height, const FillRow& fill_row) {
  constexpr int band_rows = 32;
  const std::size_t bands = std::size_t((height + band_rows - 1) / band_rows);
  std::vector<std::vector<CellRun>> parts(bands);
  RunTable table{width, height, {}, std::vector<std::size_t>(std::size_t(height) + 1)};
  parallel_each(bands, [&](std::size_t band) {
    std::vector<Value> values(static_cast<std::size_t>(width));
    const int first = int(band) * band_rows;
    for (int y = first; y < std::min(first + band_rows, height); ++y) {
      fill_row(y, std::span<Value>(values));
      const std::size_t before = parts[band].size();
      append_runs(std::span<const Value>(values), parts[band]);
      table.row_start[std::size_t(y) + 1] = parts[band].size() - before;
    }
  });
  for (std::size_t y = 0; y < std::size_t(height); ++y) table.row_start[y + 1] += table.row_start[y];
  table.runs.resize(table.row_start.back());
  parallel_each(bands, [&](std::size_t band) {
    std::copy(parts[band].begin(), parts[band].end(), table.runs.begin() + std::ptrdiff_t(table.row_start[band * band_rows]));
  });
  return table;
}

/// A set of cells: how many, where, and the sum of their coordinates.
struct Area {
  std::int64_t value = 0;
  std::size_t cells = 0;
  std::int64_t sum_x = 0;
  std::int64_t sum_y = 0;
  Rect bounds;

  [[nodiscard]] float centroid_x() const { return float(double(sum_x) / double(cells)); }
  [[nodiscard]] float centroid_y() const { return float(double(sum_y) / double(cells)); }
  void add_run(int y, const CellRun& run);
};

/// Areas made of runs, numbered by their first run.
struct Areas {
  std::vector<std::int32_t> area_of_run;
  std::vector<Area> areas;
};

/// Connected components (4-neighbours) of equal value. Union-find over runs, linear in the number of runs.
[[nodiscard]] Areas connected_areas(const RunTable& table);

/// How large areas are cut into patches.
struct SplitRule {
  /// Side of the lattice, cells. Areas that reach beyond 1.5 sides are cut along it.
  int side = 1;
  /// Areas with fewer cells are left out.
  std::size_t minimum_cells = 1;
  /// Patches with fewer cells join the neighbour they share the longest border with.
  std::size_t sliver_cells = 1;
  /// ... unless the diagonal of the two together would be longer than this, cells.
  double longest = 1e18;
};

/// Areas after cutting; a patch is connected and keeps the value of its area.
struct Patches {
  /// Runs of the patches only; `value` is the patch.
  RunTable runs;
  std::vector<Area> patches;
};
[[nodiscard]] Patches split_into_patches(const RunTable& table, const Areas& areas, const SplitRule& rule);

/// For each area the cell nearest to its centroid; `area_of_run` numbers the runs of `table`, negative ones are skipped.
struct NearestCell {
  int x = 0;
  int y = 0;
};
[[nodiscard]] std::vector<NearestCell> nearest_to_centroid(const RunTable& table, std::span<const std::int32_t> area_of_run,
                                                           std::span<const Area> areas);

}  // namespace biotope
