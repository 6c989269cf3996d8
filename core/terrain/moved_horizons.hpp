#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "core/terrain/tile_set.hpp"

namespace biotope {

/// Tangents of horizons: all that lie between two, none at first.
struct TangentRange {
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -std::numeric_limits<float>::infinity();

  [[nodiscard]] bool any() const { return lowest <= highest; }
  void add(float tangent) {
    lowest = std::min(lowest, tangent);
    highest = std::max(highest, tangent);
  }
  void add(const TangentRange& other) {
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
  }
};

/// By azimuth sector and small tile: what the horizons were that a tile's light was made of and that are others now. A horizon
/// that rises or falls where no sun stands, or far below it, changes no light.
class MovedHorizons {
 public:
  MovedHorizons() = default;
  /// None, over a terrain of this size.
  MovedHorizons(int width, int height, std::size_t sectors)
      : tiles_(width, height, small_side), sectors_(sectors, std::vector<TangentRange>(tiles_.tile_count())) {}

  /// The horizon that some cells read was `tangent`. Different sectors may be noted by different threads.
  void note(std::size_t sector, const Rect& cells, float tangent) {
    tiles_.each_touched(cells, [&](std::size_t tile) { sectors_[sector][tile].add(tangent); });
  }
  [[nodiscard]] const TangentRange& before(std::size_t sector, std::size_t tile) const { return sectors_[sector][tile]; }
  /// Tiles with a horizon that is another.
  [[nodiscard]] TileSet tiles() const {
    TileSet moved = tiles_;
    for (const auto& sector : sectors_) {
      for (std::size_t tile = 0; tile < sector.size(); ++tile) {
        if (sector[tile].any()) moved.insert(tile);
      }
    }
    return moved;
  }
  /// Light of a tile was made anew.
  void forget(std::size_t tile) {
    for (auto& sector : sectors_) sector[tile] = {};
  }

 private:
  TileSet tiles_;
  std::vector<std::vector<TangentRange>> sectors_;
};

}  // namespace biotope
