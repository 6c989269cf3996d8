#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/status.hpp"
#include "core/base/task_context.hpp"
#include "core/ecosystem/plant_share_choice.hpp"
#include "core/ecosystem/plant_shared_landscape.hpp"

namespace biotope {

/// Paper algorithm 1 over the cells of a landscape, until no wanted plant finds a place; `given(i, place)` hears of every unit.
/// An Error where it was stopped.
template <class Given>
Status give_out(SharedLandscape& landscape, const std::vector<WantedPlant>& wanted, std::span<const double> desired,
                const TaskContext& context, const Given& given) {
  // A look at the stop token every few milliseconds.
  constexpr std::int64_t units_at_once = 1 << 14;
  ShareChoice choice;
  for (const WantedPlant& plant : wanted) choice.add(desired[std::size_t(plant.plant)], plant.unit);
  for (std::int64_t units = 0;; ++units) {
    if (units % units_at_once == 0 && context.stopped()) return fail("Plant competition was stopped.");
    const int next = choice.closest([&](std::size_t i) { return landscape.has_place(i); });
    if (next < 0) return {};
    const SharedLandscape::Place place = landscape.place(std::size_t(next));
    if (place.key == 0) continue;
    choice.give(std::size_t(next));
    given(std::size_t(next), place);
  }
}

}  // namespace biotope
