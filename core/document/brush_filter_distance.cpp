#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/parallel.hpp"
#include "core/document/brush_filter.hpp"

namespace biotope {
namespace {

/// Columns that one task sweeps together: a cache line's worth of cells and more.
constexpr int column_block = 64;
constexpr int unreached = -1;

/// Rows to the nearest wet cell of the same column; `unreached` where there is none.
Grid<int> column_distances(const Grid<std::uint8_t>& wet) {
  Grid<int> rows(wet.width(), wet.height(), unreached);
  const int blocks = (wet.width() + column_block - 1) / column_block;
  parallel_each(std::size_t(blocks), [&](std::size_t block) {
    const int x0 = int(block) * column_block;
    const int x1 = std::min(wet.width(), x0 + column_block);
    const auto sweep = [&](int y, int from) {
      for (int x = x0; x < x1; ++x) {
        const int before = from >= 0 && from < wet.height() ? rows(x, from) : unreached;
        const int reached = before == unreached ? unreached : before + 1;
        int& here = rows(x, y);
        if (wet(x, y) != 0) {
          here = 0;
        } else if (reached != unreached && (here == unreached || reached < here)) {
          here = reached;
        }
      }
    };
    for (int y = 0; y < wet.height(); ++y) sweep(y, y - 1);
    for (int y = wet.height(); y-- > 0;) sweep(y, y + 1);
  });
  return rows;
}

/// One column's part in the lower envelope of a row: the parabola (x - at)^2 + height, least from `start` on.
struct Parabola {
  double at = 0;
  double height = 0;
  double start = 0;
};

/// Where the later of two parabolas becomes the lesser one.
double crossing(const Parabola& earlier, double at, double height) {
  return ((height + at * at) - (earlier.height + earlier.at * earlier.at)) / (2 * (at - earlier.at));
}

/// Distances along one row by the lower envelope of parabolas: P. Felzenszwalb and D. Huttenlocher, 'Distance transforms of
/// sampled functions', Theory of Computing 8 (2012). All squares are whole numbers below 2^53, so the distances are exact.
void row_distances(std::span<const int> columns, double cell_size, std::vector<Parabola>& envelope, std::span<float> out) {
  envelope.clear();
  for (std::size_t x = 0; x < columns.size(); ++x) {
    if (columns[x] == unreached) continue;
    const double at = double(x);
    const double height = double(columns[x]) * double(columns[x]);
    while (!envelope.empty() && crossing(envelope.back(), at, height) <= envelope.back().start) envelope.pop_back();
    const double start = envelope.empty() ? -double(no_distance) : crossing(envelope.back(), at, height);
    envelope.push_back({at, height, start});
  }
  if (envelope.empty()) {
    std::fill(out.begin(), out.end(), no_distance);
    return;
  }
  std::size_t lowest = 0;
  for (std::size_t x = 0; x < columns.size(); ++x) {
    while (lowest + 1 < envelope.size() && envelope[lowest + 1].start <= double(x)) ++lowest;
    const double away = double(x) - envelope[lowest].at;
    out[x] = float(std::sqrt(away * away + envelope[lowest].height) * cell_size);
  }
}

}  // namespace

Grid<float> distance_to(const Grid<std::uint8_t>& wet, double cell_size) {
  Grid<float> distances(wet.width(), wet.height());
  const Grid<int> columns = column_distances(wet);
  parallel_tiles(1, wet.height(), 16, [&](const Rect& rows) {
    std::vector<Parabola> envelope;
    for (int y = rows.y0; y < rows.y1; ++y) row_distances(columns.row(y), cell_size, envelope, distances.row(y));
  });
  return distances;
}

}  // namespace biotope
