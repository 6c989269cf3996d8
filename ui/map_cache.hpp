#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/last_owner.hpp"
#include "ui/map_builder.hpp"

namespace biotope {

/// Makes the maps that are looked at, on a thread of its own, and keeps the latest few. The newest request wins.
class MapCache {
 public:
  MapCache();
  ~MapCache();
  MapCache(const MapCache&) = delete;
  MapCache& operator=(const MapCache&) = delete;

  struct Answer {
    /// The map as it was last made, perhaps of an older snapshot; null cells when never.
    MapValues values;
    /// True when it answers the snapshot that was asked about.
    bool current = false;
  };
  /// What is known of a map now; starts making it when it is not of this snapshot. Never waits.
  [[nodiscard]] Answer request(const std::shared_ptr<const MapsSnapshot>& snapshot, const MapId& id);
  /// A value of a map that has been made; nothing when it has not, or outside of it.
  [[nodiscard]] std::optional<float> value(const MapId& id, int x, int y) const;
  /// True while a map is being made.
  [[nodiscard]] bool busy() const;
  /// Forgets everything (another landscape was opened).
  void clear();
  /// Blocks until nothing is being made. For tests.
  void wait_idle();

 private:
  struct Entry {
    std::shared_ptr<const MapsSnapshot> snapshot;  // keeps `source` from being reused by another object
    const void* source = nullptr;
    MapId id;
    MapValues values;
  };
  struct Wanted {
    std::shared_ptr<const MapsSnapshot> snapshot;
    MapId id;
  };
  /// Between looks at maps that are no longer kept and still shown.
  static constexpr std::chrono::milliseconds sweep_every{200};
  void work(const std::stop_token& stop);
  /// Makes what is wanted; gives the lock back meanwhile.
  void make(std::unique_lock<std::mutex>& lock);
  /// Gives up an entry: its map is freed by this cache's thread when nobody shows it any more.
  void drop(Entry& entry);

  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Entry> entries_;  // the newest first
  std::optional<Wanted> wanted_;
  LastOwner old_;
  bool working_ = false;
  std::uint64_t generation_ = 0;
  std::jthread thread_;
};

}  // namespace biotope
