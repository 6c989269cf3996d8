#include <algorithm>

#include "core/movement/herd_simulation_slot.hpp"

namespace biotope {

namespace {

/// Herds whose casts are kept beyond those of the last call.
constexpr std::size_t most_casts = 400;

}  // namespace

std::size_t HerdSimulation::bytes() const {
  std::size_t sum = 0;
  for (const auto& slot : slots_) {
    if (!slot) continue;
    for (const auto& [number, run] : slot->runs) sum += run->bytes();
  }
  return sum;
}

void HerdSimulation::forget_old() {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i]) kept.push_back(i);
  }
  std::stable_sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) { return slots_[a]->used < slots_[b]->used; });
  std::size_t held = bytes();
  std::size_t casts = kept.size();
  for (const std::size_t i : kept) {
    // A picture may take several calls: those of the last ones count as in use.
    if (slots_[i]->used + 2 >= uses_) {
      // Of those in use only the runs of the moment stay.
      auto& runs = slots_[i]->runs;
      for (auto run = runs.begin(); held > most_bytes && run != runs.end();) {
        const bool of_the_moment =
            run->first == slots_[i]->checkpoint || (run->first + 1) % checkpoints_per_day == slots_[i]->checkpoint;
        if (!of_the_moment) held -= run->second->bytes();
        run = of_the_moment ? std::next(run) : runs.erase(run);
      }
      continue;
    }
    if (held <= most_bytes && casts <= most_casts) continue;
    for (const auto& [number, run] : slots_[i]->runs) held -= run->bytes();
    slots_[i].reset();
    --casts;
  }
}

}  // namespace biotope
