#pragma once

#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "render/ground_picture.hpp"
#include "render/plant_placement.hpp"

namespace biotope {

/// Plants of one block, kept until the maps under it change.
struct PlantBlock {
  std::vector<PlantInstance> plants;
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

  /// Builds blocks of a stratum that lie within `reach` metres of (x, y), nearest first, until `until`. Returns false when some
  /// are left.
  bool build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until);
  /// Builds all of them, on all threads.
  void build_all(Stratum stratum, double x, double y, float reach);

  /// Blocks of a stratum by (row, column) that were built at least once.
  using Map = std::map<std::pair<int, int>, PlantBlock>;
  [[nodiscard]] const Map& blocks(Stratum stratum) const { return blocks_[std::size_t(stratum)]; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::vector<std::pair<int, int>> missing(Stratum stratum, double x, double y, float reach) const;
  void fill(Stratum stratum, std::pair<int, int> place, PlantBlock& block) const;
  void mark_changed(const MapsSnapshot& before, const GroundLines* lines_before);
  /// Makes the blocks stale that meet a tile of the terrain that is marked.
  void mark(const Grid<std::uint8_t>& tiles);
  void drop_far(Stratum stratum, double x, double y, float reach);

  PlantPlacement placement_;
  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::shared_ptr<const GroundLines> lines_;
  std::array<Map, strata> blocks_;
};

}  // namespace biotope
