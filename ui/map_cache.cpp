#include "ui/map_cache.hpp"

#include <algorithm>

namespace biotope {
namespace {
constexpr std::size_t most_entries = 5;
}

MapCache::MapCache() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

MapCache::~MapCache() {
  thread_.request_stop();
  wake_.notify_all();
}

MapCache::Answer MapCache::request(const std::shared_ptr<const MapsSnapshot>& snapshot, const MapId& id) {
  if (!snapshot || id.kind == MapKind::none) return {};
  const void* source = source_of(*snapshot, id);
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.id == id; });
  Answer answer;
  if (found != entries_.end()) {
    answer.values = found->values;
    answer.current = found->source == source;
    std::rotate(entries_.begin(), found, found + 1);
  }
  if (!answer.current && source != nullptr) {
    wanted_ = Wanted{snapshot, id};
    wake_.notify_all();
  }
  return answer;
}

std::optional<float> MapCache::value(const MapId& id, int x, int y) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.id == id; });
  if (found == entries_.end() || !found->values.cells || !found->values.cells->contains(x, y)) return std::nullopt;
  return (*found->values.cells)(x, y);
}

bool MapCache::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || wanted_.has_value();
}

void MapCache::clear() {
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_) drop(entry);
  entries_.clear();
  wanted_.reset();
  ++generation_;
  wake_.notify_all();
}

void MapCache::wait_idle() {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [&] { return !working_ && !wanted_; });
}

void MapCache::drop(Entry& entry) {
  old_.keep(std::move(entry.values.cells));
  old_.keep(std::move(entry.snapshot));
}

void MapCache::make(std::unique_lock<std::mutex>& lock) {
  Wanted wanted = std::move(*wanted_);
  wanted_.reset();
  working_ = true;
  const std::uint64_t generation = generation_;
  lock.unlock();
  MapValues values = build_map(*wanted.snapshot, wanted.id);
  lock.lock();
  working_ = false;
  if (generation == generation_) {
    std::erase_if(entries_, [&](Entry& entry) {
      if (entry.id == wanted.id) drop(entry);
      return entry.id == wanted.id;
    });
    const void* source = source_of(*wanted.snapshot, wanted.id);
    entries_.push_front({std::move(wanted.snapshot), source, wanted.id, std::move(values)});
    if (entries_.size() > most_entries) {
      drop(entries_.back());
      entries_.pop_back();
    }
  }
  wake_.notify_all();
}

void MapCache::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const auto asked = [&] { return wanted_.has_value(); };
    if (old_.empty()) {
      wake_.wait(lock, stop, [&] { return asked() || !old_.empty(); });
    } else {
      wake_.wait_for(lock, stop, sweep_every, asked);
    }
    if (stop.stop_requested()) return;
    if (wanted_) make(lock);
    std::vector<std::shared_ptr<const void>> unused = old_.take_unused();
    lock.unlock();
    unused.clear();
    lock.lock();
  }
}

}  // namespace biotope
