#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/terrain/flow_change.hpp"
#include "core/terrain/flow_routing.hpp"
#include "core/terrain/flow_updates.hpp"
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

using Units = CatchmentField::Units;
using Gives = std::array<Units, 8>;

/// How water leaves cells of a filled ground.
class Outflow {
 public:
  Outflow(const Grid<float>& filled, const Grid<std::uint8_t>& receiver)
      : filled_(filled), receiver_(receiver), offsets_(neighbour_offsets(filled.width())) {}

  [[nodiscard]] const std::array<std::ptrdiff_t, 8>& offsets() const { return offsets_; }

  /// What each neighbour gets of a cell's water; calls to(d) for those that get a share, however small.
  template <class To>
  Gives gives(std::uint32_t cell, Units water, const To& to) const {
    Gives out{};
    const std::uint8_t direction = receiver_[cell];
    if (direction == leaves_map) return out;
    if (!(filled_[cell + std::size_t(offsets_[direction])] < filled_[cell])) {
      out[direction] = water;
      to(direction);
      return out;
    }
    Shares shares = falls_from(cell);
    raise_to_exponent(shares);
    float sum = 0;
    for (const float share : shares) sum += share;
    const double part = double(water) / double(sum);
    Units rest = water;
    for (std::size_t d = 0; d < 8; ++d) {
      if (!(shares[d] > 0)) continue;
      out[d] = Units(part * double(shares[d]));
      rest -= out[d];
      to(d);
    }
    out[direction] += rest;  // no water is lost to rounding
    return out;
  }

 private:
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

  const Grid<float>& filled_;
  const Grid<std::uint8_t>& receiver_;
  std::array<std::ptrdiff_t, 8> offsets_;
};

/// Passes water down until no cell whose donors are all done is left.
class MultipleFlow {
 public:
  MultipleFlow(const Outflow& outflow, Grid<std::uint8_t>& donors, Grid<Units>& water)
      : outflow_(outflow), donors_(donors), water_(water) {}

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
    std::array<std::size_t, 8> to{};
    std::size_t count = 0;
    const Gives gives = outflow_.gives(cell, water_[cell], [&](std::size_t d) { to[count++] = d; });
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t below = cell + std::size_t(outflow_.offsets()[to[i]]);
      water_[below] += gives[to[i]];
      if (--donors_[below] == 0) ready_.push_back(std::uint32_t(below));
    }
  }

  const Outflow& outflow_;
  Grid<std::uint8_t>& donors_;
  Grid<Units>& water_;
  std::vector<std::uint32_t> ready_;
};

/// Parts of a cell's area that water is counted in: at most 2^16, fewer where a great river would overflow.
double unit_of(std::size_t cells, double cell_area, std::span<const Inflow> inflows) {
  double total = double(cells) * cell_area;
  for (const Inflow& inflow : inflows) total += inflow.catchment_area;
  const int bits = std::ilogb(total / cell_area) + 1;
  return std::ldexp(cell_area, -std::min(16, 61 - bits));
}

Units units_of(const Inflow& inflow, double unit) { return Units(std::llround(inflow.catchment_area / unit)); }

}  // namespace

Grid<float> CatchmentField::restart(const Grid<float>& filled, const Grid<std::uint8_t>& receiver, double cell_area,
                                    std::span<const Inflow> inflows) {
  unit_ = unit_of(filled.size(), cell_area, inflows);
  inflows_.assign(inflows.begin(), inflows.end());
  Grid<std::uint8_t> donors = count_multiple_donors(filled, receiver);
  water_ = Grid<Units>(filled.width(), filled.height(), Units(std::llround(cell_area / unit_)));
  for (const Inflow& inflow : inflows) water_(inflow.x, inflow.y) += units_of(inflow, unit_);
  MultipleFlow(Outflow(filled, receiver), donors, water_).run();
  auto area = Grid<float>::shareable(filled.width(), filled.height());
  parallel_rows(0, filled.height(), [&](int y) {
    const auto from = water_.row(y);
    const auto to = area.row(y);
    for (std::size_t x = 0; x < to.size(); ++x) to[x] = area_of(from[x]);
  });
  return area;
}

