#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "core/ecosystem/cell_runs.hpp"

namespace biotope {

/// A number for every cell, kept as runs: a map of large areas takes little memory and little time to make. Reads like a Grid; -1
/// where there is no run. Copies share the runs.
class RunMap {
 public:
  RunMap() : runs_(std::make_shared<const RunTable>(RunTable{0, 0, {}, {0}})) {}
  /// Takes the runs of a map; their values are the numbers.
  explicit RunMap(RunTable runs) : runs_(std::make_shared<const RunTable>(std::move(runs))) {}
  /// The runs of a grid; cells below 0 are in none.
  explicit RunMap(const Grid<std::int32_t>& numbers) : RunMap(runs_of(numbers)) {}

  [[nodiscard]] int width() const { return runs_->width; }
  [[nodiscard]] int height() const { return runs_->height; }
  [[nodiscard]] std::size_t size() const { return std::size_t(width()) * std::size_t(height()); }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Rect rect() const { return {0, 0, width(), height()}; }
  [[nodiscard]] bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width() && y < height(); }
  [[nodiscard]] const RunTable& runs() const { return *runs_; }
  [[nodiscard]] const std::shared_ptr<const RunTable>& shared_runs() const { return runs_; }

  /// The number of a cell; found among the runs of its row by bisection.
  [[nodiscard]] std::int32_t operator()(int x, int y) const {
    const auto row = runs_->row(y);
    const auto after =
        std::upper_bound(row.begin(), row.end(), x, [](int column, const CellRun& run) { return column < run.x0; });
    return after != row.begin() && x < (after - 1)->x1 ? std::int32_t((after - 1)->value) : -1;
  }
  /// The same by the cell's place in row order.
  [[nodiscard]] std::int32_t operator[](std::size_t i) const {
    return (*this)(int(i % std::size_t(width())), int(i / std::size_t(width())));
  }
  /// Writes the numbers of columns [x0, x0 + out.size()) of row y.
  void read_row(int y, int x0, std::span<std::int32_t> out) const {
    std::fill(out.begin(), out.end(), -1);
    const int x1 = x0 + int(out.size());
    const auto row = runs_->row(y);
    auto run = std::upper_bound(row.begin(), row.end(), x0, [](int column, const CellRun& own) { return column < own.x1; });
    for (; run != row.end() && run->x0 < x1; ++run) {
      std::fill(out.begin() + (std::max(run->x0, x0) - x0), out.begin() + (std::min(run->x1, x1) - x0), std::int32_t(run->value));
    }
  }

  /// The same numbers: runs that follow each other in a row have different ones.
  bool operator==(const RunMap& other) const { return runs_ == other.runs_ || *runs_ == *other.runs_; }

 private:
  std::shared_ptr<const RunTable> runs_;
};

}  // namespace biotope
