#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/ecosystem/cell_runs.hpp"

namespace biotope {

/// Union-find whose representative is the smallest member, so that numbering does not depend on the order of unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::size_t find(std::size_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }
  void unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    if (a < b) parent_[b] = std::uint32_t(a);
    if (b < a) parent_[a] = std::uint32_t(b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Areas of the runs that `sets` joined, numbered by their first run.
[[nodiscard]] Areas numbered_areas(const RunTable& table, DisjointSets& sets);

/// Calls body(above, below, cells) for every pair of runs of rows y - 1 and y that share `cells` > 0 columns.
template <class Body>
void for_each_overlap(const RunTable& table, int y, const Body& body) {
  std::size_t above = table.row_start[std::size_t(y) - 1];
  std::size_t below = table.row_start[std::size_t(y)];
  const std::size_t above_end = below;
  const std::size_t below_end = table.row_start[std::size_t(y) + 1];
  while (above < above_end && below < below_end) {
    const CellRun& a = table.runs[above];
    const CellRun& b = table.runs[below];
    const int shared = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
    if (shared > 0) body(above, below, shared);
    if (a.x1 <= b.x1) {
      ++above;
    } else {
      ++below;
    }
  }
}

}  // namespace biotope
