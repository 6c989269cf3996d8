#pragma once

#include <cstdint>
#include <vector>

#include "core/base/grid.hpp"
#include "core/terrain/tile_set.hpp"

namespace biotope {

/// The lowest place where water passes between two watersheds, each named by its tile of the flood and its number there.
struct WatershedPass {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  float level = 0;
};

/// Depressions of a ground that changes here and there (see fill_depressions): tiles are flooded on their own and joined by the
/// graph of their watersheds (after Barnes 2016), so a change floods its own tiles again and then the graph.
class DepressionField {
 public:
  /// Everything anew; returns the filled heights.
  [[nodiscard]] Grid<float> restart(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level,
                                    const Grid<std::uint8_t>& inlets);
  /// Follows the ground after heights or the sea changed in some tiles: `filled` holds the filled heights of before and gets
  /// those of now; returns the tiles in which they differ.
  [[nodiscard]] TileSet update(const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level,
                               const Grid<std::uint8_t>& inlets, const TileSet& changed, Grid<float>& filled);

 private:
  struct Tile {
    std::vector<WatershedPass> inside;
    /// Passes to the tiles east and south of it, and over the map's border.
    std::vector<WatershedPass> beside;
    std::uint32_t watersheds = 0;
    /// Level of the water in each watershed.
    std::vector<float> levels;
  };

  [[nodiscard]] Rect rect(std::size_t tile) const;
  void flood(std::size_t tile, const Grid<float>& height, const Grid<std::uint8_t>& sea, float sea_level);
  void join(std::size_t tile, const Grid<std::uint8_t>& inlets);
  /// Finds the levels of all watersheds; returns the tiles in which one is another.
  [[nodiscard]] std::vector<char> spill();
  /// Fills cells of one tile to their watersheds' levels; whether one was another before.
  bool raise(const Rect& cells, Grid<float>& filled) const;

  int columns_ = 0;
  std::vector<Tile> tiles_;
  /// Heights filled as if water left at the rim of every tile, and the watershed of each cell.
  Grid<float> within_;
  Grid<std::uint16_t> labels_;
};

}  // namespace biotope