bool CatchmentField::can_follow(double cell_area, std::span<const Inflow> inflows) const {
  return !water_.empty() && unit_ == unit_of(water_.size(), cell_area, inflows);
}

TileSet CatchmentField::update(const FlowGround& before, const FlowGround& after, const TileSet& moved,
                               std::span<const Inflow> inflows, Grid<float>& area) {
  const Grid<float>& filled = after.filled;
  FlowChange<Units> change(filled, after.receiver);
  const std::vector<std::size_t> list = moved.list();
  for (const std::size_t tile : list) {
    const Rect cells = moved.rect(tile);
    for (int y = cells.y0; y < cells.y1; ++y) {
      for (int x = cells.x0; x < cells.x1; ++x) {
        const bool raised = filled(x, y) != before.filled(x, y);
        if (!raised && after.receiver(x, y) == before.receiver(x, y)) continue;
        const Rect around = raised ? intersection(grown({x, y, x + 1, y + 1}, 1), filled.rect()) : Rect{x, y, x + 1, y + 1};
        for (int ny = around.y0; ny < around.y1; ++ny) {
          for (int nx = around.x0; nx < around.x1; ++nx) change.redirect(std::uint32_t(filled.index(nx, ny)));
        }
      }
    }
  }
  for (const Inflow& inflow : inflows_) change.add(std::uint32_t(filled.index(inflow.x, inflow.y)), -units_of(inflow, unit_));
  for (const Inflow& inflow : inflows) change.add(std::uint32_t(filled.index(inflow.x, inflow.y)), units_of(inflow, unit_));
  inflows_.assign(inflows.begin(), inflows.end());
  const Outflow old_rule(before.filled, before.receiver);
  const Outflow new_rule(after.filled, after.receiver);
  const auto nobody = [](std::size_t) {};
  TileSet changed(filled.width(), filled.height());
  change.run(
      water_, [&](std::uint32_t cell, Units water) { return old_rule.gives(cell, water, nobody); },
      [&](std::uint32_t cell, Units water) { return new_rule.gives(cell, water, nobody); },
      [&](std::uint32_t cell) {
        const float now = area_of(water_[cell]);
        if (area[cell] == now) return;
        area[cell] = now;
        changed.insert_cell(cell);
      });
  return changed;
}

std::vector<std::uint32_t> update_upstream_cells(const FlowGround& before, const FlowGround& after, const TileSet& moved,
                                                 Grid<std::uint32_t>& cells) {
  using Count = std::uint32_t;
  FlowChange<Count> change(after.filled, after.receiver);
  for (const std::size_t tile : moved.list()) {
    const Rect rect = moved.rect(tile);
    for (int y = rect.y0; y < rect.y1; ++y) {
      for (int x = rect.x0; x < rect.x1; ++x) {
        if (after.receiver(x, y) != before.receiver(x, y)) change.redirect(std::uint32_t(cells.index(x, y)));
      }
    }
  }
  std::vector<std::uint32_t> seen;
  const auto gives = [](const Grid<std::uint8_t>& receiver, std::uint32_t cell, Count count) {
    FlowChange<Count>::Gives to{};
    if (receiver[cell] != leaves_map) to[receiver[cell]] = count;
    return to;
  };
  change.run(
      cells, [&](std::uint32_t cell, Count count) { return gives(before.receiver, cell, count); },
      [&](std::uint32_t cell, Count count) { return gives(after.receiver, cell, count); },
      [&](std::uint32_t cell) { seen.push_back(cell); });
  return seen;
}

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
  return CatchmentField().restart(filled, receiver, cell_area, inflows);
}

}  // namespace biotope
