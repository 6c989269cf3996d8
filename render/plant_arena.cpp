#include "render/plant_arena.hpp"

#include <algorithm>
#include <cmath>

namespace biotope {

namespace {

/// Where there is not room for all blocks, it is looked again which are nearest after so many metres.
constexpr double crowded_step = 32;

/// Order of blocks by their distance from a place, in blocks.
struct Nearer {
  glm::dvec2 at;
  [[nodiscard]] double away(std::pair<int, int> place) const {
    return (place.second - at.x) * (place.second - at.x) + (place.first - at.y) * (place.first - at.y);
  }
  bool operator()(std::pair<int, int> a, std::pair<int, int> b) const { return away(a) < away(b); }
};

}  // namespace

std::optional<std::uint32_t> SlotRuns::take(std::uint32_t count, std::uint32_t most) {
  for (auto run = free_.begin(); run != free_.end(); ++run) {
    if (run->second < count) continue;
    const std::uint32_t first = run->first;
    const std::uint32_t left = run->second - count;
    free_.erase(run);
    if (left > 0) free_.emplace(first + count, left);
    taken_ += count;
    return first;
  }
  if (count > most || end_ > most - count) return std::nullopt;
  const std::uint32_t first = end_;
  end_ += count;
  taken_ += count;
  return first;
}

void SlotRuns::give_back(const Run& run) {
  if (run.count == 0) return;
  taken_ -= run.count;
  auto [place, added] = free_.emplace(run.first, run.count);
  if (const auto next = std::next(place); next != free_.end() && place->first + place->second == next->first) {
    place->second += next->second;
    free_.erase(next);
  }
  if (place != free_.begin()) {
    const auto before = std::prev(place);
    if (before->first + before->second == place->first) {
      before->second += place->second;
      free_.erase(place);
    }
  }
}

void PlantArena::reserve(std::uint32_t plants) {
  if (plants <= room_) return;
  Buffer larger = make_buffer();
  glNamedBufferStorage(larger.name(), GLsizeiptr(plants * sizeof(PlantInstance)), nullptr, GL_DYNAMIC_STORAGE_BIT);
  if (slots_.end() > 0) {
    glCopyNamedBufferSubData(buffer_.name(), larger.name(), 0, 0, GLsizeiptr(slots_.end() * sizeof(PlantInstance)));
  }
  buffer_ = std::move(larger);
  room_ = plants;
}

bool PlantArena::put(const PlantBlock& block, Resident& resident, std::uint32_t most) {
  slots_.give_back(resident.run);
  resident = {{0, 0}, block.version};
  const auto count = std::uint32_t(block.plants.size());
  if (count == 0) return true;
  const auto first = slots_.take(count, most);
  if (!first) return false;
  resident.run = {*first, count};
  glNamedBufferSubData(buffer_.name(), GLintptr(*first * sizeof(PlantInstance)), GLsizeiptr(count * sizeof(PlantInstance)),
                       block.plants.data());
  return true;
}

void PlantArena::evict(Places& places, Places::iterator place) {
  slots_.give_back(place->second.run);
  places.erase(place);
}

PlantArena::Followed PlantArena::followed(const PlantBlocks& blocks, Stratum stratum, std::uint32_t most, glm::dvec2 eye,
                                          bool crowded) const {
  Followed out{blocks.changes(stratum), most, crowded, 0, {0, 0}};
  if (crowded) {
    out.taken = slots_.taken();
    out.eye = glm::ivec2(glm::floor(eye / crowded_step));
  }
  return out;
}

bool PlantArena::follow(const PlantBlocks& blocks, Stratum stratum, std::uint32_t most, glm::dvec2 eye, UploadBudget& budget) {
  reserve(most);
  std::optional<Followed>& last = followed_[std::size_t(stratum)];
  if (last && *last == followed(blocks, stratum, most, eye, last->crowded)) return true;
  last.reset();
  Places& places = places_[std::size_t(stratum)];
  const PlantBlocks::Map& wanted = blocks.blocks(stratum);
  ++changes_[std::size_t(stratum)];
  for (auto place = places.begin(); place != places.end();) {
    const auto here = place++;
    if (!wanted.contains(here->first)) evict(places, here);
  }
  std::vector<std::pair<int, int>> changed;
  for (const auto& [place, block] : wanted) {
    const auto found = places.find(place);
    if (found == places.end() || found->second.version != block.version) changed.push_back(place);
  }
  const glm::dvec2 at = eye / double(PlantPlacement::block_side(stratum)) - 0.5;
  std::sort(changed.begin(), changed.end(), Nearer{at});
  bool crowded = false;
  if (!changed.empty() && !put_all(wanted, stratum, most, at, changed, budget, crowded)) return false;
  last = followed(blocks, stratum, most, eye, crowded);
  return true;
}

bool PlantArena::put_all(const PlantBlocks::Map& blocks, Stratum stratum, std::uint32_t most, glm::dvec2 at,
                         std::span<const std::pair<int, int>> changed, UploadBudget& budget, bool& crowded) {
  Places& places = places_[std::size_t(stratum)];
  const Nearer nearer{at};
  std::vector<std::pair<int, int>> evictable;
  for (const auto& entry : places) evictable.push_back(entry.first);
  std::sort(evictable.begin(), evictable.end(), nearer);
  for (const auto& place : changed) {
    if (budget.spent()) return false;
    Resident resident;
    if (const auto found = places.find(place); found != places.end()) resident = found->second;
    places.erase(place);
    const PlantBlock& block = blocks.at(place);
    bool there = put(block, resident, most);
    // What is farther away makes room.
    while (!there && !evictable.empty() && nearer(place, evictable.back())) {
      if (const auto farthest = places.find(evictable.back()); farthest != places.end()) evict(places, farthest);
      evictable.pop_back();
      there = put(block, resident, most);
    }
    crowded = crowded || !there;
    if (!there) continue;
    places[place] = resident;
    budget.take(block.plants.size() * sizeof(PlantInstance));
  }
  return true;
}

}  // namespace biotope
