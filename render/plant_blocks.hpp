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

  /// Builds blocks of a stratum that lie within `reach` metres of (x, y), nearest first, until `until`. Returns false when some
  /// are left.
  bool build(Stratum stratum, double x, double y, float reach, std::chrono::steady_clock::time_point until);
  /// Builds all of them, on all threads.
  void build_all(Stratum stratum, double x, double y, float reach);

  /// Blocks of a stratum by (row, column) that were built at least once.
  using Map = std::map<std::pair<int, int>, PlantBlock>;
  [[nodiscard]] const Map& blocks(Stratum stratum) const { return blocks_[std::size_t(stratum)]; }
  /// Metres from the eye of the last build within which every block of a stratum was built at least once.
  [[nodiscard]] float whole_to(Stratum stratum) const { return whole_to_[std::size_t(stratum)]; }
  [[nodiscard]] std::size_t bytes() const;
  /// Where the plants of the snapshot stand.
  [[nodiscard]] const PlantPlacement& placement() const { return placement_; }

 private:
  [[nodiscard]] std::vector<std::pair<int, int>> missing(Stratum stratum, double x, double y, float reach) const;
  void fill(Stratum stratum, std::pair<int, int> place, PlantBlock& block, std::uint32_t version) const;
  /// Builds blocks on all threads.
  void fill_all(Stratum stratum, std::span<const std::pair<int, int>> places);
  void mark_changed(const MapsSnapshot& before, const GroundLines* lines_before);
  /// Makes the blocks stale that meet a tile of the terrain that is marked.
  void mark(const Grid<std::uint8_t>& tiles);
  /// Takes over what is eaten of a snapshot whose animals are known. True when herbs must be placed anew.
  bool follow_grazing(const MapsSnapshot* before);
  void drop_far(Stratum stratum, double x, double y, float reach);

  PlantPlacement placement_;
  std::shared_ptr<const MapsSnapshot> snapshot_;
  std::shared_ptr<const GroundLines> lines_;
  std::shared_ptr<const Grazing> grazing_;
  std::array<Map, strata> blocks_;
  std::uint32_t versions_ = 0;
  std::array<float, strata> whole_to_{};
};

}  // namespace biotope
