#pragma once

namespace biotope {

// Elimination down a line of a diffusion: with L and R the conductances to the cells before and after,
//   share' = R / (1 + L (1 - share) + R),   value' = (value + L value_before') / (the same),
// and back up: value = value' + share' * value_after. All terms are positive, so nothing cancels. Lines go side by side.

/// One row of the elimination down some columns.
struct ColumnsRow {
  const float* before_conductance;
  const float* conductance;
  const float* after_conductance;
  const float* before_share;
  const float* before_value;
  float* share;
  float* value;
};

/// `has_before` and `has_after` are 0 at the ends of the line, else 1.
void eliminate_columns(ColumnsRow row, int count, float has_before, float has_after);

void add_back_columns(float* values, const float* share, const float* after, int count);

}  // namespace biotope
