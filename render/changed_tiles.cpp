#include "render/changed_tiles.hpp"

namespace biotope {

Grid<std::uint8_t> changed_cover(const MapsSnapshot& now, const MapsSnapshot& then) {
  const Grid<float>& height = now.terrain().height;
  Grid<std::uint8_t> changed((height.width() + tile_side - 1) / tile_side, (height.height() + tile_side - 1) / tile_side, 0);
  for (std::size_t i = 0; i < now.cover.size(); ++i) {
    const auto& a = now.cover[i];
    const auto& b = then.cover[i];
    if (a == b) continue;
    const bool both = a && b && a->tile_count() == changed.size() && b->tile_count() == changed.size();
    for (std::size_t tile = 0; tile < changed.size(); ++tile) {
      if (!both || a->tile(tile) != b->tile(tile)) changed[tile] = 1;
    }
  }
  return changed;
}

}  // namespace biotope
