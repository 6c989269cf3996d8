#include "render/plant_block_maker.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// Blocks that are made side by side before they can be taken.
constexpr std::size_t blocks_at_once = 8;

}  // namespace

PlantBlock made_block(const PlantPlacement& placement, Stratum stratum, std::pair<int, int> place) {
  PlantBlock block;
  block.plants = placement.block(stratum, place.second, place.first);
  if (stratum == Stratum::herb) block.undergrowth = placement.undergrowth(place.second, place.first);
  block.stale = false;
  block.low = 1e9F;
  block.high = -1e9F;
  for (const auto* list : {&block.plants, &block.undergrowth}) {
    for (const PlantInstance& plant : *list) {
      block.low = std::min(block.low, plant.z);
      block.high = std::max(block.high, plant.z);
    }
  }
  return block;
}

void PlantBlockMaker::start(PlantPlacement placement, Stratum stratum, std::vector<std::pair<int, int>> places) {
  assert(!busy());
  forget();
  work_ = std::make_shared<Work>();
  work_->placement = std::move(placement);
  work_->stratum = stratum;
  work_->places = std::move(places);
  ended_ = thread_.start([work = work_] { run(*work); });
}

void PlantBlockMaker::stop() {
  if (work_) work_->stopped = true;
}

bool PlantBlockMaker::busy() const {
  return ended_.valid() && ended_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

PlantBlockMaker::Made PlantBlockMaker::take(std::chrono::steady_clock::time_point until) {
  if (!work_) return {};
  if (ended_.valid()) ended_.wait_until(until);
  const bool ended = !busy();
  Made made;
  {
    const std::lock_guard lock(work_->mutex);
    made = std::exchange(work_->made, {});
  }
  if (ended) forget();
  return made;
}

void PlantBlockMaker::forget() {
  if (work_) thread_.retire(std::exchange(work_, nullptr));
}

void PlantBlockMaker::run(Work& work) {
  for (std::size_t first = 0; first < work.places.size() && !work.stopped; first += blocks_at_once) {
    Made made(std::min(blocks_at_once, work.places.size() - first));
    parallel_each(made.size(), [&](std::size_t i) {
      const auto place = work.places[first + i];
      made[i] = {place, made_block(work.placement, work.stratum, place)};
    });
    const std::lock_guard lock(work.mutex);
    std::move(made.begin(), made.end(), std::back_inserter(work.made));
  }
}

}  // namespace biotope
