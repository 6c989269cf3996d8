#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/plant_arena.hpp"
#include "render/plant_blocks.hpp"

namespace biotope {

/// A block of trees or shrubs that is there, with what every frame asks of it side by side.
struct WoodyBlock {
  int row = 0;
  int column = 0;
  /// Lowest and highest foot, m.
  float low = 0;
  float high = 0;
  std::uint32_t plants = 0;
  std::uint32_t version = 0;
  /// What of it lies on the graphics side; nothing while it waits for its upload.
  bool resident = false;
  PlantArena::Resident there;
  const PlantBlock* block = nullptr;
};

/// The woody blocks in rows, in the order of their places: made anew when blocks have changed, and otherwise only read, for
/// thousands of them are looked over many times a frame.
class WoodyBlocks {
 public:
  /// Call when blocks or arena may have changed, and before they are read.
  void follow(const PlantBlocks& blocks, const PlantArena& arena);
  [[nodiscard]] std::span<const WoodyBlock> of(Stratum stratum) const { return lists_[std::size_t(stratum)].blocks; }

 private:
  struct List {
    std::vector<WoodyBlock> blocks;
    std::uint64_t of_blocks = 0;
    std::uint64_t of_arena = 0;
  };
  std::array<List, strata> lists_;
};

}  // namespace biotope
