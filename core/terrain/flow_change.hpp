#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <queue>
#include <vector>

#include "core/base/grid.hpp"
#include "core/base/tiled_map.hpp"
#include "core/terrain/neighbours.hpp"
#include "core/terrain/ordered_bits.hpp"

namespace biotope {

/// Carries changes of what flows through cells downstream, each cell after all that give to it. Amounts are integers, so that
/// sums do not depend on the order in which they are made and a change can be taken back exactly.
template <class Amount>
class FlowChange {
 public:
  using Gives = std::array<Amount, 8>;

  /// The ground of now and the directions on it.
  FlowChange(const Grid<float>& filled, const Grid<std::uint8_t>& receiver)
      : filled_(filled),
        receiver_(receiver),
        offsets_(neighbour_offsets(filled.width())),
        columns_((filled.width() + tile_side - 1) / tile_side),
        tiles_(std::size_t(columns_) * std::size_t((filled.height() + tile_side - 1) / tile_side)) {}

  /// What a cell gives to others follows another rule now.
  void redirect(std::uint32_t cell) {
    Slot slot = slot_of(cell);
    if ((slot.state & redirected) != 0) return;
    slot.state |= redirected;
    redirected_.push_back(cell);
    queue(cell, slot);
  }
  /// More (or less) flows into a cell from outside.
  void add(std::uint32_t cell, Amount amount) {
    Slot slot = slot_of(cell);
    slot.change += amount;
    queue(cell, slot);
  }

  /// `before(cell, amount)` and `after(cell, amount)` say what a cell gives to its neighbours by the old and the new rules;
  /// called for cells whose `amounts` (of before, then of now) change. `seen(cell)` is told each of those.
  template <class Before, class After, class Seen>
  void run(Grid<Amount>& amounts, const Before& before, const After& after, const Seen& seen) {
    // What was given by the old rules is taken back first: then nothing comes to a cell that was passed already.
    for (const std::uint32_t cell : redirected_) give(cell, {}, before(cell, amounts[cell]));
    redirected_.clear();
    while (!heap_.empty()) {
      const std::uint32_t cell = heap_.top().cell;
      heap_.pop();
      Slot slot = slot_of(cell);
      const bool other_rule = (slot.state & redirected) != 0;
      slot.state = 0;
      if (slot.change == 0 && !other_rule) continue;
      const Amount old_amount = amounts[cell];
      amounts[cell] = Amount(old_amount + slot.change);
      slot.change = 0;
      seen(cell);
      give(cell, after(cell, amounts[cell]), other_rule ? Gives{} : after(cell, old_amount));
    }
  }

 private:
  static constexpr std::uint8_t queued = 1;
  static constexpr std::uint8_t redirected = 2;
  static constexpr std::size_t tile_cells = std::size_t(tile_side) * tile_side;
  struct Tile {
    std::array<Amount, tile_cells> change{};
    std::array<std::uint8_t, tile_cells> state{};
    /// Steps across flat ground to where it falls, and one; 0 where nobody asked.
    std::array<std::uint32_t, tile_cells> steps{};
  };
  struct Slot {
    Amount& change;
    std::uint8_t& state;
    std::uint32_t& steps;
  };
  /// Higher ground first, and on flats what is farther from their outlets.
  struct Entry {
    std::uint64_t order;
    std::uint32_t cell;
    bool operator>(const Entry& other) const { return order > other.order; }
  };

  Slot slot_of(std::uint32_t cell) {
    const int x = int(cell % std::uint32_t(filled_.width()));
    const int y = int(cell / std::uint32_t(filled_.width()));
    auto& tile = tiles_[std::size_t(y / tile_side) * std::size_t(columns_) + std::size_t(x / tile_side)];
    if (!tile) tile = std::make_unique<Tile>();
    const std::size_t at = std::size_t(y % tile_side) * tile_side + std::size_t(x % tile_side);
    return {tile->change[at], tile->state[at], tile->steps[at]};
  }
  void queue(std::uint32_t cell, Slot slot) {
    if ((slot.state & queued) != 0) return;
    slot.state |= queued;
    heap_.push({std::uint64_t(~ordered_bits(filled_[cell])) << 32 | std::uint32_t(~steps_from(cell)), cell});
  }
  void give(std::uint32_t cell, const Gives& more, const Gives& less) {
    for (std::size_t d = 0; d < 8; ++d) {
      if (more[d] != less[d]) add(std::uint32_t(std::ptrdiff_t(cell) + offsets_[d]), Amount(more[d] - less[d]));
    }
  }
  [[nodiscard]] bool falls(std::uint32_t cell) const {
    return receiver_[cell] == leaves_map ||
           filled_[std::size_t(std::ptrdiff_t(cell) + offsets_[receiver_[cell]])] < filled_[cell];
  }
  std::uint32_t steps_from(std::uint32_t cell) {
    way_.clear();
    while (slot_of(cell).steps == 0 && !falls(cell)) {
      way_.push_back(cell);
      cell = std::uint32_t(std::ptrdiff_t(cell) + offsets_[receiver_[cell]]);
    }
    std::uint32_t steps = std::max(slot_of(cell).steps, std::uint32_t(1));
    slot_of(cell).steps = steps;
    for (auto up = way_.rbegin(); up != way_.rend(); ++up) slot_of(*up).steps = ++steps;
    return steps;
  }

  const Grid<float>& filled_;
  const Grid<std::uint8_t>& receiver_;
  std::array<std::ptrdiff_t, 8> offsets_;
  int columns_;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::vector<std::uint32_t> redirected_;
  std::vector<std::uint32_t> way_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
};

}  // namespace biotope
