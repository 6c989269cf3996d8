#include "render/plant_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// Within this distance blocks that changed come before those that were never there, and both are worth a wait, m.
constexpr double changed_first_reach = 320;
/// Blocks that are asked for at a time: few enough to turn soon to what a camera that moved on wants.
constexpr std::size_t most_asked = 96;

/// Blocks are looked for as far as their centres are one side beyond the reach, where 0.71 would do: within this part of a side
/// from there all of them are there too.
constexpr double resting_part = 0.25;

constexpr std::chrono::hours ever{1};

}  // namespace

void PlantBlocks::set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines) {
  follow(std::move(snapshot), std::move(lines));
  static_cast<void>(finish_changes(std::chrono::steady_clock::now() + ever));
}

void PlantBlocks::follow(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines) {
  if (snapshot_ && !plants_stay(*snapshot_, *snapshot)) leave();
  next_.emplace(std::move(snapshot), std::move(lines));
  static_cast<void>(finish_changes(std::chrono::steady_clock::now()));
}

void PlantBlocks::leave() {
  made_elsewhere_.fill(true);
  for (PlantBlockMaker& maker : makers_) maker.stop();
  blocks_ = {};
  for (const Stratum stratum : {Stratum::herb, Stratum::shrub, Stratum::tree}) touched(stratum);
  placement_ = {};
  snapshot_ = nullptr;
}

void PlantBlocks::begin_change(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines) {
  // What came before it may have been of another landscape.
  if (snapshot_ && !plants_stay(*snapshot_, *snapshot)) leave();
  change_ = std::make_shared<Change>();
  change_->snapshot = std::move(snapshot);
  change_->lines = std::move(lines);
  change_->before = placement_.ground();
  for (std::size_t s = 0; s < strata; ++s) {
    for (const auto& entry : blocks_[s]) change_->places[s].push_back(entry.first);
  }
  found_ = thread_.start(
      [change = change_] { change->found = plant_revision(change->before, change->snapshot, change->lines, change->places); });
}

bool PlantBlocks::finish_changes(std::chrono::steady_clock::time_point until) {
  while (change_ || next_) {
    if (change_) {
      if (found_.wait_until(until) != std::future_status::ready) return false;
      found_.get();
      take_over(*change_);
      // It holds what may be the last of an older snapshot.
      thread_.retire(std::exchange(change_, nullptr));
    }
    if (next_) {
      auto [snapshot, lines] = std::move(*next_);
      next_.reset();
      begin_change(std::move(snapshot), std::move(lines));
    }
  }
  return true;
}

void PlantBlocks::take_over(Change& change) {
  for (PlantBlockMaker& maker : makers_) maker.stop();
  made_before_change_.fill(true);
  std::swap(placement_, change.found.placement);
  snapshot_ = change.snapshot;
  for (std::size_t s = 0; s < strata; ++s) {
    // What was made while the change was being found was not looked at.
    std::size_t looked_at = 0;
    const auto& places = change.places[s];
    for (auto& [place, block] : blocks_[s]) {
      while (looked_at < places.size() && places[looked_at] < place) ++looked_at;
      if (looked_at == places.size() || places[looked_at] != place) block.stale = true;
    }
    for (const auto& place : change.found.stale[s]) {
      if (const auto found = blocks_[s].find(place); found != blocks_[s].end()) found->second.stale = true;
    }
    touched(Stratum(s));
  }
}

