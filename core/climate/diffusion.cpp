#include "core/climate/diffusion.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/climate/elimination.hpp"
#include "core/terrain/vector_clones.hpp"

namespace biotope {
BIOTOPE_VECTOR_CLONES void eliminate_columns(const ColumnsRow row, int count, float has_before, float has_after) {
  for (int i = 0; i < count; ++i) {
    const float own = row.conductance[i];
    const float moves = own < 0 ? 0.0F : 0.5F;
    const float left = has_before * moves * (std::abs(own) + std::abs(row.before_conductance[i]));
    const float right = has_after * moves * (std::abs(own) + std::abs(row.after_conductance[i]));
    const float inverse = 1 / (1 + left * (1 - row.before_share[i]) + right);
    row.share[i] = right * inverse;
    row.value[i] = (row.value[i] + left * row.before_value[i]) * inverse;
  }
}

BIOTOPE_VECTOR_CLONES void add_back_columns(float* values, const float* share, const float* after, int count) {
  for (int i = 0; i < count; ++i) values[i] += share[i] * after[i];
}

namespace {

/// Columns that are eliminated together.
constexpr int strip = 64;

void diffuse_columns(Grid<float>& values, const Grid<float>& conductance, int x0, int count) {
  const int height = values.height();
  std::vector<float> shares(std::size_t(height) * strip);
  const std::vector<float> none(strip, 0.0F);
  for (int y = 0; y < height; ++y) {
    const bool first = y == 0;
    const bool last = y + 1 == height;
    float* const share = shares.data() + std::size_t(y) * strip;
    const float* const own = conductance.row(y).data() + x0;
    eliminate_columns({first ? own : conductance.row(y - 1).data() + x0, own, last ? own : conductance.row(y + 1).data() + x0,
                       first ? none.data() : share - strip, first ? none.data() : values.row(y - 1).data() + x0, share,
                       values.row(y).data() + x0},
                      count, first ? 0.0F : 1.0F, last ? 0.0F : 1.0F);
  }
  for (int y = height - 1; y-- > 0;) {
    add_back_columns(values.row(y).data() + x0, shares.data() + std::size_t(y) * strip, values.row(y + 1).data() + x0, count);
  }
}

/// Rows that are eliminated together, as columns.
constexpr int rows_at_once = 8;

/// Cells of a few rows side by side: column x of all of them lies at x * rows_at_once.
void load_rows(const Grid<float>& grid, int y0, int count, std::vector<float>& out) {
  for (int r = 0; r < count; ++r) {
    const auto row = grid.row(y0 + r);
    for (std::size_t x = 0; x < row.size(); ++x) out[x * rows_at_once + std::size_t(r)] = row[x];
  }
}

/// Room for some rows, kept from one to the next.
struct RowsRoom {
  std::vector<float> values;
  std::vector<float> conductance;
  std::vector<float> shares;
};

void diffuse_rows(Grid<float>& values, const Grid<float>& conductance, int y0, int count, RowsRoom& room) {
  const auto width = std::size_t(values.width());
  for (std::vector<float>* part : {&room.values, &room.conductance, &room.shares}) part->resize(width * rows_at_once);
  load_rows(values, y0, count, room.values);
  load_rows(conductance, y0, count, room.conductance);
  const std::array<float, rows_at_once> none{};
  for (std::size_t x = 0; x < width; ++x) {
    const bool first = x == 0;
    const bool last = x + 1 == width;
    float* const share = room.shares.data() + x * rows_at_once;
    float* const value = room.values.data() + x * rows_at_once;
    const float* const own = room.conductance.data() + x * rows_at_once;
    eliminate_columns({first ? own : own - rows_at_once, own, last ? own : own + rows_at_once,
                       first ? none.data() : share - rows_at_once, first ? none.data() : value - rows_at_once, share, value},
                      rows_at_once, first ? 0.0F : 1.0F, last ? 0.0F : 1.0F);
  }
  for (std::size_t x = width - 1; x-- > 0;) {
    const std::size_t at = x * rows_at_once;
    add_back_columns(room.values.data() + at, room.shares.data() + at, room.values.data() + at + rows_at_once, rows_at_once);
  }
  for (int r = 0; r < count; ++r) {
    const auto row = values.row(y0 + r);
    for (std::size_t x = 0; x < width; ++x) row[x] = room.values[x * rows_at_once + std::size_t(r)];
  }
}

}  // namespace

void diffuse(Grid<float>& values, const Grid<float>& conductance) {
  assert(values.width() == conductance.width() && values.height() == conductance.height());
  if (values.empty()) return;
  const int bundles = (values.height() + rows_at_once - 1) / rows_at_once;
  tbb::parallel_for(tbb::blocked_range<int>(0, bundles, 4), [&](const tbb::blocked_range<int>& range) {
    RowsRoom room;
    for (int i = range.begin(); i < range.end(); ++i) {
      const int y0 = i * rows_at_once;
      diffuse_rows(values, conductance, y0, std::min(rows_at_once, values.height() - y0), room);
    }
  });
  const int strips = (values.width() + strip - 1) / strip;
  parallel_each(std::size_t(strips), [&](std::size_t i) {
    const int x0 = int(i) * strip;
    diffuse_columns(values, conductance, x0, std::min(strip, values.width() - x0));
  });
}

}  // namespace biotope
