#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/base/background_thread.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

/// Plants of one block, kept until the maps under it change.
struct PlantBlock {
  /// By rising rank: the first few stand for all where fewer are shown.
  std::vector<PlantInstance> plants;
  /// Of a block of herbs: what lies and grows beside them.
  std::vector<PlantInstance> undergrowth;
  /// Another number whenever the plants are made anew.
  std::uint32_t version = 0;
  /// Lowest and highest foot, m.
  float low = 0;
  float high = 0;
  bool stale = true;
};

/// The plants of a block, as the placement has them; version 0.
[[nodiscard]] PlantBlock made_block(const PlantPlacement& placement, Stratum stratum, std::pair<int, int> place);

/// Makes blocks of one stratum on other threads, in the order in which they are asked for, so that whoever draws never waits
/// longer than it wants to.
class PlantBlockMaker {
 public:
  using Made = std::vector<std::pair<std::pair<int, int>, PlantBlock>>;

  PlantBlockMaker() = default;
  PlantBlockMaker(const PlantBlockMaker&) = delete;
  PlantBlockMaker& operator=(const PlantBlockMaker&) = delete;
  ~PlantBlockMaker() { stop(); }

  /// Starts on a list of (row, column), in place of what it was asked for before; must not be busy.
  void start(PlantPlacement placement, Stratum stratum, std::vector<std::pair<int, int>> places);
  /// Asks it to end after the blocks it is at. What is made can still be taken.
  void stop();
  /// Whether it neither works nor has made anything that can be taken.
  [[nodiscard]] bool idle() const { return work_ == nullptr; }
  /// Whether it still works.
  [[nodiscard]] bool busy() const;
  /// Waits until it has ended or it is `until`, and takes what was made since the last call.
  [[nodiscard]] Made take(std::chrono::steady_clock::time_point until);

 private:
  /// Shared with the working thread.
  struct Work {
    PlantPlacement placement;
    Stratum stratum = Stratum::herb;
    std::vector<std::pair<int, int>> places;
    std::atomic<bool> stopped = false;
    std::mutex mutex;
    Made made;
  };
  static void run(Work& work);
  /// Has what was worked on freed, which may hold the maps of an older snapshot.
  void forget();

  std::shared_ptr<Work> work_;
  std::future<void> ended_;
  BackgroundThread thread_;
};

}  // namespace biotope
