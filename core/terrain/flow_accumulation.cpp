#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/vector_clones.hpp"

namespace biotope {
namespace {

/// Marks a cell whose water has been passed on.
constexpr std::uint8_t passed_on = 255;

/// Neighbours whose receiver is each cell.
Grid<std::uint8_t> count_donors(const Grid<std::uint8_t>& receiver) {
  Grid<std::uint8_t> donors(receiver.width(), receiver.height());
  parallel_rows(0, receiver.height(), [&](int y) {
    for (int x = 0; x < receiver.width(); ++x) {
      int count = 0;
      for (int d = 0; d < 8; ++d) {
        const int nx = x + neighbour_dx[std::size_t(d)];
        const int ny = y + neighbour_dy[std::size_t(d)];
        if (receiver.contains(nx, ny) && receiver(nx, ny) == opposite_direction(d)) ++count;
      }
      donors(x, y) = std::uint8_t(count);
    }
  });
  return donors;
}

/// Neighbours that give some of their water to each cell under multiple flow directions.
Grid<std::uint8_t> count_multiple_donors(const Grid<float>& filled, const Grid<std::uint8_t>& receiver) {
  Grid<std::uint8_t> donors(receiver.width(), receiver.height());
  parallel_rows(0, receiver.height(), [&](int y) {
    for (int x = 0; x < receiver.width(); ++x) {
      int count = 0;
      for (int d = 0; d < 8; ++d) {
        const int nx = x + neighbour_dx[std::size_t(d)];
        const int ny = y + neighbour_dy[std::size_t(d)];
        if (!receiver.contains(nx, ny) || receiver(nx, ny) == leaves_map) continue;
        const bool gives = filled(nx, ny) > filled(x, y) || receiver(nx, ny) == opposite_direction(d);
        count += gives ? 1 : 0;
      }
      donors(x, y) = std::uint8_t(count);
    }
  });
  return donors;
}

using Shares = std::array<float, 8>;

/// x^1.1 of eight falls, 0 for 0, within 0.02 %: x times 2^(log2(x) / 10), both by polynomials, the same on every machine.
BIOTOPE_VECTOR_CLONES
void raise_to_exponent(Shares& falls) {
  for (std::size_t d = 0; d < 8; ++d) {
    const float x = falls[d];
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const auto exponent = float(std::int32_t(bits >> 23) - 127);
    const float m = std::bit_cast<float>((bits & 0x007fffffU) | 0x3f800000U) - 1;
    const float log2 = exponent + m * (1.4425449F + m * (-0.7181452F + m * (0.4575485F + m * (-0.2779042F + m * 0.0959559F))));
    const float power = log2 * 0.1F + 64;
    const auto whole = std::int32_t(power);
    const float f = power - float(whole);
    const float fraction = 1 + f * (0.6931472F + f * (0.2402265F + f * (0.0555041F + f * 0.0096181F)));
    falls[d] = x * (fraction * std::bit_cast<float>(std::uint32_t(whole + 63) << 23));
  }
}

/// Passes water down until no cell whose donors are all done is left.
class MultipleFlow {
 public:
  MultipleFlow(const Grid<float>& filled, const Grid<std::uint8_t>& receiver, Grid<std::uint8_t>& donors, Grid<double>& area)
      : filled_(filled), receiver_(receiver), donors_(donors), area_(area), offsets_(neighbour_offsets(filled.width())) {}

  void run() {
    for (std::size_t cell = 0; cell < donors_.size(); ++cell) {
      if (donors_[cell] == 0) ready_.push_back(std::uint32_t(cell));
      while (!ready_.empty()) {
        const std::uint32_t next = ready_.back();
        ready_.pop_back();
        pass_on(next);
      }
    }
  }

 private:
  void pass_on(std::uint32_t cell) {
    donors_[cell] = passed_on;
    const std::uint8_t direction = receiver_[cell];
    if (direction == leaves_map) return;
    const float here = filled_[cell];
    if (!(filled_[cell + std::size_t(offsets_[direction])] < here)) {
      give(cell + std::size_t(offsets_[direction]), area_[cell]);
      return;
    }
    Shares shares = falls_from(cell);
    raise_to_exponent(shares);
    float sum = 0;
    for (const float share : shares) sum += share;
    const double part = area_[cell] / double(sum);
    for (std::size_t d = 0; d < 8; ++d) {
      if (shares[d] > 0) give(cell + std::size_t(offsets_[d]), part * double(shares[d]));
    }
  }

  [[nodiscard]] Shares falls_from(std::uint32_t cell) const {
    Shares falls{};
    const float here = filled_[cell];
    const int width = filled_.width();
    const int x = int(cell % std::uint32_t(width));
    const int y = int(cell / std::uint32_t(width));
    const bool inside = x > 0 && y > 0 && x < width - 1 && y < filled_.height() - 1;
    for (std::size_t d = 0; d < 8; ++d) {
      if (!inside && !filled_.contains(x + neighbour_dx[d], y + neighbour_dy[d])) continue;
      const float fall = here - filled_[cell + std::size_t(offsets_[d])];
      falls[d] = fall > 0 ? std::max(fall * neighbour_inverse_distance[d], 1e-18F) : 0;
    }
    return falls;
  }

  void give(std::size_t cell, double area) {
    area_[cell] += area;
    if (--donors_[cell] == 0) ready_.push_back(std::uint32_t(cell));
  }

  const Grid<float>& filled_;
  const Grid<std::uint8_t>& receiver_;
  Grid<std::uint8_t>& donors_;
  Grid<double>& area_;
  std::array<std::ptrdiff_t, 8> offsets_;
  std::vector<std::uint32_t> ready_;
};

}  // namespace

Grid<std::uint32_t> upstream_cells(const Grid<std::uint8_t>& receiver) {
  Grid<std::uint8_t> donors = count_donors(receiver);
  Grid<std::uint32_t> cells(receiver.width(), receiver.height(), 1U);
  const auto offsets = neighbour_offsets(receiver.width());
  for (std::size_t start = 0; start < donors.size(); ++start) {
    if (donors[start] != 0) continue;
    std::size_t cell = start;
    donors[cell] = passed_on;
    while (receiver[cell] != leaves_map) {
      const std::size_t next = cell + std::size_t(offsets[receiver[cell]]);
      cells[next] += cells[cell];
      if (--donors[next] != 0) break;
      donors[next] = passed_on;
      cell = next;
    }
  }
  return cells;
}

Grid<float> multiple_flow_area(const Grid<float>& filled, const Grid<std::uint8_t>& receiver, double cell_area,
                               std::span<const Inflow> inflows) {
  Grid<std::uint8_t> donors = count_multiple_donors(filled, receiver);
  // Doubles: a river of 300 km2 must still feel one square metre.
  Grid<double> area(filled.width(), filled.height(), cell_area);
  for (const Inflow& inflow : inflows) area(inflow.x, inflow.y) += inflow.catchment_area;
  MultipleFlow(filled, receiver, donors, area).run();
  Grid<float> result(filled.width(), filled.height());
  parallel_rows(0, filled.height(), [&](int y) {
    const auto from = area.row(y);
    const auto to = result.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) to[x] = float(from[x]);
  });
  return result;
}

}  // namespace biotope
