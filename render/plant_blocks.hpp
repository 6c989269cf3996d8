#pragma once

#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "render/ground_picture.hpp"
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

/// The blocks of plants that a camera needs, built when they are first asked for and again when a map under them has changed. A
/// block that waits for its turn keeps its old plants.
class PlantBlocks {
 public:
  /// `lines` is the water and the trails that are drawn with the snapshot; null: plants keep away from the cells of water only.
  void set_snapshot(std::shared_ptr<const MapsSnapshot> snapshot, std::shared_ptr<const GroundLines> lines = nullptr);

  /// Builds blocks of a stratum that lie within `reach` metres of (x, y), nearest first, until `until`. Those near (x, y) whose
  /// plants an edit has changed come before all others, and may take until `changed_until`. Returns false when some are left.
  bool build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until,
             std::chrono::steady_clock::time_point changed_until);
  bool build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until) {
    return build(stratum, x, y, reach, until, until);
  }
  /// Builds all of them, on all threads.
  void build_all(Stratum stratum, double x, double y, float reach);

  /// Blocks of a stratum by (row, column) that were built at least once.
  using Map = std::map<std::pair<int, int>, PlantBlock>;
  [[nodiscard]] const Map& blocks(Stratum stratum) const { return blocks_[std::size_t(stratum)]; }
  /// Metres from the eye of the last build within which every block of a stratum was built at least once.
  [[nodiscard]] float whole_to(Stratum stratum) const { return whole_to_[std::size_t(stratum)]; }
  [[nodiscard]] std::size_t bytes() const;
  /// Memory that blocks may take: beyond it far ones are given up, and no more are built.
  void set_most_bytes(std::size_t bytes) { most_bytes_ = bytes; }
  [[nodiscard]] std::size_t most_bytes() const { return most_bytes_; }
  /// Where the plants of the snapshot stand.
  [[nodiscard]] const PlantPlacement& placement() const { return placement_; }

 private:
  [[nodiscard]] std::vector<std::pair<int, int>> missing(Stratum stratum, double x, double y, float reach) const;
  void fill(Stratum stratum, std::pair<int, int> place, PlantBlock& block, std::uint32_t version) const;
  /// Builds blocks on all threads.
  void fill_all(Stratum stratum, std::span<const std::pair<int, int>> places);
  /// Makes the blocks stale on whose ground something is another than it was.
  void mark_changed(const PlantGround& before);
  /// What is eaten of a snapshot; of one whose animals are not known yet, what was eaten before it.
  [[nodiscard]] std::shared_ptr<const Grazing> grazing_of(const MapsSnapshot& snapshot) const;
  void drop_far(Stratum stratum, double x, double y, float reach);
  /// Sets how far all blocks are there, where the first that lacks is one of these, nearest first.
  void note_lacking(Stratum stratum, double x, double y, std::span<const std::pair<int, int>> left);

  PlantPlacement placement_;
  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::array<Map, strata> blocks_;
  std::uint32_t versions_ = 0;
  std::size_t most_bytes_ = std::size_t(256) << 20U;
  std::array<float, strata> whole_to_{};
};

}  // namespace biotope
