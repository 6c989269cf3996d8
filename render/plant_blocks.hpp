#pragma once

#include <array>
#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/background_thread.hpp"
#include "render/plant_block_maker.hpp"
#include "render/plant_revision.hpp"

namespace biotope {

/// The blocks of plants that a camera needs, built when they are first asked for and again when a map under them has changed. A
/// block that waits for its turn keeps its old plants. Blocks are made on other threads.
class PlantBlocks {
 public:
  /// `lines` is the water and the trails that are drawn with the snapshot; null: plants keep away from the cells of water only.
  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines = nullptr);
  /// The same for who must not wait: another thread finds what changed, and until a later build() takes that over all is as it
  /// was before. Of what is given meanwhile only the newest counts.
  void follow(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines);
  /// Gives up all blocks: nothing of another landscape is good in the next.
  void leave();
  /// True while blocks are not yet known to be those of the newest snapshot.
  [[nodiscard]] bool following() const { return change_ != nullptr; }

  /// Has blocks of a stratum built that lie within `reach` metres of (x, y): those near (x, y) whose plants an edit has changed
  /// first, then nearest first. Waits for them until `until` (with `only_near` not for what comes into sight far ahead); what is
  /// not there by then comes with a later call. Returns false when some are left.
  bool build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until,
             bool only_near = false);
  /// Builds all of them, on all threads.
  void build_all(Stratum stratum, double x, double y, float reach);

  /// Blocks of a stratum by (row, column) that were built at least once.
  using Map = std::map<std::pair<int, int>, PlantBlock>;
  [[nodiscard]] const Map& blocks(Stratum stratum) const { return blocks_[std::size_t(stratum)]; }
  /// Metres from the eye of the last build within which every block of a stratum was built at least once.
  [[nodiscard]] float whole_to(Stratum stratum) const { return whole_to_[std::size_t(stratum)]; }
  /// Another number whenever a stratum's blocks are others: new, made anew, to be made anew, or gone.
  [[nodiscard]] std::uint64_t changes(Stratum stratum) const { return changes_[std::size_t(stratum)]; }
  [[nodiscard]] std::size_t bytes() const;
  /// Memory that blocks may take: beyond it far ones are given up, and no more are built.
  void set_most_bytes(std::size_t bytes) { most_bytes_ = bytes; }
  [[nodiscard]] std::size_t most_bytes() const { return most_bytes_; }
  /// Where the plants of the snapshot stand.
  [[nodiscard]] const PlantPlacement& placement() const { return placement_; }

 private:
  [[nodiscard]] std::vector<std::pair<int, int>> missing(Stratum stratum, double x, double y, float reach) const;
  /// What is missing in the order in which it is wanted.
  [[nodiscard]] std::vector<std::pair<int, int>> wanted(Stratum stratum, double x, double y, float reach) const;
  /// Whether the first of those that are wanted are so near that a frame waits for them.
  [[nodiscard]] bool hurries(Stratum stratum, double x, double y, std::span<const std::pair<int, int>> places) const;
  /// Takes what was made until a time. Of blocks that were begun before the maps changed again the next ones are wanted too.
  void take_made(Stratum stratum, std::chrono::steady_clock::time_point until);
  /// Builds blocks on all threads.
  void fill_all(Stratum stratum, std::span<const std::pair<int, int>> places);
  /// A newer snapshot, and what another thread finds in it.
  struct Change {
    std::shared_ptr<const MapsSnapshot> snapshot;
    std::shared_ptr<const GroundLines> lines;
    PlantGround before;
    PlantBlockPlaces places;
    PlantRevision found;
  };
  void begin_change(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines);
  /// Takes over what was found by then, and goes on to what came meanwhile; false while something is left to be found.
  bool finish_changes(std::chrono::steady_clock::time_point until);
  void take_over(Change& change);
  void drop_far(Stratum stratum, double x, double y, float reach);
  /// Sets how far all blocks are there, where the first that lacks is one of these, nearest first.
  void note_lacking(Stratum stratum, double x, double y, std::span<const std::pair<int, int>> left);
  /// To be called after every change of a stratum's blocks.
  void touched(Stratum stratum);
  /// A look at what is missing after which nothing is to be done: from near there it need not be looked at again.
  struct Rest {
    double x = 0;
    double y = 0;
    float reach = 0;
    std::uint64_t changes = 0;
    bool full = false;
    /// What there is no room for.
    std::vector<std::pair<int, int>> left;
  };
  [[nodiscard]] bool rests(Stratum stratum, double x, double y, float reach) const;

  PlantPlacement placement_;
  /// Null before the first one, and until plants of another landscape are known.
  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::array<Map, strata> blocks_;
  std::array<std::uint64_t, strata> changes_{};
  std::array<std::size_t, strata> held_{};
  std::array<std::optional<Rest>, strata> rest_;
  std::uint32_t versions_ = 0;
  std::size_t most_bytes_ = std::size_t(256) << 20U;
  std::array<float, strata> whole_to_{};
  std::array<PlantBlockMaker, strata> makers_;
  /// Whether the maps changed since a maker began; and whether what it makes is for another landscape.
  std::array<bool, strata> made_before_change_{};
  std::array<bool, strata> made_elsewhere_{};
  std::shared_ptr<Change> change_;
  std::future<void> found_;
  /// What came while a change was being found: a snapshot and its lines.
  std::optional<std::pair<std::shared_ptr<const MapsSnapshot>, std::shared_ptr<const GroundLines>>> next_;
  BackgroundThread thread_;
};

}  // namespace biotope
