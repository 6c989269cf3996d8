#include "core/climate/diffusion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/vector_clones.hpp"

namespace biotope {
namespace {

// Elimination down a line: with L and R the conductances to the cells before and after,
//   share' = R / (1 + L (1 - share) + R),   value' = (value + L value_before') / (the same),
// and back up: value = value' + share' * value_after. All terms are positive, so nothing cancels.

void diffuse_row(std::span<float> values, std::span<const float> conductance, std::span<float> share) {
  const std::size_t count = values.size();
  float before = 0;
  float last_share = 0;
  float to_before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float own = conductance[i];
    const float to_after = i + 1 < count ? 0.5F * (std::abs(own) + std::abs(conductance[i + 1])) : 0;
    const float left = own < 0 ? 0 : to_before;
    const float right = own < 0 ? 0 : to_after;
    const float inverse = 1 / (1 + left * (1 - last_share) + right);
    last_share = right * inverse;
    before = (values[i] + left * before) * inverse;
    share[i] = last_share;
    values[i] = before;
    to_before = to_after;
  }
  for (std::size_t i = count - 1; i-- > 0;) values[i] += share[i] * values[i + 1];
}

/// Columns that are eliminated together.
constexpr int strip = 64;

/// One row of the elimination down `count` columns.
struct ColumnsRow {
  const float* before_conductance;
  const float* conductance;
  const float* after_conductance;
  const float* before_share;
  const float* before_value;
  float* share;
  float* value;
};

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

}  // namespace

void diffuse(Grid<float>& values, const Grid<float>& conductance) {
  assert(values.width() == conductance.width() && values.height() == conductance.height());
  if (values.empty()) return;
  parallel_rows(0, values.height(), [&](int y) {
    std::vector<float> share(std::size_t(values.width()));
    diffuse_row(values.row(y), conductance.row(y), share);
  });
  const int strips = (values.width() + strip - 1) / strip;
  parallel_each(std::size_t(strips), [&](std::size_t i) {
    const int x0 = int(i) * strip;
    diffuse_columns(values, conductance, x0, std::min(strip, values.width() - x0));
  });
}

}  // namespace biotope