std::vector<std::pair<int, int>> PlantBlocks::missing(Stratum stratum, double x, double y, float reach) const {
  const Terrain& terrain = snapshot_->terrain();
  const double side = PlantPlacement::block_side(stratum);
  const Map& have = blocks_[std::size_t(stratum)];
  const double looked = double(reach) + resting_part * side;
  const auto range = [&](double centre, double extent) {
    return std::pair(std::max(0, int(std::floor((centre - looked) / side))),
                     std::min(int(std::ceil(extent / side)), int(std::floor((centre + looked) / side)) + 1));
  };
  const auto [x0, x1] = range(x, terrain.width_metres());
  const auto [y0, y1] = range(y, terrain.height_metres());
  std::vector<std::pair<int, int>> out;
  const auto distance = [&](const std::pair<int, int>& place) {
    return std::hypot((place.second + 0.5) * side - x, (place.first + 0.5) * side - y);
  };
  for (int row = y0; row < y1; ++row) {
    for (int column = x0; column < x1; ++column) {
      if (distance({row, column}) > double(reach) + side) continue;
      const auto found = have.find({row, column});
      if (found == have.end() || found->second.stale) out.emplace_back(row, column);
    }
  }
  std::sort(out.begin(), out.end(),
            [&](const auto& a, const auto& b) { return std::pair(distance(a), a) < std::pair(distance(b), b); });
  return out;
}

std::vector<std::pair<int, int>> PlantBlocks::wanted(Stratum stratum, double x, double y, float reach) const {
  std::vector<std::pair<int, int>> places = missing(stratum, x, y, reach);
  const double side = PlantPlacement::block_side(stratum);
  const Map& blocks = blocks_[std::size_t(stratum)];
  std::stable_partition(places.begin(), places.end(), [&](const auto& place) {
    return blocks.contains(place) &&
           std::hypot((place.second + 0.5) * side - x, (place.first + 0.5) * side - y) < changed_first_reach;
  });
  return places;
}

bool PlantBlocks::hurries(Stratum stratum, double x, double y, std::span<const std::pair<int, int>> places) const {
  if (places.empty()) return false;
  const double side = PlantPlacement::block_side(stratum);
  const auto near = [&](const std::pair<int, int>& place) {
    return std::hypot((place.second + 0.5) * side - x, (place.first + 0.5) * side - y) < changed_first_reach;
  };
  return near(places.front());
}

void PlantBlocks::take_made(Stratum stratum, std::chrono::steady_clock::time_point until) {
  const auto s = std::size_t(stratum);
  PlantBlockMaker::Made all = makers_[s].take(until);
  if (all.empty() || made_elsewhere_[s]) return;
  for (auto& [place, made] : all) {
    PlantBlock& block = blocks_[s][place];
    const bool changed_again = made_before_change_[s] && block.stale;
    block = std::move(made);
    block.version = ++versions_;
    block.stale = changed_again;
  }
  touched(stratum);
}

void PlantBlocks::touched(Stratum stratum) {
  const auto s = std::size_t(stratum);
  ++changes_[s];
  held_[s] = 0;
  for (const auto& [place, block] : blocks_[s]) {
    held_[s] += (block.plants.capacity() + block.undergrowth.capacity()) * sizeof(PlantInstance);
  }
}

bool PlantBlocks::rests(Stratum stratum, double x, double y, float reach) const {
  const auto s = std::size_t(stratum);
  const std::optional<Rest>& rest = rest_[s];
  return rest && makers_[s].idle() && rest->changes == changes_[s] && rest->reach == reach &&
         rest->full == (bytes() >= most_bytes_) &&
         std::hypot(x - rest->x, y - rest->y) <= resting_part * PlantPlacement::block_side(stratum);
}

