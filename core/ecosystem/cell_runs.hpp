#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/parallel.hpp"
#include "core/base/rect.hpp"

namespace biotope {

/// Cells [x0, x1) of one row that hold the same value.
struct CellRun {
  int x0 = 0;
  int x1 = 0;
  std::int64_t value = 0;
  bool operator==(const CellRun&) const = default;
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
  bool operator==(const RunTable&) const = default;
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

/// Appends a run that follows the others of its row; it continues the last one when that ends where it begins with the same
/// value. `row_begin` is the number of runs before this row.
inline void append_run(std::vector<CellRun>& out, std::size_t row_begin, CellRun run) {
  if (run.x0 >= run.x1) return;
  if (out.size() > row_begin && out.back().x1 == run.x0 && out.back().value == run.value) {
    out.back().x1 = run.x1;
  } else {
    out.push_back(run);
  }
}

/// Rows that `collect_rows` asks for one after another, on one thread: band y / band_rows.
inline constexpr int band_rows = 32;

/// A table whose rows are made one by one: `append_row(y, out)` appends the runs of row y. Bands of rows are asked in parallel.
template <class AppendRow>
[[nodiscard]] RunTable collect_rows(int width, int height, const AppendRow& append_row) {
  const std::size_t bands = std::size_t((height + band_rows - 1) / band_rows);
  std::vector<std::vector<CellRun>> parts(bands);
  RunTable table{width, height, {}, std::vector<std::size_t>(std::size_t(height) + 1)};
  parallel_each(bands, [&](std::size_t band) {
    const int first = int(band) * band_rows;
    for (int y = first; y < std::min(first + band_rows, height); ++y) {
      const std::size_t before = parts[band].size();
      append_row(y, parts[band]);
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

/// Runs of a map given row by row: `fill_row(y, values)` writes the value of every cell of row y, negative where none. Rows are
/// asked in parallel.
template <class Value = std::int64_t, class FillRow>
[[nodiscard]] RunTable collect_runs(int width, int height, const FillRow& fill_row) {
  return collect_rows(width, height, [&](int y, std::vector<CellRun>& out) {
    std::vector<Value> values(static_cast<std::size_t>(width));
    fill_row(y, std::span<Value>(values));
    append_runs(std::span<const Value>(values), out);
  });
}

/// Runs of a grid of numbers; cells below 0 belong to none.
[[nodiscard]] RunTable runs_of(const Grid<std::int32_t>& numbers);
/// The grid of the runs' values, -1 where there is no run. Parallel.
[[nodiscard]] Grid<std::int32_t> numbers_of(const RunTable& table);

/// Runs of the cells that lie in runs of both tables, with combine(value in a, value in b). Parallel.
template <class Combine>
[[nodiscard]] RunTable intersected(const RunTable& a, const RunTable& b, const Combine& combine) {
  return collect_rows(a.width, a.height, [&](int y, std::vector<CellRun>& out) {
    const std::size_t begin = out.size();
    const auto first = a.row(y);
    const auto second = b.row(y);
    for (std::size_t i = 0, j = 0; i < first.size() && j < second.size();) {
      const int x0 = std::max(first[i].x0, second[j].x0);
      const int x1 = std::min(first[i].x1, second[j].x1);
      append_run(out, begin, {x0, x1, x0 < x1 ? combine(first[i].value, second[j].value) : 0});
      if (first[i].x1 <= second[j].x1) {
        ++i;
      } else {
        ++j;
      }
    }
  });
}

/// The runs of a, cut where runs of b begin and end, with combine(value in a, value in b or -1 where b has none). Parallel.
template <class Combine>
[[nodiscard]] RunTable refined(const RunTable& a, const RunTable& b, const Combine& combine) {
  return collect_rows(a.width, a.height, [&](int y, std::vector<CellRun>& out) {
    const std::size_t begin = out.size();
    const auto second = b.row(y);
    std::size_t j = 0;
    for (const CellRun& run : a.row(y)) {
      for (int x = run.x0; x < run.x1;) {
        while (j < second.size() && second[j].x1 <= x) ++j;
        const bool inside = j < second.size() && second[j].x0 <= x;
        const int border = j < second.size() ? (inside ? second[j].x1 : second[j].x0) : run.x1;
        const int x1 = std::min(run.x1, border);
        append_run(out, begin, {x, x1, combine(run.value, inside ? second[j].value : -1)});
        x = x1;
      }
    }
  });
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
