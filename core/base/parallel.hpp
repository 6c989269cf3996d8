#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "core/base/rect.hpp"

namespace biotope {

/// Calls body(row) for every row in [first, last), in any order and on any thread. The body may write
/// only what belongs to its row, so the result does not depend on the number of threads.
template <class Body>
void parallel_rows(int first, int last, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<int>(first, last, 8), [&](const tbb::blocked_range<int>& range) {
    for (int row = range.begin(); row < range.end(); ++row) body(row);
  });
}

/// Calls body(index) for every index in [0, count), one task an index, under the rule of parallel_rows.
template <class Body>
void parallel_each(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
                    });
}

/// Calls body(rect) for the square tiles of `side` cells that cover a width x height grid.
template <class Body>
void parallel_tiles(int width, int height, int side, const Body& body) {
  const int columns = (width + side - 1) / side;
  const int rows = (height + side - 1) / side;
  parallel_each(std::size_t(columns) * std::size_t(rows), [&](std::size_t i) {
    const int x0 = int(i % std::size_t(columns)) * side;
    const int y0 = int(i / std::size_t(columns)) * side;
    body(Rect{x0, y0, std::min(x0 + side, width), std::min(y0 + side, height)});
  });
}

}  // namespace biotope