bool PlantBlocks::build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until,
                        bool only_near) {
  const auto s = std::size_t(stratum);
  const bool followed = finish_changes(until);
  whole_to_[s] = snapshot_ ? reach : 0;
  if (!snapshot_) return followed;
  if (rests(stratum, x, y, reach)) {
    note_lacking(stratum, x, y, rest_[s]->left);
    return followed;
  }
  while (true) {
    take_made(stratum, std::chrono::steady_clock::now());
    std::vector<std::pair<int, int>> places = wanted(stratum, x, y, reach);
    const bool hurried = !only_near || hurries(stratum, x, y, places);
    if (hurried && makers_[s].busy()) {
      take_made(stratum, until);
      places = wanted(stratum, x, y, reach);
    }
    const bool full = bytes() >= most_bytes_;
    if (full) makers_[s].stop();
    // Where there is no more room nothing is left to be waited for.
    if (places.empty() || full) {
      note_lacking(stratum, x, y, places);
      rest_[s] = Rest{x, y, reach, changes_[s], full, std::move(places)};
      return followed;
    }
    if (makers_[s].busy()) {
      note_lacking(stratum, x, y, places);
      return false;
    }
    // It may have ended since.
    take_made(stratum, std::chrono::steady_clock::now());
    places = wanted(stratum, x, y, reach);
    places.resize(std::min(places.size(), most_asked));
    drop_far(stratum, x, y, reach);
    made_before_change_[s] = made_elsewhere_[s] = false;
    makers_[s].start(placement_, stratum, std::move(places));
    if (!hurried || std::chrono::steady_clock::now() >= until) {
      note_lacking(stratum, x, y, wanted(stratum, x, y, reach));
      return false;
    }
  }
}

void PlantBlocks::note_lacking(Stratum stratum, double x, double y, std::span<const std::pair<int, int>> left) {
  // Blocks that only changed still have their old plants.
  const Map& blocks = blocks_[std::size_t(stratum)];
  const double side = PlantPlacement::block_side(stratum);
  double away = 1e9;
  for (const auto& place : left) {
    if (blocks.contains(place)) continue;
    away = std::min(away, std::hypot((place.second + 0.5) * side - x, (place.first + 0.5) * side - y));
  }
  float& whole_to = whole_to_[std::size_t(stratum)];
  whole_to = float(std::clamp(away - side, 0.0, double(whole_to)));
}

void PlantBlocks::fill_all(Stratum stratum, std::span<const std::pair<int, int>> places) {
  std::vector<PlantBlock*> blocks;
  blocks.reserve(places.size());
  for (const auto& place : places) blocks.push_back(&blocks_[std::size_t(stratum)][place]);
  parallel_each(places.size(), [&](std::size_t i) {
    *blocks[i] = made_block(placement_, stratum, places[i]);
    blocks[i]->version = versions_ + 1 + std::uint32_t(i);
  });
  versions_ += std::uint32_t(places.size());
  touched(stratum);
}

void PlantBlocks::build_all(Stratum stratum, double x, double y, float reach) {
  static_cast<void>(finish_changes(std::chrono::steady_clock::now() + ever));
  if (!snapshot_) return;
  makers_[std::size_t(stratum)].stop();
  take_made(stratum, std::chrono::steady_clock::now() + ever);
  const auto places = missing(stratum, x, y, reach);
  whole_to_[std::size_t(stratum)] = reach;
  drop_far(stratum, x, y, reach);
  constexpr std::size_t at_once = 256;
  for (std::size_t first = 0; first < places.size(); first += at_once) {
    const auto rest = std::span(places).subspan(first);
    if (bytes() >= most_bytes_) return note_lacking(stratum, x, y, rest);
    fill_all(stratum, rest.first(std::min(at_once, rest.size())));
  }
}

void PlantBlocks::drop_far(Stratum stratum, double x, double y, float reach) {
  const double side = PlantPlacement::block_side(stratum);
  const auto drop_beyond = [&](double farthest) {
    const std::size_t dropped = std::erase_if(blocks_[std::size_t(stratum)], [&](const auto& entry) {
      const auto [row, column] = entry.first;
      return std::hypot((column + 0.5) * side - x, (row + 0.5) * side - y) > farthest;
    });
    if (dropped > 0) touched(stratum);
  };
  drop_beyond(1.6 * double(reach) + 2 * side);
  // What one may soon come back to is kept only as long as there is room.
  if (bytes() >= most_bytes_) drop_beyond(double(reach) + side);
}

std::size_t PlantBlocks::bytes() const { return held_[0] + held_[1] + held_[2]; }

}  // namespace biotope
